"""Forces in a plane against potentials, against geometry worked out by hand, and against a motion on a circle."""

from __future__ import annotations

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import distance, ionic, on_a_circle, overlap, sphere_contact, towards_circle, within
from corollary.laws.law import Law, sides

x, y = sympy.symbols("x y", real=True)
F = sympy.symbols("F_x F_y", real=True)


def right(law: Law) -> list[sympy.Expr]:
    return [other for _, other in sides(law)]


@given(st.floats(-9, 9), st.floats(-9, 9))
def test_a_distance_is_that_of_the_complex_number(a, b):
    ((_, length),) = sides(distance(sympy.Symbol("r"), (sympy.Rational(a), sympy.Rational(b))))
    assert float(length) == pytest.approx(abs(complex(a, b)), abs=1e-12)


@given(st.fractions(0, 9), st.fractions(0, 20))
def test_the_overlap_of_two_balls_on_a_line_is_what_both_cover(R, r):
    """A covers -R to R, B covers r - R to r + R."""
    (found,) = right(overlap(sympy.Symbol("delta"), R=R, r=r))
    assert found == R - (r - R)
    assert (found > 0) == (r - R < R)


def test_balls_of_radius_3_whose_centres_are_5_apart_overlap_by_1():
    assert right(overlap(sympy.Symbol("delta"), R=3, r=5)) == [1]


@pytest.mark.parametrize(
    ("room", "theta"), [("0.3", 1), ("1e-9", 1), ("-1e-9", 0), ("-4", 0), ("0", sympy.nan)]
)
def test_a_switch_is_on_where_there_is_room(room, theta):
    assert right(within(sympy.Symbol("theta"), sympy.Rational(room), "")) == [theta]


def contact(theta=1, apart=(3, 4), passing=(0, 0), eta=0):
    law = sphere_contact(
        F,
        theta=theta,
        k=7,
        delta=4,
        eta=eta,
        apart=apart,
        r=sympy.sqrt(apart[0] ** 2 + apart[1] ** 2),
        passing=passing,
    )
    return sympy.Matrix(right(law))


def test_the_contact_of_two_spheres():
    """A is pushed away from B with k delta^(3/2) = 7 * 8, dragged along with B's velocity, and let go when they part."""
    assert contact() == sympy.Matrix([-56 * sympy.Rational(3, 5), -56 * sympy.Rational(4, 5)])
    assert contact(passing=(2, -1), eta=10) - contact() == sympy.Matrix([20, -10])
    assert contact(theta=0, passing=(2, -1), eta=10) == sympy.Matrix([0, 0])
    assert contact(apart=(-3, -4)) == -contact()  # what B feels: A stands on the other side


def test_the_ionic_force_has_the_potential_C_over_r():
    """`apart` points from A at (x, y) to B at the origin."""
    C, r = sympy.Symbol("C", positive=True), sympy.sqrt(x**2 + y**2)
    force = right(ionic(F, C=C, apart=(-x, -y), r=r))
    assert [
        sympy.simplify(one + sympy.diff(C / r, place)) for one, place in zip(force, (x, y), strict=True)
    ] == [0, 0]


def test_the_pull_towards_a_circle_has_the_potential_of_a_spring():
    k, b = sympy.symbols("k b", positive=True)
    r = sympy.sqrt(x**2 + y**2)
    force = right(towards_circle(F, k=k, b=b, place=(x, y), r=r))
    potential = k * (r - b) ** 2 / 2
    assert [
        sympy.simplify(one + sympy.diff(potential, place)) for one, place in zip(force, (x, y), strict=True)
    ] == [0, 0]


def test_the_force_on_a_circle_is_mass_times_acceleration():
    m, v, r, t = sympy.symbols("m v r t", positive=True)
    place = sympy.Matrix([r * sympy.cos(v / r * t), r * sympy.sin(v / r * t)])
    inwards = -(m * place.diff(t, 2)).dot(place) / r
    assert right(on_a_circle(sympy.Symbol("F"), m=m, v=v, r=r)) == [sympy.simplify(inwards)]
