"""Formulas worked out by hand: each number in the comments is written down with three figures before the next is worked out."""

from __future__ import annotations

import math

import pytest

from corollary.formula.rounded import by_operations
from corollary.formula.syntax import author_formula


def three_figures(x: float) -> float:
    return float(f"{x:.2e}")


def worked(formula: str, **letters: float) -> float:
    tree = author_formula(formula, list(letters))
    step = by_operations(tree, {name: place for place, name in enumerate(letters)}, three_figures)
    return step(list(letters.values()))


@pytest.mark.parametrize(
    ("formula", "letters", "by_hand"),
    [
        ("m*v", {"m": 1.237, "v": 2.0}, 1.237 * 2.0),  # the last operation is not rounded, nor are letters
        ("a*b - c*d", {"a": 3.33, "b": 3.33, "c": 3.31, "d": 3.35}, 0.0),  # 11.0889, 11.0885: 11.1 - 11.1
        ("-(a*b)", {"a": 3.33, "b": 3.33}, -11.0889),
        ("c - a*b", {"a": 3.33, "b": 3.33, "c": 11.0889}, 11.0889 - 11.1),
        ("v*ln(a/b)", {"v": 3600, "a": 2350, "b": 1410}, 3600 * 0.513),  # 1.67; 0.513
        ("a/exp(d/v)", {"a": 1280, "d": 4300, "v": 1750}, 1280 / 11.7),  # 2.46; 11.7
        ("sqrt(2*g*h)", {"g": 9.81, "h": 0.7}, math.sqrt(13.7)),  # 13.734
        ("(a + b)^2", {"a": 1.234, "b": 0.002}, 1.24**2),  # 1.236
        ("a^(b*c)", {"a": 2.0, "b": 1.111, "c": 1.111}, 2.0**1.23),  # 1.2343
        ("a*sqrt(2)*pi", {"a": 1.0}, math.sqrt(2) * math.pi),  # what has no letter is exact
    ],
)
def test_what_is_written_down_is_rounded(formula, letters, by_hand):
    assert worked(formula, **letters) == pytest.approx(by_hand, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("formula", ["1/(a - a)", "sqrt(0*a - 1)", "exp(1000*a)"])
def test_what_has_no_value_raises(formula):
    with pytest.raises((ValueError, ZeroDivisionError, OverflowError)):
        worked(formula, a=1.0)


def test_a_comparison_is_no_number():
    with pytest.raises(ValueError, match="comparison"):
        by_operations(author_formula("a < b", ["a", "b"]), {"a": 0, "b": 1}, three_figures)
