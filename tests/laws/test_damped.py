"""A contact with a damped spring against its own equation of motion."""

from __future__ import annotations

import math

import pytest
import sympy

from corollary.laws.collision import damped_frequency, damped_rebound, damping_rate
from corollary.laws.law import sides

BETA, OMEGA, R = sympy.symbols("beta omega r", real=True)


def rebound(m: float, k: float, c: float) -> float:
    """The coefficient of restitution as the three laws give it."""
    beta = sides(damping_rate(BETA, m, c))[0][1]
    omega = sides(damped_frequency(OMEGA, m, k, beta))[0][1]
    return float(sides(damped_rebound(R, beta, sympy.pi / omega))[0][1])


def test_the_swing_satisfies_newtons_second_law_and_ends_after_half_a_turn():
    m, k, c, t = sympy.symbols("m k c t", positive=True)
    beta = sides(damping_rate(BETA, m, c))[0][1]
    omega = sympy.sqrt(k / m - beta**2)
    x = sympy.exp(-beta * t) * sympy.sin(omega * t) / omega
    assert sympy.simplify(m * x.diff(t, 2) + c * x.diff(t) + k * x) == 0
    assert (x.diff(t).subs(t, 0), sympy.simplify(x.subs(t, sympy.pi / omega))) == (1, 0)
    after = x.diff(t).subs(t, sympy.pi / omega).subs({m: 0.1, k: 2000, c: 4})
    assert math.isclose(-after, rebound(0.1, 2000, 4), rel_tol=1e-12)


def test_without_damping_nothing_is_lost():
    assert rebound(0.3, 500, 0) == 1


@pytest.mark.parametrize("c", [20.0, 20.1, 40.0, 1e6])
def test_from_critical_damping_on_nothing_rebounds(c):
    assert rebound(0.1, 1000.0, c) == 0  # 2 sqrt(k m) = 20


def test_just_below_critical_damping_there_is_still_a_rebound():
    assert 0 < rebound(0.1, 1000.0, 19.9) < 1e-10
