"""A ball against a body on a hinge: what both laws say together."""

from __future__ import annotations

import sympy

from corollary.laws.law import sides
from corollary.laws.rotation import elastic_on_hinge, hit_on_hinge

M, H, V, INERTIA = sympy.symbols("m h v I", positive=True)
U, OMEGA = sympy.symbols("u omega", real=True)


def after() -> dict[sympy.Symbol, sympy.Expr]:
    laws = (
        hit_on_hinge(m=M, h=H, before=V, after=U, I=INERTIA, omega=OMEGA),
        elastic_on_hinge(m=M, before=V, after=U, I=INERTIA, omega=OMEGA),
    )
    found = sympy.solve(
        [left - right for stated in laws for left, right in sides(stated)], [U, OMEGA], dict=True
    )
    (met,) = (root for root in found if sympy.simplify(root[OMEGA]) != 0)
    return met


def test_ball_and_body_part_as_fast_as_they_met():
    met = after()
    assert sympy.simplify(met[OMEGA] * H - met[U] - V) == 0


def test_a_body_very_hard_to_turn_is_a_wall():
    met = after()
    assert sympy.limit(met[U], INERTIA, sympy.oo) == -V
    assert sympy.simplify(sympy.limit(INERTIA * met[OMEGA], INERTIA, sympy.oo) - 2 * M * V * H) == 0
