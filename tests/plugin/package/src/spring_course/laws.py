"""Laws of springs that Corollary's library does not have."""

from __future__ import annotations

from sympy import Expr

from corollary.laws import Law, law


def energy_of_an_oscillator(*, m: Expr, k: Expr, v: Expr, x: Expr) -> Law:
    """m v²/2 = k x²/2: at equilibrium all energy is kinetic, at a turning point all of it is the spring's."""
    return law("Energy of an oscillator", "m*v^2/2 = k*x^2/2", m=m, v=v, k=k, x=x)
