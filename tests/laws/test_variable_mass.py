"""Bodies that gain or lose mass: the integrated laws against many small steps."""

import math

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import (
    burnt,
    change_in_absorption,
    growing,
    impulse_of_growing_weight,
    rocket_equation,
    thrust,
)
from corollary.laws.law import sides


@given(st.floats(0.05, 0.95), st.floats(100, 5000))
def test_the_rocket_equation_is_the_sum_of_small_puffs(share, speed):
    ((_, found),) = sides(
        burnt(v_0=0, v_1=sympy.Symbol("v"), v_rel=sympy.Rational(speed), m_0=1, m_1=sympy.Rational(share))
    )
    puffs = 2000
    step = (1 - share) / puffs
    summed = math.fsum(speed * step / (1 - (i + 0.5) * step) for i in range(puffs))
    assert float(found) == pytest.approx(summed, rel=1e-4)


@given(st.integers(1, 20), st.integers(1, 20), st.integers(1, 9))
def test_the_impulse_of_a_growing_weight_is_its_mean_times_the_time(m, R, t):
    m, R, t = map(sympy.Integer, (m, R, t))
    ((_, impulse),) = sides(impulse_of_growing_weight(sympy.Symbol("J"), m=m, R=R, g=sympy.Integer(10), t=t))
    assert impulse == 10 * (m + (m + R * t)) / 2 * t


m, dm, v, dv, u, R, a, t = sympy.symbols("m dm v dv u R a t", real=True)


def test_the_change_in_absorption_is_what_is_there_after_less_what_was_there_before():
    ((_, change),) = sides(change_in_absorption(sympy.Symbol("dp"), m=m, dm=dm, v=v, u=u, dv=dv))
    assert sympy.expand(change - ((m + dm) * (v + dv) - (m * v + dm * u))) == 0


def test_the_rocket_equation_is_the_rate_of_change_in_absorption():
    """dm = R dt and dv = a dt, divided by dt, as dt vanishes."""
    ((_, change),) = sides(change_in_absorption(sympy.Symbol("dp"), m=m, dm=R * t, v=v, u=u, dv=a * t))
    ((_, force),) = sides(rocket_equation(sympy.Symbol("F"), m=m, a=a, v=v, u=u, R=R))
    assert sympy.expand(sympy.limit(change / t, t, 0) - force) == 0


def test_without_an_outer_force_the_thrust_is_mass_times_acceleration():
    ((outer, force),) = sides(rocket_equation(0, m=m, a=a, v=v, u=u, R=R))
    ((_, push),) = sides(thrust(sympy.Symbol("F"), u - v, R))
    assert sympy.expand(m * a + outer - force - push) == 0


def test_a_mass_grows_by_what_its_rate_adds_up_to():
    ((_, mass),) = sides(growing(sympy.Symbol("m_1"), m=m, R=R, t=t))
    assert sympy.expand(mass - m - sympy.integrate(R, (t, 0, t))) == 0
