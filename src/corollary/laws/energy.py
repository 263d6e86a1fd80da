"""Kinetic and potential energy, work, and conservation of mechanical energy."""

from __future__ import annotations

from typing import Any

from corollary.laws.law import Law, law


def kinetic_energy(K: object, m: object, v: object) -> Law:
    """K = m v²/2.

    `K = m*v^2/2` (12.2)
    """
    return law("Kinetic energy", "K = m*v^2/2", source="(12.2)", K=K, m=m, v=v)


def change_of_kinetic_energy(
    dK: object, *, before: list[tuple[Any, ...]], after: list[tuple[Any, ...]]
) -> Law:
    """The change is the sum after less the sum before; both list (mass, velocity) of every object.

    `dK = m_A1*v_A1^2/2 + … - m_A0*v_A0^2/2 - …` (12.61)
    """
    letters: dict[str, Any] = {"dK": dK}

    def total(bodies: list[tuple[Any, ...]], moment: int) -> list[str]:
        terms: list[str] = []
        for place, (mass, velocity) in enumerate(bodies):
            body = "ABCDEFGH"[place] if len(bodies) > 1 else ""
            m, v = f"m_{body}{moment}", f"v_{body}{moment}"
            letters[m], letters[v] = mass, velocity
            terms.append(f"{m}*{v}^2/2")
        return terms

    formula = " - ".join([" + ".join(total(after, 1)), *total(before, 0)])
    return law("Change of kinetic energy", f"dK = {formula}", source="(12.61)", **letters)


def falling(v: object, g: object, h: object) -> Law:
    """Weight is conservative: what is lost in height is won in speed, from rest; the same law for rising to rest.

    `g*h = v^2/2` (12.25)
    """
    return law(
        "Conservation of mechanical energy",
        "g*h = v^2/2",
        source="(12.25)",
        holds="only gravity does work, and the object is at rest at the upper end",
        g=g,
        h=h,
        v=v,
    )


def elastic(*, before: list[tuple[Any, ...]], after: list[tuple[Any, ...]]) -> Law:
    """An elastic collision keeps the kinetic energy; both list (mass, velocity) of the same objects, in order.

    `m_A*v_A0^2/2 + … = m_A*v_A1^2/2 + …` (12.64)
    """
    letters: dict[str, Any] = {}
    left, right = list[str](), list[str]()
    for place, ((mass, first), (_, last)) in enumerate(zip(before, after, strict=True)):
        body = "ABCDEFGH"[place]
        letters |= {f"m_{body}": mass, f"v_{body}0": first, f"v_{body}1": last}
        left.append(f"m_{body}*v_{body}0^2/2")
        right.append(f"m_{body}*v_{body}1^2/2")
    return law(
        "Conservation of mechanical energy",
        f"{' + '.join(left)} = {' + '.join(right)}",
        source="(12.64)",
        holds="all forces between the objects are conservative",
        **letters,
    )


def sliding_to_rest(*, m: object, v: object, mu: object, N: object, d: object) -> Law:
    """The work of kinetic friction takes all the kinetic energy.

    `m*v^2/2 = mu*N*d` (12.2)
    """
    return law(
        "Work and kinetic energy",
        "m*v^2/2 = mu*N*d",
        source="(12.2)",
        holds="friction is the only force that does work, and the object stops",
        m=m,
        v=v,
        mu=mu,
        N=N,
        d=d,
    )


def spring_at_rest(*, m: object, v: object, k: object, x: object) -> Law:
    """All kinetic energy has gone into a spring at its largest compression.

    `m*v^2/2 = k*x^2/2` (12.25)
    """
    return law(
        "Conservation of mechanical energy",
        "m*v^2/2 = k*x^2/2",
        source="(12.25)",
        holds="the spring force is conservative; at the largest compression nothing moves",
        m=m,
        v=v,
        k=k,
        x=x,
    )


def change_of_kinetic_energy_in_plane(
    dK: object, *, before: list[tuple[Any, ...]], after: list[tuple[Any, ...]]
) -> Law:
    """Kinetic energy after less before, for velocities (x, y); both list (mass, velocity) of the same objects, in order.

    `dK = m_A*(v_Ax1^2 + v_Ay1^2)/2 + … - m_A*(v_Ax0^2 + v_Ay0^2)/2 - …` (12.61)
    """
    letters: dict[str, Any] = {"dK": dK}

    def total(bodies: list[tuple[Any, ...]], moment: int) -> list[str]:
        terms: list[str] = []
        for body, (mass, velocity) in zip("ABCDEFGH", bodies, strict=False):
            m, x, y = f"m_{body}", f"v_{body}x{moment}", f"v_{body}y{moment}"
            letters[m], letters[x], letters[y] = mass, *velocity
            terms.append(f"{m}*({x}^2 + {y}^2)/2")
        return terms

    formula = " - ".join([" + ".join(total(after, 1)), *total(before, 0)])
    return law("Change of kinetic energy", f"dK = {formula}", source="(12.61)", holds="", **letters)


def energy_at_heights(g: object, *, before: tuple[Any, ...], after: tuple[Any, ...]) -> Law:
    """Kinetic and potential energy together stay the same (12.25); both are (velocity, height).

    `v_0^2/2 + g*y_0 = v_1^2/2 + g*y_1`
    """
    return law(
        "Conservation of mechanical energy",
        "v_0^2/2 + g*y_0 = v_1^2/2 + g*y_1",
        source="(12.25)",
        holds="all forces that do work are conservative",
        g=g,
        v_0=before[0],
        y_0=before[1],
        v_1=after[0],
        y_1=after[1],
    )


def work_of_net_force(F: object, s: object, m: object, *, before: object, after: object) -> Law:
    """The work of the net force is the change of kinetic energy (12.2); F and the displacement s along one axis.

    `F*s = m*v_1^2/2 - m*v_0^2/2`
    """
    return law(
        "Work and kinetic energy",
        "F*s = m*v_1^2/2 - m*v_0^2/2",
        source="(12.2)",
        holds="the net force is constant along the way",
        F=F,
        s=s,
        m=m,
        v_0=before,
        v_1=after,
    )
