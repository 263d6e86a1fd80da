"""Conditions at many points at once, held against deciding them one by one."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.arithmetics import ready
from corollary.formula.ball import RationalPi, Undefined, certified, holds
from corollary.formula.syntax import author_formula
from corollary.problem.interval_filter import INTERVALS, GivenAtPoints, Interval, holding

DECIMALS = st.decimals(-20, 20, places=2).map(Fraction)
CONDITIONS = [
    "a + b > 0.3", "a*b - b*a = 0", "a - b - a + b != 0", "abs(a - b) >= 1.5", "a^2 <= b^2", "1/a > b", "sqrt(a) <= b", "sin(c) > a/20",
    "(a/2)^(5/2) < b", "min(a, b) >= max(a, b)", "a*cos(c) = b*cos(c)", "c > pi/4", "atan2(a, b) > 0", "a^-2 > 0.01",
]  # fmt: skip


@pytest.mark.whole
@pytest.mark.parametrize("text", CONDITIONS)
@given(rows=st.lists(st.tuples(DECIMALS, DECIMALS, st.integers(0, 36)), min_size=1, max_size=12))
def test_as_one_by_one(text, rows):
    """Ties among decimals and at the ends of functions are what doubles get wrong: 0.1 + 0.2 > 0.3."""
    rows = [
        *rows,
        (Fraction(1, 10), Fraction(1, 5), 9),
        (Fraction(0), Fraction(0), 0),
        (Fraction(9), Fraction(3), 18),
    ]
    relation = author_formula(text)
    letters = {
        "a": GivenAtPoints([RationalPi(a) for a, _, _ in rows], np.arange(len(rows))),
        "b": GivenAtPoints([RationalPi(b) for _, b, _ in rows], np.arange(len(rows))),
        "c": GivenAtPoints([RationalPi(Fraction(c, 36), 1) for _, _, c in rows], np.arange(len(rows))),
    }
    one_by_one = [
        _holds(relation, {name: letter.numbers[n] for name, letter in letters.items()})
        for n in range(len(rows))
    ]
    assert holding(relation, letters).tolist() == one_by_one


def _holds(relation, values) -> bool:
    try:
        return bool(holds(relation, values))
    except Undefined:
        return False


@pytest.mark.whole
@pytest.mark.parametrize(
    "text",
    ["a*b - b/3", "(a - b)^3", "sqrt(a) - sqrt(b)", "a/(b + 1/3)", "sin(a)*cos(b)", "(a*b)^(2/3)", "a^-2"],
)
@given(a=st.fractions("1/100", 100), b=st.fractions("1/100", 100))
def test_the_bound_holds_the_error(text, a, b):
    tree = author_formula(text)
    found = ready(tree, INTERVALS)({"a": Interval.of(a), "b": Interval.of(b)})
    value = certified(tree, {"a": RationalPi(a), "b": RationalPi(b)}).value
    assert abs(float(found.value) - value) <= found.radius
    assert found.radius < 1e-9 * (1 + a + b) ** 6  # and is of some use


def test_letters_are_broadcast():
    a = GivenAtPoints([RationalPi(Fraction(n)) for n in range(3)], np.arange(3).reshape(3, 1))
    b = GivenAtPoints([RationalPi(Fraction(n)) for n in range(4)], np.arange(4).reshape(1, 4))
    assert holding(author_formula("a < b"), {"a": a, "b": b}).tolist() == [
        [x < y for y in range(4)] for x in range(3)
    ]
    assert holding(author_formula("a < 2"), {"a": a, "b": b}).tolist() == [[True], [True], [False]]
