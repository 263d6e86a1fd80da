"""Laws solved together: every root, with angles as they are given."""

from __future__ import annotations

from fractions import Fraction
from math import cos, radians, sqrt, tan

import pytest

from corollary.derive.system import stated, system_roots
from corollary.formula.rational_pi import RationalPi


def roots(laws, unknowns, **givens):
    at = {
        name: value if isinstance(value, RationalPi) else RationalPi(Fraction(value))
        for name, value in givens.items()
    }
    named = [(f"law {place}", each) for place, each in enumerate(laws)]
    found = system_roots(stated(named, dict.fromkeys(givens, 1), unknowns), unknowns, at)
    return [root.at({}) for root in found]


def degrees(number):
    return RationalPi(Fraction(number, 180), 1)


def test_a_throw_at_an_angle_has_both_its_roots():
    found = roots(
        ["-h = v0*sin(theta)*t - g*t^2/2", "x = v0*cos(theta)*t"],
        ["v0", "t"],
        x=24,
        h=2,
        g=10,
        theta=degrees(38),
    )
    speed = 24 / cos(radians(38)) / sqrt((2 + 24 * tan(radians(38))) / 5)
    assert sorted(each["v0"] for each in found) == pytest.approx([-speed, speed], rel=1e-14)


def test_what_a_relation_of_angles_makes_true_is_no_contradiction():
    laws = stated(
        [("x", "vx = v*cos(theta)"), ("y", "vy = v*sin(theta)"), ("speed", "vx^2 + vy^2 = v^2")],
        {"v": 1, "theta": 1},
        ["vx", "vy"],
    )
    (root,) = system_roots(laws, ["vx", "vy"], {"v": RationalPi(Fraction(3)), "theta": degrees(40)})
    (left,) = root.left
    assert left.law == "speed"
    assert left.at({}) == pytest.approx((9, 9), rel=1e-15)
