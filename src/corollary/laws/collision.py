"""Collisions along a line: the coefficient of restitution, the two-body problem, and contacts with and without damping."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from typing import Any

import sympy

from corollary.formula.authored import as_expression
from corollary.laws.energy import elastic
from corollary.laws.law import Law, law, sides
from corollary.laws.momentum import conservation_of_momentum


def restitution(r: object, *, A: tuple[Any, ...], B: tuple[Any, ...]) -> Law:
    """The relative velocity is turned round and shrinks by r (12.62); A and B are (velocity before, velocity after).

    `v_B1 - v_A1 = -r*(v_B0 - v_A0)`
    """
    return law(
        "Coefficient of restitution",
        "v_B1 - v_A1 = -r*(v_B0 - v_A0)",
        source="(12.62)",
        r=r,
        v_A0=A[0],
        v_A1=A[1],
        v_B0=B[0],
        v_B1=B[1],
    )


def reduced_mass(mu: object, m_A: object, m_B: object) -> Law:
    """Two bodies that act on each other move against each other like one of this mass.

    `mu = m_A*m_B/(m_A + m_B)`
    """
    return law(
        "Reduced mass",
        "mu = m_A*m_B/(m_A + m_B)",
        source="",
        holds="no external force acts",
        mu=mu,
        m_A=m_A,
        m_B=m_B,
    )


def half_oscillation(T: object, m: object, k: object) -> Law:
    """A contact with a linear spring lasts half a period of the oscillation.

    `T = pi*sqrt(m/k)` (12.137) with q = 1
    """
    return law(
        "Half a period",
        "T = pi*sqrt(m/k)",
        source="(12.137) with q = 1",
        holds="the contact force is linear, q = 1",
        T=T,
        m=m,
        k=k,
    )


def after_elastic(*, A: tuple[Any, ...], B: tuple[Any, ...]) -> tuple[sympy.Expr, sympy.Expr]:
    """Both velocities after an elastic collision, (12.79) and (12.80), solved from momentum and energy.

    A and B are (mass, velocity before). Of the two roots the one on which nothing has happened is left out.
    """
    (m_A, v_A0), (m_B, v_B0) = A, B
    v_A1, v_B1 = sympy.symbols("v_A1 v_B1", real=True, cls=sympy.Dummy)
    laws = (
        conservation_of_momentum(before=[A, B], after=[(m_A, v_A1), (m_B, v_B1)]),
        elastic(before=[A, B], after=[(m_A, v_A1), (m_B, v_B1)]),
    )
    equations = [left - right for stated in laws for left, right in sides(stated)]
    (root,) = (
        root
        for root in sympy.solve(equations, [v_A1, v_B1], dict=True)
        if sympy.simplify(root[v_A1] - v_A0) != 0 or sympy.simplify(root[v_B1] - v_B0) != 0
    )
    return as_expression(sympy.factor(root[v_A1])), as_expression(sympy.factor(root[v_B1]))


def in_the_limit(found: object, formula: object, letter: sympy.Symbol, to: object, holds: str) -> Law:
    """What a formula (or each of several) becomes as one letter vanishes or grows beyond all bounds; taken here.

    `v = v_limit` (12.69)-(12.72)
    """
    several = isinstance(formula, tuple)
    limits = (
        tuple(sympy.limit(one, letter, to) for one in formula)
        if several
        else sympy.limit(formula, letter, to)
    )
    return law("Limit", "v = v_limit", source="(12.69)-(12.72)", holds=holds, v=found, v_limit=limits)


def seen_from(w: object, v: object, u: object) -> Law:
    """A velocity v is that of the moving system, u, and the velocity w measured in it (12.74).

    `v = u + w`
    """
    return law("Relative motion", "v = u + w", source="(12.74)", v=v, u=u, w=w)


def damping_rate(beta: object, m: object, c: object) -> Law:
    """How fast a swing with the drag c v dies away, from m x'' = -k x - c x'.

    `beta = c/(2*m)`
    """
    return law(
        "Damped oscillation", "beta = c/(2*m)", holds="the contact pushes with k x + c v", beta=beta, m=m, c=c
    )


def damped_frequency(omega: object, m: object, k: object, beta: object) -> Law:
    """The angular frequency of a damped swing, from m x'' = -k x - c x'.

    From beta² = k/m on, the overlap creeps back and never ends: nothing rebounds. The second number says so without a case of
    its own: it keeps omega so small there that exp(-pi beta/omega) is below 10^-400, which is 0 among the doubles.

    `omega = sqrt(max(k/m - beta^2, beta^2/100000))`
    """
    return law(
        "Damped oscillation",
        "omega = sqrt(max(k/m - beta^2, beta^2/100000))",
        holds="the first number counts for a swing; without one the second makes the rebound vanish",
        omega=omega,
        m=m,
        k=k,
        beta=beta,
    )


def damped_rebound(r: object, beta: object, T: object) -> Law:
    """The relative velocity shrinks as exp(-beta t), and half a swing turns it round.

    `r = exp(-beta*T)`
    """
    return law(
        "Damped oscillation",
        "r = exp(-beta*T)",
        holds="the contact ends when the overlap is zero again",
        r=r,
        beta=beta,
        T=T,
    )
