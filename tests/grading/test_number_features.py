"""What is known of the numbers drawn, by hand for one kick."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import pytest

from corollary.grading.number_features import number_features
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.variant import Variant


def test_a_kick_has_its_figures_size_and_sign():
    """m = 0.430 kg, v = 20.5 m/s: p = 8.815 kg m/s, of two and three figures."""
    bank = chapter_bank()
    problem = next(each for each in bank if each.code == "X12.5")
    values = {"m": Fraction("0.430"), "v": Fraction("20.5"), "w": Fraction(20), "dt": Fraction("0.10")}
    found = number_features(Solutions(bank).key(Variant(problem, values, None)))
    assert found["a"]["figures"] == 2 + 3
    assert found["a"]["size"] == pytest.approx(math.log10(8.815))
    assert found["a"]["negative"] == 0
    problem = replace(
        problem, parts=problem.parts[:1], written=problem
    )  # as a set asks it that leaves parts out
    assert number_features(Solutions(bank).key(Variant(problem, values, None))) == {"a": found["a"]}
    assert all(-9 <= part["cancellation"] < 0 for part in found.values())
