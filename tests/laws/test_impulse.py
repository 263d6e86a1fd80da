"""Impulses are areas under curves, in one piece or in several."""

import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.laws import direction, force_on_standing, impulse_of, impulse_of_constant_force
from corollary.laws.law import sides

t = sympy.Symbol("t", real=True)
J = sympy.Symbol("J", real=True)
whole = st.fractions(-20, 20, max_denominator=20)


def area(*pieces):
    ((left, right),) = sides(impulse_of(J, t, *pieces))
    assert left == J
    return right


@settings(max_examples=25)  # of integrals of a cubic; more of them say nothing new
@given(whole, whole, whole)
def test_an_impulse_cut_in_two_is_the_sum(force, middle, end):
    pulse = force + 3 * t**2
    assert area((pulse, 0, middle), (pulse, middle, end)) == area((pulse, 0, end))


@given(whole, whole)
def test_a_constant_force_needs_no_integral(force, time):
    ((_, product),) = sides(impulse_of_constant_force(J, force, time))
    assert product == area((sympy.Rational(force), 0, time))


def test_the_net_force_on_what_stands_still_is_nothing():
    m, g = sympy.symbols("m g", positive=True)
    ((left, right),) = sides(force_on_standing(0, m * g, m, g))
    assert left == right


@given(st.floats(-1.5, 1.5), st.floats(0.1, 10))
def test_a_direction_is_the_angle_it_was_made_of(angle, length):
    angle, length = sympy.Rational(angle), sympy.Rational(length)
    ((left, right),) = sides(direction(angle, (length * sympy.cos(angle), length * sympy.sin(angle))))
    assert abs(float(left) - float(right)) < 1e-9
