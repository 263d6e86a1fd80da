"""Programs marked by what their calls returned: all calls of a part together, and what halving the step showed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from itertools import count

import pytest
from tests.judges import judges

from corollary.answers.verdict import Mistaken, Right, Unread, Wrong
from corollary.derive.solution import Solution
from corollary.formula.value import Items, Nothing, Real
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge_programs import asks, judge_code
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.messages import language
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.job import CallResult

ARGUMENTS, reference = judges("impulse/ball_on_the_floor_program/judge_bounce.py", "ARGUMENTS reference")

BANK = chapter_bank()
PROBLEM = find(BANK, "E12.3.1s")
VARIANT, PART = chapter(PROBLEM), PROBLEM.part("g")
SECRET = b"course"


@cache
def solution() -> Solution:
    return Solutions(BANK).of(PROBLEM)


def exact(inputs: dict) -> Sequence[float]:
    truth = reference(*(inputs[name] for name in ARGUMENTS))
    return truth.velocity, truth.force, truth.duration


def verdict(program: Callable[[dict], Sequence[float]], student: str = "ada"):
    shown = {}
    for ask in asks(solution(), VARIANT, PART, SECRET, student):
        returned = program(dict(ask.arguments))
        shown[ask.key] = CallResult(
            Items(tuple(map(Real, returned)), (len(returned),)) if returned else Nothing(), "", ""
        )
    return judge_code(solution(), VARIANT, PART, ProgramRun(shown, (), True), SECRET, student)


def test_each_case_is_asked_with_its_step_and_with_half_of_it():
    inputs = [dict(ask.arguments) for ask in asks(solution(), VARIANT, PART, SECRET, "ada")]
    for coarse, fine in zip(inputs[::2], inputs[1::2], strict=True):
        assert fine == coarse | {"dt": coarse["dt"] / 2}
        assert exact(coarse)[2] / coarse["dt"] == pytest.approx(100)
    assert inputs != [dict(ask.arguments) for ask in asks(solution(), VARIANT, PART, SECRET, "bob")]


def test_what_is_right_is_right_and_the_remark_is_what_the_student_reads():
    found = verdict(exact)
    assert isinstance(found, Right)
    assert "Halving `dt` changes nothing" in sentence(found)


def test_a_usual_mistake_is_a_mistake_and_another_one_is_wrong():
    assert isinstance(
        verdict(
            lambda inputs: (exact(inputs)[0], exact(inputs)[1] + inputs["m"] * inputs["g"], exact(inputs)[2])
        ),
        Mistaken,
    )
    assert isinstance(verdict(lambda inputs: (1.3 * exact(inputs)[0], *exact(inputs)[1:])), Wrong)


@pytest.mark.parametrize(
    ("code", "said"),
    [
        (
            "de",
            "Geschwindigkeit und Zeit stimmen, aber die Kraft ist die des Bodens; die resultierende Kraft ist um das Gewicht kleiner.",
        ),
        ("nb", "Fart og tid er riktige, men kraften er den fra gulvet; resultantkraften er mindre, med et beløp lik tyngden."),
    ],
)  # fmt: skip
def test_a_judge_of_a_bank_speaks_the_language_of_the_course(code, said):
    """Its sentences are translated in the bank, the machine's own in the machine."""
    with language(code):
        net = verdict(
            lambda inputs: (exact(inputs)[0], exact(inputs)[1] + inputs["m"] * inputs["g"], exact(inputs)[2])
        )
        few = verdict(lambda inputs: (1.0,))
    assert sentence(net) == said
    assert "three: the velocity" not in sentence(few)
    assert "It returns one number" not in sentence(few)


def test_one_call_that_fails_decides():
    calls = count()
    assert isinstance(verdict(lambda inputs: exact(inputs) if next(calls) != 3 else ()), Unread)
    assert isinstance(judge_code(solution(), VARIANT, PART, ProgramRun({}, (), True), SECRET, "ada"), Unread)
