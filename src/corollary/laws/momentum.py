"""Momentum and impulse: definitions, mean force, Newton's third law, and conservation in an isolated system."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from typing import Any

import sympy

from corollary.laws.law import Law, law


def momentum(p: object, m: object, v: object) -> Law:
    """The momentum of one object: p = m v (12.15); vectors allowed.

    `p = m*v`
    """
    return law("Momentum", "p = m*v", source="(12.15)", p=p, m=m, v=v)


def change_of_momentum(dp: object, m: object, *, before: object, after: object) -> Law:
    """The change is what it is after less what it was before (12.29).

    `dp = m*v_1 - m*v_0`
    """
    return law(
        "Change of momentum", "dp = m*v_1 - m*v_0", source="(12.29)", dp=dp, m=m, v_1=after, v_0=before
    )


def conservation_of_momentum(*, before: list[tuple[Any, ...]], after: list[tuple[Any, ...]]) -> Law:
    """The total momentum of an isolated system is the same before and after (12.52), (12.58).

    `before` and `after` list (mass, velocity) of every object; an object that comes to be, or to be part of another, may differ.

    `m_A*v_A0 + … = m_A*v_A1 + …`
    """
    letters: dict[str, Any] = {}

    def total(bodies: list[tuple[Any, ...]], moment: int) -> str:
        terms: list[str] = []
        for place, (mass, velocity) in enumerate(bodies):
            body = "ABCDEFGH"[place]
            m, v = f"m_{body}" if same else f"m_{body}{moment}", f"v_{body}{moment}"
            letters[m], letters[v] = mass, velocity
            terms.append(f"{m}*{v}")
        return " + ".join(terms)

    same = [mass for mass, _ in before] == [mass for mass, _ in after]
    formula = f"{total(before, 0)} = {total(after, 1)}"
    return law(
        "Conservation of momentum",
        formula,
        source="(12.52), (12.58)",
        holds="no net external force acts along this direction",
        **letters,
    )


def sticking(*, before: list[tuple[Any, ...]], together: object) -> Law:
    """Conservation of momentum when all objects move on as one.

    `m_A*v_A0 + m_B*v_B0 + … = (m_A + m_B + …)*v_1` (12.14), (12.81)
    """
    letters: dict[str, Any] = {"v_1": together}
    left, masses = list[str](), list[str]()
    for place, (mass, velocity) in enumerate(before):
        body = "ABCDEFGH"[place]
        letters[f"m_{body}"], letters[f"v_{body}0"] = mass, velocity
        left.append(f"m_{body}*v_{body}0")
        masses.append(f"m_{body}")
    return law(
        "Conservation of momentum",
        f"{' + '.join(left)} = ({' + '.join(masses)})*v_1",
        source="(12.14), (12.81)",
        holds="no net external force acts along this direction, and the objects move as one afterwards",
        **letters,
    )


def total_momentum(P: object, bodies: list[tuple[Any, ...]]) -> Law:
    """The total momentum is the sum over all objects (12.49), (12.56); `bodies` lists (mass, velocity), vectors allowed.

    `P = m_1*v_1 + m_2*v_2 + …`
    """
    letters: dict[str, Any] = {"P": P}
    terms: list[str] = []
    for place, (mass, velocity) in enumerate(bodies, 1):
        letters[f"m_{place}"], letters[f"v_{place}"] = mass, velocity
        terms.append(f"m_{place}*v_{place}")
    return law("Total momentum", f"P = {' + '.join(terms)}", source="(12.49), (12.56)", holds="", **letters)


def external_impulse(J: object, *, before: object, after: object) -> Law:
    """Only external forces change the total momentum (12.53).

    `J = P_1 - P_0`
    """
    return law(
        "External impulse",
        "J = P_1 - P_0",
        source="(12.53)",
        holds="J is the impulse of all external forces; internal forces cancel in pairs",
        J=J,
        P_0=before,
        P_1=after,
    )


def magnitude(p: object, components: tuple[Any, ...]) -> Law:
    """The length of a vector in a plane, by Pythagoras.

    `p = sqrt(p_x^2 + p_y^2)`
    """
    return law("Magnitude", "p = sqrt(p_x^2 + p_y^2)", p=p, p_x=components[0], p_y=components[1])


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
