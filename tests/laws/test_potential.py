"""The well: its cubic, its lowest order, and what a plane adds, against numbers found in another way."""

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import far_turning_point, small_excess
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
