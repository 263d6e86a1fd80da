"""Errors of a collection made by hand: nearly all of them are followed, and one constant typed everywhere earns next to nothing."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import open_bank

from .test_students import by_path

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))  # the two look for one another there
carried = by_path(BENCHMARKS / "carried.py")
constants = by_path(BENCHMARKS / "constants.py")
NAMED = """X12.8 | b = -m*v/M
X12.7 | b = [0, -m*v0*sin(theta)]
E12.3.2 | c1 = [m*(w*cos(alpha) - v0), m*w*sin(alpha)] | c3
E12.3.2 | c2 = [m*(w*cos(alpha) - 1.5*v0)/dt, m*w*sin(alpha)/dt]
P12.15 | c = -1.2
P12.15 | d = -1.2
P12.15 | e = sqrt(2*k*d**2/m)
P12.14 | f1 = [-v0/3
X12.3 | c = 4*m*v0**2 | e = -c
X12.3 | d = m*v0**2/2 | e = -d
X12.13 | b = 1.2*(m*g*L/2 + m*v0**2) | c = (b
E12.5.1 | a = mB/mA*sqrt(g*h)
E12.7.1 | b = 1.25*R*v**2 | d = b/2""".splitlines()


@pytest.mark.whole
def test_a_formula_of_the_collection_gives_what_is_true_for_right_answers():
    """But for the spring of E12.3.1s, which is worked out without its weight, to half a per cent."""
    cases = carried.collection()
    assert len(cases) > 200
    for code, (key,) in carried.keys(Solutions(open_bank(None)), [case.code for case in cases], 1).items():
        for case in (case for case in cases if case.code == code):
            letters = dict(key.variant.si)
            for part, _formula in case.bent:
                letters |= carried.named(part, key.truths[part].values, letters)
            truth = key.truths[case.later[0]]
            off = math.dist(carried.value(case.later[1], letters), truth.values) / truth.scale
            assert off < (6e-3 if code == "E12.3.1s" else 1e-9), case.text


@pytest.mark.whole
@pytest.mark.parametrize("start", NAMED)
def test_an_error_that_was_missed_is_followed(start):
    (case,) = [case for case in carried.collection() if case.text.startswith(start)]
    found = carried.measure([case], 2, 4)
    assert found["tries"] >= 2
    assert found["follow_percent"] == 100, found


@pytest.mark.whole
@pytest.mark.parametrize("figures", [3, 4])
def test_nearly_all_carried_errors_are_followed(figures):
    assert carried.measure(carried.collection(), 3, figures)["follow_percent"] >= 97


@pytest.mark.whole
def test_a_constant_in_every_part_earns_next_to_nothing():
    """One coincidence in four variants may be more: where there is one, more variants are looked at.

    The same with twelve and 48 variants is benchmarks/results/constants.md.
    """
    found = constants.measure(4, [])
    assert max(found["constants"].values()) < 0.5
    more = [code for code, shares in found["problems"].items() if max(shares.values()) >= 2]
    assert len(more) < 6, more
    if more:
        assert constants.measure(24, more)["worst"] < 2
