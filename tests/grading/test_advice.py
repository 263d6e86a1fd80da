"""Feedback to a wrong answer: it says something to think about, and nothing of the key: no value, no formula, no factor."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace

import pytest

from corollary.answers.verdict import Mistaken, Slip, Wrong
from corollary.formula.text import text
from corollary.grading.advice import advice
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import draws
from corollary.problem.variant import chapter

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)
SOURCE = re.compile(
    r"\((?:section |example )?12\.[\d.]*\d\)?(?:-\(?12\.\d+\))?"
)  # numbers of the chapter's equations
NUMBER = re.compile(r"\d+(?:[.,]\d+)?(?:e[+-]?\d+)?")
FACTORS = re.compile(r"\b(twice too|half as|double|factor (of )?\d|times too|\d+ times|√2|3\.6)\b")
WRONG = (1.37, 0.61, 7.3, -3.3)
OFF = (-1.0, 2.0, 0.5, 10.0, 0.1, 1000.0, 0.001, 3.6)


def key_of(code: str) -> Key:
    problem = find(BANK, code)
    for student in range(20):
        try:
            return make_key(SOLUTIONS.of(problem), next(draws(problem, b"advice", str(student))))
        except ArithmeticError:
            continue
    raise AssertionError(code)


def feedback(key: Key, answers: dict[str, object]) -> Iterator[tuple[str, object, str]]:
    judged = judge(key, {part: from_json(value) for part, value in answers.items()})
    for part in grade(key, judged).parts:
        if part.part.id in answers:
            yield part.part.id, part.verdict, part.feedback


def bent(key: Key, factor: float) -> dict[str, object]:
    """Every number of the key, taken so many times."""
    found: dict[str, object] = {}
    for part in key.variant.problem.parts:
        if part.id in key.truths and "expression" not in part.answer_types:
            values = [factor * value / part.unit.si for value in key.truths[part.id].values]
            found[part.id] = values if len(values) > 1 else values[0]
    return found


def leaks(key: Key, part: str, said: str, answer: object) -> list[str]:
    """What the key holds and the text says."""
    words = SOURCE.sub("", said)
    for given in key.variant.problem.givens:
        words = words.replace(given.meaning, "")
    own = answer if isinstance(answer, list) else [answer]
    unit = key.variant.problem.part(part).unit.si
    values = [value / size for value in key.truths[part].values if value for size in (1.0, unit)]
    numbers = [float(each.replace(",", ".")) for each in NUMBER.findall(words)]
    given = [abs(value / size) for value in key.variant.si.values() for size in (1.0, 1e-3, 1e3)]
    shown = [
        f"{number}"
        for number in numbers
        if any(math.isclose(number, abs(value), rel_tol=0.02) for value in values)
        and not any(math.isclose(number, abs(each), rel_tol=1e-3) for each in own if isinstance(each, float))
        and not any(math.isclose(number, each, rel_tol=1e-9) for each in given)
    ]
    find = key.solution.answer(part)
    trees = [*getattr(find.local, "trees", ()), *(find.in_givens or ())] if find is not None else []
    formulas = [formula for tree in trees if len(formula := text(tree)) > 3 and formula in words]
    return [*shown, *formulas, *(found[0] for found in FACTORS.finditer(words)), *re.findall(r"[=$]", words)]


@pytest.mark.parametrize("code", [problem.code for problem in BANK if problem.givens])
def test_nothing_of_the_key_is_told_to_a_wrong_answer(code):
    key = key_of(code)
    for factor in WRONG + OFF:
        answers = bent(key, factor)
        for part, verdict, said in feedback(key, answers):
            if isinstance(verdict, Wrong | Slip):
                assert not leaks(key, part, said, answers[part]), (part, said)
            if isinstance(verdict, Wrong):
                assert "A check: " in said


@pytest.mark.parametrize(
    ("code", "part", "answer", "words"),
    [
        (
            "X12.5",
            "d",
            77.7,
            ("Mean force", "the speed of the incoming ball", "the time of contact", "A check"),
        ),
        ("X12.10", "a", 12.345, ("Conservation of momentum", "Newton's second law", "the sliding distance")),
        (
            "X12.8",
            "b",
            0.77,
            ("Conservation of momentum", "your mass without the snowball", "your answer in (a)"),
        ),
        (
            "X12.1",
            "b",
            3.33,
            ("Conservation of mechanical energy", "larger or smaller than the speed of the club"),
        ),
        ("P12.14", "i", [0.1, 0.2, 0.3], ("halve the step",)),
        ("X12.1", "a", "v/7", ("the speed of the club",)),
    ],
)
def test_it_names_the_laws_the_quantities_and_a_check(code, part, answer, words):
    problem = find(BANK, code)
    ((_, verdict, said),) = feedback(make_key(SOLUTIONS.of(problem), chapter(problem)), {part: answer})
    assert isinstance(verdict, Wrong)
    for word in words:
        assert word in said
    assert "the your" not in said


def test_a_wrong_choice_is_told_what_to_ask_of_each_option():
    key = key_of("X12.9")
    options = {option.letter for option in key.variant.problem.part("a").options} - {key.choices["a"]}
    for letter in options:
        ((_, verdict, said),) = feedback(key, {"a": letter})
        assert isinstance(verdict, Wrong | Mistaken)
        assert len(said.split()) > 6


def test_an_angle_answered_in_degrees_is_told_in_degrees():
    key = key_of("E12.3.2")
    degrees = f"{math.degrees(key.truths['c3'].values[0]):.4g}"[:4]
    for answer, sign in (("7 deg", "°"), ("7°", "°"), (3.1, "rad")):
        judged = judge(key, {"c3": from_json(answer)})
        said = next(part.feedback for part in grade(key, judged, reveal=True).parts if part.part.id == "c3")
        assert said.endswith(f"{sign}."), said
        assert (degrees in said) == (sign == "°"), said


def test_advice_names_no_answer_that_a_set_leaves_out():
    key = key_of("X12.8")
    (part,) = (each for each in key.variant.problem.parts if each.id == "c")
    assert "your answer in (b)" in advice(key, part)
    problem = replace(key.variant.problem, parts=(part,), written=key.variant.problem)
    alone = advice(replace(key, variant=replace(key.variant, problem=problem)), part)
    assert "your answer" not in alone
    assert "mass of the snowball" in alone
