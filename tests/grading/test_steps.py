"""Whole numbers by floor, ceil and round: certified, exact, and never dealt where rounding would decide them."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.answers.verdict import Mistaken, Right, Wrong
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.formula.syntax import author_formula
from corollary.grading.assign import admitted
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chosen
from corollary.verify.obligations.settle import settled

PROBLEM = """\
---
code: T9
title: Steps
given:
  d: {is: distance of the slits, value: 2, from: 1.6, to: 4, step: 0.01, unit: um}
  lam: {is: wavelength, value: 600, from: 400, to: 700, step: 1, unit: nm}
  n: {is: number of people, value: 7, from: 2, to: 20, step: 1}
  u: {is: time of each, value: 1, unit: min}
require:
  - d > 0
  - lam > 0
  - n > 0
---
A grating of {{d}} in light of {{lam}}, and {{n}} people who speak for {{u}} each.

## Orders {#a .integer points=1}
How many orders are there on one side?

## Cars {#b .integer points=1}
How many cars of four seats do they need?

## Nearest {#c .integer points=1}
Which whole number is nearest to the quotient?

## Time {#d .integer unit="min" points=1}
How many minutes do they speak, one each?
"""
SOLUTION = """\
## (a) m

The sine of an angle is 1 at most.

- law: Grating, `m = floor(d/lam)`
- mistake: Orders are whole. `m = d/lam`
- mistake: Rounded up. `m = ceil(d/lam)`

## (b) cars

Four fit.

- law: Cars, `cars = ceil(n/4)`

## (c) c

To the nearest.

- law: Nearest, `c = round(d/lam)`

## (d) T

A minute each.

- law: Time, `T = n*u`
"""


@pytest.mark.parametrize(
    ("formula", "value", "whole"),
    [
        ("floor(x)", "7/2", 3),
        ("floor(x)", "-7/2", -4),
        ("ceil(x)", "7/2", 4),
        ("ceil(x)", "-7/2", -3),
        ("round(x)", "7/2", 4),
        ("round(x)", "17/5", 3),
        ("floor(x)", "3", 3),
        ("ceil(x)", "3", 3),
        ("floor(pi*x)", "1", 3),
        ("floor(sqrt(x))", "9", 3),
        ("floor(1e12*x)", "1/3", 333333333333),
        ("floor(x - 1e-30)", "3", 2),
    ],
)
def test_a_whole_number_is_certified(formula, value, whole):
    found = certified(author_formula(formula), {"x": RationalPi(Fraction(value))})
    assert (found.value, found.proven) == (whole, True)


@pytest.mark.parametrize(
    "formula", ["floor(sqrt(x)*sqrt(x))", "ceil(sin(x)^2 + cos(x)^2)", "round(sqrt(x)*sqrt(x) + 1/2)"]
)
def test_what_no_precision_tells_from_a_step_has_no_value(formula):
    with pytest.raises(Undefined, match="where it jumps"):
        certified(author_formula(formula), {"x": RationalPi(Fraction(2))})


@pytest.fixture(scope="module")
def grating(tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("steps")
    for place, text in (("problems/all/steps.md", PROBLEM), ("solutions/all/steps.md", SOLUTION)):
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_text(text, encoding="utf-8")
    bank, found = home(folder, "T9")
    return Solutions(bank).of(found)


def numbers(problem, **values):
    return chosen(problem, {name: Fraction(value) for name, value in values.items()})


@pytest.mark.parametrize(
    ("d", "lam", "n", "whole"),
    # d/lam: 3.33, 3.50.., 2.29, 9.88
    [("2", "600", "7", [3, 2, 3, 7]), ("1.6", "700", "8", [2, 2, 2, 8]), ("3.95", "400", "9", [9, 3, 10, 9])],
)
def test_the_key_has_the_whole_numbers(grating, d, lam, n, whole):
    key = make_key(grating, numbers(grating.problem, d=d, lam=lam, n=n))
    assert [key.truths[part].values[0] / (60 if part == "d" else 1) for part in "abcd"] == whole
    assert all(key.truths[part].proven and key.truths[part].counted for part in "abcd")


@pytest.mark.parametrize(("d", "lam"), [("1.8", "600"), ("1.81", "602"), ("1.8", "602"), ("2.1", "600")])
def test_numbers_near_a_step_are_not_dealt(grating, d, lam):
    """d/lam is 3, 3.007, 2.990, and 3.5, where round jumps."""
    assert "too near a step" in admitted(grating, numbers(grating.problem, d=d, lam=lam))[1]


def test_exact_quotients_of_whole_numbers_are_dealt(grating):
    key, why = admitted(grating, numbers(grating.problem, n="8"))
    assert (why, key is not None) == ("", True)


@pytest.mark.parametrize(
    ("typed", "verdict", "words"),
    [
        ("3", Right, ""),
        (3.0, Right, ""),
        ("5.0", Wrong, ""),
        ("floor(d/lam)", Right, ""),
        ("3.2", Wrong, "whole number"),
        ("d/lam", Mistaken, "Orders are whole"),
        ("3.333333333", Mistaken, "Orders are whole"),
        ("4", Mistaken, "Rounded up"),
        ("9", Wrong, ""),
    ],
)
def test_how_a_whole_number_is_judged(grating, typed, verdict, words):
    key = make_key(grating, numbers(grating.problem))
    found = judge(key, {"a": from_json(typed)})["a"][0][0]
    assert isinstance(found, verdict), found
    assert words in str(found)


@pytest.mark.parametrize(
    ("typed", "right"), [("7 min", True), ("420 s", True), ("7", True), ("7.5 min", False)]
)
def test_a_whole_number_may_have_a_unit(grating, typed, right):
    key = make_key(grating, numbers(grating.problem))
    assert isinstance(judge(key, {"d": from_json(typed)})["d"][0][0], Right) is right


def test_that_steps_are_met_is_said_and_never_called_proven(grating):
    outcomes = {each.claim: each.outcome for each in settled(grating, 20) if each.kind == "no step"}
    assert outcomes == {
        "d/lam is no step of floor": "sampled",
        "n/4 is no step of ceil": "sampled",
        "d/lam + 1/2 is no step of floor": "sampled",
    }
