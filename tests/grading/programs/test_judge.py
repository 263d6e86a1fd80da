"""What programs are called with."""

from __future__ import annotations

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.answers.verdict import Mistaken, Right
from corollary.derive.statements import Code
from corollary.formula.value import Items, Real
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge_programs import asks, inputs_of, judge_code
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.variant import chapter
from corollary.sandbox.job import CallResult

BANK = chapter_bank()
PROGRAMS = [
    (problem.code, part.id)
    for problem in PROBLEMS
    for part in problem.parts
    if part.function and not part.signature.endswith("()")
]


def test_programs_are_called_with_numbers_of_the_ranges_that_are_drawn_from():
    """Each student has others, the same each time."""
    solution = Solutions(chapter_bank()).of(chapter_bank()["P12.15"])
    part = solution.problem.part("j")
    code = next(each for each in solution.entries if isinstance(each, Code) and each.statement.part == "j")
    variant = chapter(solution.problem)
    drawn = [inputs_of(code, variant, part, b"key", student) for student in ("ada", "cy", "ada")]
    assert drawn[0] == drawn[2] != drawn[1]
    for case in (*drawn[0], *drawn[1]):
        assert 0.5 <= case["m"] <= 4
        assert 40 <= case["k"] <= 300
        assert 0.8 <= case["b"] <= 1.6


@pytest.mark.whole
@pytest.mark.parametrize(("code", "part"), PROGRAMS, ids=[" ".join(each) for each in PROGRAMS])
@pytest.mark.parametrize("constant", [0.0, 1.0, 10.0])
def test_a_program_that_returns_constants_is_no_usual_mistake(code, part, constant):
    """However many of them it returns, and as many as there are balls, too."""
    solution = Solutions(BANK).of(BANK[code])
    variant, asked = chapter(solution.problem), solution.problem.part(part)
    calls = asks(solution, variant, asked, b"key", "ada")
    assert len(calls) > 1
    for length in range(1, 9):
        returned = {
            call.key: CallResult(_numbers(constant, int(dict(call.arguments).get("N", length))), "", "")
            for call in calls
        }
        verdict = judge_code(solution, variant, asked, ProgramRun(returned, ran=True), b"key", "ada")
        assert not isinstance(verdict, (Right, Mistaken)), verdict


def _numbers(constant: float, length: int) -> Items:
    return Items((Real(constant),) * length, (length,))
