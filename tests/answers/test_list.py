"""Lists in any order: how many there are is part of the answer."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.answer import Blank, Formulas, Numbers, Unclear
from corollary.answers.evaluation import as_exact
from corollary.answers.expected import Expected, Quantity
from corollary.answers.in_any_order import judge_in_any_order
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type, judging
from corollary.answers.verdict import Right, Wrong
from corollary.formula.syntax import author_formula
from corollary.formula.value import Items, Nothing, Real, Text
from corollary.grading.points import share
from corollary.problem.problem_set import Scheme
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
PART = replace(PROBLEM.part("a"), answer_types=("list",), components=("up", "down"), unit=unit("s"))
QUESTION = question_of(PROBLEM, PART)


def items(*each):
    return Items(tuple(Text(one) if isinstance(one, str) else Real(one) for one in each), (len(each),))


def read(typed):
    return answer_type("list").read(typed if not isinstance(typed, str) else Text(typed), QUESTION)


@pytest.mark.parametrize(
    "text", ["8.0 and 6.32 1/s", "8.0; 6.32/s", "8.0, 6.32 1/s", "6.32 s^-1 and 8.0 s^-1", "8 1/s, 6.32 1/s"]
)
def test_a_unit_with_a_slash_behind_the_last_belongs_to_all(text):
    found = answer_type("list").read(Text(text), replace(QUESTION, unit=unit("1/s")))
    assert isinstance(found, Numbers), found
    assert sorted(found.values) == pytest.approx([6.32, 8.0])
    assert not found.misfit


def judged(typed, truth=(0.4, 2.1)):
    wanted = Quantity(truth, 2.14, 0.01, (0.0,) * len(truth), dict, None, dict, list, list, list)
    question = replace(QUESTION, components=tuple(map(str, truth)))
    return judging("list").judge(read(typed), Expected(question, quantity=wanted))


@pytest.mark.parametrize(
    ("typed", "values"),
    [
        (items("0.4 s", "2.1 s"), [0.4, 2.1]),
        ("2.1 s and 0.4 s", [2.1, 0.4]),
        ("2,1 s; 0,4 s", [2.1, 0.4]),
        ("2,1 s und 0,4 s", [2.1, 0.4]),
        ("2,1 s, 3,5 s og 0,4 s", [2.1, 3.5, 0.4]),
        ("400 ms, 2.1 s", [0.4, 2.1]),
        ("0.4 s", [0.4]),
        (Real(0.4), [0.4]),
        (items(0.4, 2.1, 3.0), [0.4, 2.1, 3.0]),
        ("0.4 s; 2.1 s; 3 s", [0.4, 2.1, 3.0]),
        ("[2. 5.]", [2.0, 5.0]),
    ],
)
def test_any_number_of_values_is_read(typed, values):
    found = read(typed)
    assert isinstance(found, Numbers), found
    assert list(found.values) == pytest.approx(values)


def test_the_blank_says_that_the_order_is_free():
    blank = answer_type("list").blank(QUESTION)
    assert blank == f"{QUESTION.name} = []   # all of them, in any order: numbers, or texts with a unit"


def test_what_is_no_list():
    assert isinstance(read(Nothing()), Blank)
    assert isinstance(read(items()), Blank)
    assert isinstance(read("soon"), Unclear)
    assert isinstance(read(items("0.4 s", "soon")), Unclear)


def test_missing_and_superfluous_values_are_said():
    assert judged("2.10 s, 0.400 s") == Right()
    assert judged("0.400 s").why == "What you give is right, but it is not all."
    assert "there are others" in judged("0.400 s; 2.10 s; 3.00 s").why
    assert judged("0.400 s; 2.50 s").why == "1 of your 2 values are right."


@pytest.mark.parametrize(
    ("typed", "earned"),
    [
        ("2.10 s; 0.400 s; 7.00 s; 9.00 s", 1.0),
        ("0.400 s; 2.10 s; 7.00 s", 0.75),  # one is missing
        ("9.00 s", 0.25),
        ("0.400 s; 2.10 s; 7.00 s; 8.00 s", 0.75),  # one is wrong
        ("1.00 s; 2.10 s; 7.50 s; 8.00 s", 0.25),
        ("0.400 s; 2.10 s; 7.00 s; 9.00 s; 3.00 s", 0.75),  # one too many
        ("0.400 s; 2.10 s; 7.00 s; 9.00 s; 1 s; 2 s; 3 s; 4 s", 0.0),  # all that may be
        ("0.400 s; 0.400 s; 0.400 s; 0.400 s", 0.25),  # one value is one value
        ("1.00 s; 3.00 s", 0.0),
        ("1 s; 3 s; 4 s; 5 s", 0.0),
    ],
)
def test_each_right_value_counts_and_each_one_too_many_takes_one_away(typed, earned):
    assert share(judged(typed, (0.4, 2.1, 7.0, 9.0)), Scheme(), "list") == pytest.approx(earned)


@pytest.mark.parametrize(
    ("typed", "earned"), [(("h", "v*t"), 0.5), (("h", "2*v*t", "g*t^2", "2*h"), 0.75), (("3*h",), 0.0)]
)
def test_of_formulas_each_right_one_counts(typed, earned):
    question = replace(QUESTION, components=tuple("ABCD"), unit=unit("m"))
    wanted = Quantity(
        (6.0, 90.0, 1.5, 3.0), 90.3, 0.01, (0.0,) * 4, lambda: GIVEN, FORMULAS, dict, list, list, list,
    )  # fmt: skip
    answer = Formulas(tuple(map(author_formula, typed)), "")
    found = judging("list").judge(answer, Expected(question, quantity=wanted))
    assert share(found, Scheme(), "list") == pytest.approx(earned)


def test_a_value_given_twice_counts_once():
    assert isinstance(judged("0.400 s; 0.400 s"), Wrong)


@given(st.lists(st.integers(1, 60), min_size=2, max_size=4, unique=True))
def test_the_order_says_nothing(values):
    truth = tuple(value / 4 for value in values)
    scale = sum(x * x for x in truth) ** 0.5
    question = replace(QUESTION, components=tuple(map(str, values)))
    wanted = Quantity(truth, scale, 0.001, (0.0,) * len(truth), dict, None, dict, list, list, list)
    verdicts = {
        judging("list").judge(
            answer_type("list").read(items(*order), question), Expected(question, quantity=wanted)
        )
        for order in permutations(truth)
    }
    assert verdicts == {Right()}


FORMULAS = tuple(map(author_formula, ("v*t", "g*t^2", "h", "2*h")))
GIVEN = {name: as_exact(value) for name, value in {"v": 2.0, "t": 3.0, "g": 10.0, "h": 1.5}.items()}


@pytest.mark.parametrize("order", [(0, 1, 2, 3), (3, 2, 1, 0), (2, 0, 3, 1)])
def test_four_formulas_are_right_in_any_order(order):
    question = replace(QUESTION, components=tuple("ABCD"), unit=unit("m"))
    wanted = Quantity(
        (6.0, 90.0, 1.5, 3.0), 90.3, 0.01, (0.0,) * 4, lambda: GIVEN, FORMULAS, dict, list, list, list,
    )  # fmt: skip
    typed = Formulas(tuple(FORMULAS[place] for place in order), "")
    assert isinstance(judge_in_any_order(typed, wanted, question), Right)
    off = Formulas((*typed.trees[:3], author_formula("3*h")), "")
    assert isinstance(judge_in_any_order(off, wanted, question), Wrong)


def test_numbers_that_nothing_parts_are_not_counted():
    """`2 5 s` may be two or a slip for 25, however many are asked for: nothing is held against the student."""
    assert isinstance(read("2 5 s"), Unclear)
    assert isinstance(read(items("2 5 s")), Unclear)
    assert isinstance(read(items("2 5 s", "7 s")), Unclear)
    three = question_of(PROBLEM, replace(PART, components=("up", "across", "down")))
    assert isinstance(answer_type("list").read(Text("2 5 s"), three), Unclear)
    two = answer_type("list").read(Text("2 and 5 s"), three)
    assert isinstance(two, Numbers)
    assert two.values == (2.0, 5.0)
