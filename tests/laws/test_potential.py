"""The well: its cubic, its lowest order, and what a plane adds, against numbers found in another way."""

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import (
    angular_momentum,
    depth_of_well,
    energy_between,
    far_turning_point,
    oscillation,
    small_excess,
    turning_points,
)
from corollary.laws.law import sides


@given(st.floats(1e-6, 1.33))
def test_the_far_turning_point_keeps_energy_and_angular_momentum(kappa):
    ((_, r),) = sides(far_turning_point(sympy.Symbol("r"), b=1, kappa=sympy.Rational(kappa)))
    y = float(r.evalf(30))
    assert y > 1
    assert kappa * (1 - 1 / y**2) == pytest.approx((y - 1) ** 2, rel=1e-8)


def test_the_lowest_order_is_that_of_the_cubic():
    k, b, v, m = 100, 1, sympy.Rational(1, 1000), 2
    ((_, small),) = sides(
        small_excess(sympy.Symbol("x"), m=sympy.Integer(m), k=sympy.Integer(k), b=sympy.Integer(b), v=v)
    )
    ((_, r),) = sides(far_turning_point(sympy.Symbol("r"), b=b, kappa=m * v**2 / (k * sympy.Integer(b) ** 2)))
    assert float(small / (r - b).evalf(40)) == pytest.approx(1, abs=1e-6)


m, k, b, d, t, x = sympy.symbols("m k b d t x", positive=True)


def test_the_depth_of_the_well_is_the_work_to_its_edge():
    ((_, depth),) = sides(depth_of_well(sympy.Symbol("U"), k=k, d=d))
    assert sympy.simplify(depth - sympy.integrate(k * (x - b), (x, b, b + d))) == 0


def test_turning_points_lie_where_the_potential_energy_is_all():
    for place in (b - d, b + d):
        ((energy, potential),) = sides(turning_points(place, E=k * d**2 / 2, k=k, b=b))
        assert sympy.simplify(energy - potential) == 0


def test_an_oscillation_solves_newtons_second_law():
    ((_, period),) = sides(oscillation(sympy.Symbol("T"), m=m, k=k))
    place = sympy.cos(2 * sympy.pi * t / period)
    assert sympy.simplify(m * sympy.diff(place, t, 2) + k * place) == 0


def test_energy_and_angular_momentum_of_an_oscillation_in_a_plane_stay_as_they_are():
    """x = 3 cos t, y = 4 sin t solves m r'' = -k r for m = k = 2: both laws hold between the axes of the ellipse."""
    law = energy_between(
        m=2, v_0=4, U_0=2 * sympy.Integer(3) ** 2 / 2, v_1=3, U_1=2 * sympy.Integer(4) ** 2 / 2
    )
    ((before, after),) = sides(law)
    assert before == after
    ((before, after),) = sides(angular_momentum(m=2, w_0=4, r_0=3, w_1=3, r_1=4))
    assert before == after


def test_angular_momentum_of_a_free_body_stays_as_it_is():
    """It passes the centre at the distance 3 with the speed 5; later it is 5 away, and 3/5 of its velocity lies across."""
    ((before, after),) = sides(angular_momentum(m=m, w_0=5, r_0=3, w_1=3, r_1=5))
    assert before == after == 15 * m
