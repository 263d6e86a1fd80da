"""Collisions along a line: the two roots, the limits, and changes of the observer."""

from __future__ import annotations

import math

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws.collision import after_elastic, in_the_limit, restitution, seen_from
from corollary.laws.law import sides

MASS, VELOCITY = st.integers(1, 1000), st.integers(-100, 100)
M_A, M_B = sympy.symbols("m_A m_B", positive=True)
V_A, V_B = sympy.symbols("v_A v_B", real=True)
AFTER_A, AFTER_B = after_elastic(A=(M_A, V_A), B=(M_B, V_B))


@given(MASS, MASS, VELOCITY, VELOCITY)
def test_an_elastic_collision_turns_every_velocity_round_in_the_frame_of_the_centre_of_mass(
    m_a, m_b, v_a, v_b
):
    point = {M_A: m_a, M_B: m_b, V_A: v_a, V_B: v_b}
    centre = sympy.Rational(m_a * v_a + m_b * v_b, m_a + m_b)
    assert AFTER_A.subs(point) == 2 * centre - v_a
    assert AFTER_B.subs(point) == 2 * centre - v_b


def test_the_general_solution_is_that_of_the_book():
    assert sympy.simplify(AFTER_A - ((M_A - M_B) * V_A + 2 * M_B * V_B) / (M_A + M_B)) == 0  # (12.79)
    assert sympy.simplify(AFTER_B - ((M_B - M_A) * V_B + 2 * M_A * V_A) / (M_A + M_B)) == 0  # (12.80)


def test_equal_masses_exchange_their_velocities():
    assert after_elastic(A=(M_A, V_A), B=(M_A, V_B)) == (V_B, V_A)


@pytest.mark.parametrize(("to", "limits"), [(sympy.oo, (-V_A, 0)), (0, (V_A, 2 * V_A))])
def test_very_unequal_masses(to, limits):
    u = sympy.symbols("u_A u_B", real=True)
    formulas = after_elastic(A=(M_A, V_A), B=(M_B, 0))
    stated = in_the_limit(u, formulas, M_B, to, "one mass is negligible")
    assert sides(stated) == list(zip(u, limits, strict=True))
    far = 1e-9 if to == 0 else 1e9
    for formula, limit in zip(formulas, limits, strict=True):
        near = formula.subs({M_A: 1, M_B: far, V_A: 1})
        assert math.isclose(near, sympy.sympify(limit).subs(V_A, 1), abs_tol=3e-9)  # off by 2 m_A/m_B


def test_a_limit_of_one_formula_is_one_equation():
    u = sympy.Symbol("u", real=True)
    assert sides(in_the_limit(u, V_A * M_A / (M_A + M_B), M_B, sympy.oo, "B is heavy")) == [(u, 0)]


@given(MASS, MASS, VELOCITY, VELOCITY)
def test_an_elastic_collision_has_restitution_one_for_every_observer(m_a, m_b, v_a, v_b):
    point = {M_A: m_a, M_B: m_b, V_A: v_a, V_B: v_b}
    ((left, right),) = sides(restitution(1, A=(V_A, AFTER_A), B=(V_B, AFTER_B)))
    assert left.subs(point) == right.subs(point)


def test_a_velocity_is_that_of_the_moving_system_and_the_one_measured_in_it():
    ((left, right),) = sides(seen_from(7, 5, -2))
    assert left == right
