"""Energetic collision: all of the kinetic energy may go, but none of the momentum."""

import sympy

from corollary.author import choice, derivation, example, explain, mistake, simulate, step, unknowns
from corollary.laws import law, momentum, sticking, wrong


def derive(m1, v1, m2):
    P, v_2 = unknowns("P v_2")
    M1, M2 = sympy.symbols("M_1 M_2", positive=True)
    V1, V2 = unknowns("V_1 V_2")
    return derivation(
        step(
            P,
            "Without kinetic energy nothing moves after the collision; then the total momentum is zero, and "
            "it must have been so before.",
            momentum(P, m1 + m2, 0),
        ),
        choice(
            "a",
            "No kinetic energy after means that nothing moves, so the total momentum is zero after, and "
            "therefore before. If then the two stick together they are at rest: all kinetic energy is gone.",
            a=False,
            b=sympy.Eq(P, 0),
            c=sympy.Ne(P, 0),
            d=False,
            mistakes={
                "a": (
                    "Total energy is conserved, kinetic energy is not: it may become heat and lasting "
                    "deformation."
                ),
                "c": (
                    "If they bring momentum along, they still have it after the collision, and so they "
                    "move on."
                ),
                "d": "Then the moving one brings momentum along, which does not vanish.",
            },
        ),
        example(
            "b",
            (M1, V1, M2, V2),
            "The total momentum must be zero before the collision; three of the four numbers are free.",
            law(
                "Conservation of momentum",
                "m_1*v_1/(m_2*v_2) = -1",
                holds="nothing moves after the collision",
                m_1=M1,
                v_1=V1,
                m_2=M2,
                v_2=V2,
            ),
            law("Masses are positive", "abs(m) = m", m=(M1, M2)),
            free=3,
            scale=-1,
        ),
        step(
            v_2,
            "The two stick together and must be at rest: the total momentum before is zero.",
            sticking(before=[(m1, v1), (m2, v_2)], together=0),
            answers="c",
            mistakes=[
                mistake(
                    "Equal and opposite velocities do not have opposite momenta if the masses differ.",
                    wrong("v_2 = -v_1", v_1=v1),
                ),
                mistake(
                    "Equal kinetic energies do not help: it is the momenta that must cancel.",
                    wrong("v_2 = -v_1*sqrt(m_1/m_2)", v_1=v1, m_1=m1, m_2=m2),
                ),
                mistake(
                    "The masses have changed places: the lighter one must be the faster one.",
                    wrong("m_1*v_2 = -m_2*v_1", v_1=v1, m_1=m1, m_2=m2),
                ),
                mistake(
                    "Momentum has a direction: with this velocity the two momenta add up and do not cancel.",
                    wrong("m_2*v_2 = m_1*v_1", v_1=v1, m_1=m1, m_2=m2),
                ),
            ],
            check="It points the other way, and the heavier object 2 is, the slower it need be.",
        ),
        explain(
            "d",
            "Says that momentum is a vector: two momenta that are not zero can cancel, kinetic energies "
            "cannot.",
            "Says that the objects must then be at rest after the collision, so the collision is perfectly "
            "inelastic.",
            "Says that the kinetic energy becomes internal energy: heat, sound, lasting deformation. The "
            "total energy is conserved.",
            answer="Momentum has a direction, so two objects that move towards each other may have a total "
            "momentum of zero although both move. Kinetic energy has no direction and cannot cancel: "
            "before the "
            "collision it is not zero. If the two stick together they must be at rest, for the total "
            "momentum is still zero. All of the kinetic energy has then become heat and lasting deformation "
            "of the "
            "objects; the total energy is conserved, only the kinetic energy is not.",
        ),
    )


def scene(m1, v1, m2, answer):
    """Object 1 gets stuck in object 2, seen from object 2, which is then at rest before and moves at -v2 after."""
    return [
        simulate(
            "bullet_block", {"m": m1, "M": m2, "v": v1 - answer["c"]}, velocities=(-answer["c"], -answer["c"])
        )
    ]
