"""Roots enclosed by intervals: what is known of a system beforehand is found, and nothing that is not there."""

from __future__ import annotations

import math
from fractions import Fraction
from unittest.mock import patch

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.audit import enclosed_roots
from corollary.audit.contractor import NoContractor
from corollary.formula.enclosure import Enclosure
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula

whole = st.integers(-40, 40)
sizes = st.sampled_from([Fraction(10) ** power for power in (-15, -3, 0, 4, 12)])


def solved(laws, where, unknowns, known, within=None):
    values = {name: RationalPi(Fraction(value)) for name, value in known.items()}
    return enclosed_roots.enclosed_roots(
        [author_formula(each) for each in laws],
        [author_formula(each) for each in where],
        unknowns,
        values,
        within,
    )


@given(a=whole, b=whole, size=sizes)
@settings(max_examples=60, deadline=None)
def test_the_roots_of_a_quadratic(a, b, size):
    """(x - a)(x - b) = 0: two roots, and both are enclosed; a double one is never called impossible."""
    low, high = sorted((a * size, b * size))
    with patch.object(
        enclosed_roots, "SECONDS", 0.1
    ):  # two roots take a tenth of it; a double one takes all that there is
        found = solved(["x^2 - (a + b)*x + a*b = 0"], [], ["x"], {"a": low, "b": high})
    assert not found.none
    if low != high and found.complete and not found.edge:
        roots = sorted(each["x"] for each in found.roots)
        assert len(roots) == 2
        slack = 1e-9 * float(high - low)
        assert roots[0].low - slack <= float(low) <= roots[0].high + slack
        assert roots[1].low - slack <= float(high) <= roots[1].high + slack


@given(degrees=st.integers(-355, 355).filter(lambda each: each % 90), length=st.integers(1, 50))
@settings(max_examples=60, deadline=None)
def test_polar_components(degrees, length):
    """A length and an angle are found again from the two components, in whichever quadrant."""
    angle = math.radians(degrees)
    known = {"x": length * math.cos(angle), "y": length * math.sin(angle)}
    found = solved(
        ["x = r*cos(b)", "y = r*sin(b)"], ["r > 0"], ["r", "b"], known, {"b": Enclosure(angle - 3, angle + 3)}
    )
    (root,) = found.roots
    assert found.complete
    assert math.isclose(root["r"].low, length, rel_tol=1e-9)
    assert math.isclose(root["b"].low, angle, rel_tol=1e-9)


@given(turns=st.integers(1, 12), share=st.floats(-0.99, 0.99))
@settings(max_examples=40, deadline=None)
def test_every_crossing_is_counted(turns, share):
    """sin(t) meets a height between -1 and 1 twice in each turn."""
    found = solved(
        ["s = sin(t)"], [], ["t"], {"s": share}, {"t": Enclosure(-0.5 * math.pi, (2 * turns - 0.5) * math.pi)}
    )
    assert found.complete
    assert len(found.roots) == 2 * turns
    assert all(each["t"].width < 1e-9 for each in found.roots)


@pytest.mark.parametrize(
    ("laws", "where", "known"),
    [
        (["x^2 = a"], [], {"a": -1}),
        (["sin(x) = a"], [], {"a": "1.001"}),
        (["sqrt(x) = a"], [], {"a": "-0.5"}),
        (["exp(x) = a"], [], {"a": -1}),
        (["abs(x) = a"], [], {"a": -2}),
        (["x^2 - a*x = 1"], ["x > 0", "x < 1"], {"a": 3}),
        (["x + exp(x) = a"], ["x > 1"], {"a": 2}),
    ],
)
def test_no_root_is_proven(laws, where, known):
    assert solved(laws, where, ["x"], known).none


@pytest.mark.parametrize(
    ("laws", "where"),
    [
        (["x^2 = 0"], []),  # a double root: neither enclosed nor denied
        (["x = 1"], ["x > 1"]),  # on the edge
        (["sin(x) = 1"], ["x > 0", "x < 3"]),
        (["(x - 1)^2*(x - 2)^2 = 0"], []),
    ],
)
def test_what_cannot_be_told_is_not_denied(laws, where):
    assert not solved(laws, where, ["x"], {}).none


def test_an_edge_that_belongs_to_the_region():
    assert len(solved(["x = 1"], ["x >= 1"], ["x"], {}).roots) == 1


@pytest.mark.parametrize("laws", [["x + y = 1"], ["x = 1", "x = 2"], ["gamma(x) = 2"]])
def test_what_has_no_contractor(laws):
    unknowns = ["x", "y"] if "y" in laws[0] else ["x"]
    with pytest.raises(NoContractor):
        solved(laws, [], unknowns, {})
