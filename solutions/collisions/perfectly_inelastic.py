"""Perfectly inelastic collision: momentum alone, and what it costs in kinetic energy."""

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import change_of_kinetic_energy, law, sticking, wrong


def derive(mA, mB, vA, vB):
    v_1, q, dK, V, dK_V = unknowns("v_1 q dK V dK_V")
    return derivation(
        step(
            v_1,
            "Momentum is kept, and both move on with the same velocity.",
            sticking(before=[(mA, vA), (mB, 0)], together=v_1),
            answers="a",
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when things stick together; momentum is.",
                    wrong(
                        "v_1 = v_A*sqrt(m_A/(m_A + m_B))",
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                    ),
                ),
                mistake(
                    "Both move on together: the momentum is shared by both masses, not carried by B alone.",
                    wrong("m_A*v_A = m_B*v_1", m_A=mA, v_A=vA, m_B=mB),
                ),
                mistake(
                    "The velocity is not halved; the masses are not the same.",
                    wrong("v_1 = v_A/2", v_A=vA),
                ),
            ],
            check="It lies between B's velocity, 0, and A's; a heavy B hardly moves.",
        ),
        step(
            q,
            "Both masses move with the common velocity after, A alone before.",
            law(
                "Ratio of kinetic energies",
                "q = ((m_A + m_B)*v_1^2/2)/(m_A*v_A^2/2)",
                m_A=mA,
                m_B=mB,
                v_A=vA,
            ),
            answers="b",
            routes=[
                route(
                    "The same from the masses alone, with the common velocity put in.",
                    law(
                        "Ratio of kinetic energies",
                        "q = m_A/(m_A + m_B)",
                        source="(12.87)",
                        m_A=mA,
                        m_B=mB,
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "After the collision both masses move: you left B's out.",
                    wrong("q = v_1^2/v_A^2", v_A=vA),
                ),
                mistake(
                    "That is the fraction that is lost.",
                    wrong("q = m_B/(m_A + m_B)", m_A=mA, m_B=mB),
                ),
                mistake(
                    "That is K₀/K₁: energy before over energy after.",
                    wrong(
                        "q = (m_A*v_A^2)/((m_A + m_B)*v_1^2)",
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                    ),
                ),
            ],
            check="It is less than 1, and does not depend on the velocity.",
        ),
        step(
            dK,
            "The change is the kinetic energy of both together after, less that of A before.",
            change_of_kinetic_energy(dK, before=[(mA, vA), (mB, 0)], after=[(mA, v_1), (mB, v_1)]),
            answers="c",
            routes=[
                route(
                    "The same from the fraction that is left.",
                    law("Change of kinetic energy", "dK = (q - 1)*m_A*v_A^2/2", m_A=mA, v_A=vA),
                )
            ],
            mistakes=[
                mistake(
                    "That is what is left of the kinetic energy; asked is its change.",
                    wrong("dK = (m_A + m_B)*v_1^2/2", m_A=mA, m_B=mB),
                ),
                mistake(
                    "You squared the change of A's velocity; take the difference of the kinetic energies.",
                    wrong("dK = m_A*(v_1 - v_A)^2/2", m_A=mA, v_A=vA),
                ),
                mistake(
                    "You forgot that B moves afterwards too and has kinetic energy.",
                    wrong(
                        "dK = m_A*v_1^2/2 - m_A*v_A^2/2",
                        m_A=mA,
                        v_A=vA,
                    ),
                ),
            ],
            check="It is negative: a perfectly inelastic collision always costs kinetic energy.",
        ),
        step(
            V,
            "Momentum is kept again; now B brings some along, with its sign.",
            sticking(before=[(mA, vA), (mB, vB)], together=V),
            answers="d",
            mistakes=[
                mistake(
                    "Momentum has a direction: B's velocity counts with its sign.",
                    sticking(before=[(mA, vA), (mB, -vB)], together=V),
                ),
                mistake(
                    "B is not at rest any more: it brings momentum along.",
                    sticking(before=[(mA, vA), (mB, 0)], together=V),
                ),
                mistake(
                    "Take the mean of the velocities weighted with the masses: heavy blocks count more.",
                    wrong("V = (v_A + v_B)/2", v_A=vA, v_B=vB),
                ),
            ],
            check="It lies between the two velocities from before.",
        ),
        step(
            dK_V,
            "The kinetic energy of both together after, less those of A and of B before.",
            change_of_kinetic_energy(dK_V, before=[(mA, vA), (mB, vB)], after=[(mA, V), (mB, V)]),
            answers="e",
            routes=[
                route(
                    "What is lost is the energy of the relative motion.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = -m_A*m_B/(m_A + m_B)*(v_A - v_B)^2/2",
                        dK=dK_V,
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                        v_B=vB,
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "The relative velocity is the *difference* of the two, with their signs.",
                    wrong(
                        "dK = -m_A*m_B/(m_A + m_B)*(v_A + v_B)^2/2",
                        dK=dK_V,
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                        v_B=vB,
                    ),
                ),
                mistake(
                    "Kinetic energy has no direction: B's counts as positive, whichever way it moves.",
                    wrong(
                        "dK = (m_A + m_B)*V^2/2 - (m_A*v_A^2/2 - m_B*v_B^2/2)",
                        dK=dK_V,
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                        v_B=vB,
                    ),
                ),
                mistake(
                    "B had kinetic energy before too; you left it out.",
                    wrong(
                        "dK = (m_A + m_B)*V^2/2 - m_A*v_A^2/2",
                        dK=dK_V,
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                    ),
                ),
            ],
            check="The faster they come together, the more is lost; with B at rest it is (c).",
        ),
    )


def scene(mA, mB, vA, vB, answer):
    """A gets stuck in B, seen from B: then B is at rest before, and every velocity is less by B's."""
    free = {"m": mA, "M": mB}
    return [
        simulate(
            "bullet_block",
            free | {"v": vA},
            animated=True,
            velocities=(answer["a"], answer["a"]),
            energy_change=answer["c"],
        ),
        simulate(
            "bullet_block",
            free | {"v": vA - vB},
            velocities=(answer["d"] - vB, answer["d"] - vB),
            energy_change=answer["e"],
        ),
    ]
