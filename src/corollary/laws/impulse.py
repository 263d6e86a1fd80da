"""Impulse, mean force, and Newton's third law."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from typing import Any

import sympy

from corollary.laws.law import Law, law


def impulse_momentum(J: object, dp: object) -> Law:
    """The impulse of the net force is the change of momentum (12.19), (12.20).

    `J = dp`
    """
    return law(
        "Impulse", "J = dp", source="(12.19), (12.20)", holds="J is the impulse of the net force", J=J, dp=dp
    )


def mean_force(F: object, J: object, dt: object) -> Law:
    """The time-averaged force is the impulse divided by the time it acts (12.22).

    `F = J/dt`
    """
    return law("Mean force", "F = J/dt", source="(12.22)", F=F, J=J, dt=dt)


def third_law(on_other: object, on_this: object) -> Law:
    """What A does to B is opposite to what B does to A (12.44); for impulses as for forces.

    `J_AB = -J_BA`
    """
    return law("Newton's third law", "J_AB = -J_BA", source="(12.44)", J_AB=on_other, J_BA=on_this)


def impulse_of(J: object, t: sympy.Symbol, *pieces: tuple[Any, ...]) -> Law:
    """The impulse is the area under F(t) (12.20); each piece is (force as a formula of t, from when, till when).

    `J = A`
    """
    area = sum((sympy.integrate(force, (t, start, end)) for force, start, end in pieces), sympy.Integer(0))
    return law("Impulse", "J = A", source="(12.20)", holds="A is the area under the curve F(t)", J=J, A=area)


def impulse_of_constant_force(J: object, F: object, dt: object) -> Law:
    """A force that stays the same needs no integral (12.20).

    `J = F*dt`
    """
    return law("Impulse", "J = F*dt", source="(12.20)", holds="the force is constant", J=J, F=F, dt=dt)


def force_on_standing(F: object, N: object, m: object, g: object) -> Law:
    """The floor pushes up, the weight pulls down; their sum is the net force (12.24), up positive.

    `F = N - m*g`
    """
    return law(
        "Net force",
        "F = N - m*g",
        source="(12.24)",
        holds="up is positive, and only the floor and the weight act",
        F=F,
        N=N,
        m=m,
        g=g,
    )


def direction(angle: object, J: tuple[Any, ...]) -> Law:
    """The angle of a vector above the x-axis (12.41), for vectors with a positive x-component.

    `beta = atan(J_y/J_x)`
    """
    return law(
        "Direction",
        "beta = atan(J_y/J_x)",
        source="(12.41)",
        holds="J_x is positive",
        beta=angle,
        J_x=J[0],
        J_y=J[1],
    )
