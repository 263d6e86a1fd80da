"""The line of centres, the angle between two vectors, the height of a pendulum."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational

from corollary.laws.geometry import angle_between, line_of_centres, rope_height
from corollary.laws.law import sides

ANGLE = st.floats(0.0, math.pi / 2)


@given(ANGLE)
def test_the_line_of_centres_is_a_unit_vector_whose_y_is_the_share_of_the_impact_parameter(alpha):
    n = Rational(math.cos(alpha)), Rational(math.sin(alpha))
    for stated in line_of_centres(n, s=3 * n[1], D=3):
        ((left, right),) = sides(stated)
        assert math.isclose(
            left, right, abs_tol=2e-8
        )  # near 90° the root of 1 - n_y² loses half of the digits


@given(ANGLE, ANGLE)
def test_the_angle_between_two_directions_is_the_difference_of_their_angles(one, other):
    a = [2 * Rational(math.cos(one)), 2 * Rational(math.sin(one))]
    b = [5 * Rational(math.cos(other)), 5 * Rational(math.sin(other))]
    ((left, right),) = sides(angle_between(Rational(one) - Rational(other), a=a, b=b, lengths=(2, 5)))
    assert math.isclose(left, right, abs_tol=1e-13)


@given(ANGLE)
def test_the_end_of_a_rope_rises_as_on_a_circle(theta):
    ((left, right),) = sides(rope_height(2 - 2 * Rational(math.cos(theta)), 2, Rational(theta)))
    assert math.isclose(left, right, abs_tol=1e-14)
