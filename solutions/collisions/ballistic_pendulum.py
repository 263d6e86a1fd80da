"""Ballistic pendulum: momentum in the hit, energy in the swing, and never the other way round."""

import sympy

from corollary.author import (
    derivation,
    mistake,
    neglected,
    printed,
    route,
    simulate,
    step,
    supposed,
    unknowns,
)
from corollary.laws import change_of_kinetic_energy, falling, law, rope_height, sticking, wrong


def derive(mA, mB, h, L, g):
    v_1, v_0, dK, q, theta = unknowns("v_1 v_0 dK q theta_max")
    u, x, F, J = unknowns("u x F J")
    _tau, stopped = supposed("tau", "1 ms", "a bullet is stopped sooner")
    return derivation(
        step(
            v_1,
            "After the hit the rope does no work: the kinetic energy of block and bullet lifts them by h.",
            falling(v_1, g, h),
            answers="c",
            where=v_1 >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", v=v_1),
                ),
                mistake(
                    "The factor 2 stands on the other side: $v^2/2 = gh$.",
                    wrong("g*h = 2*v^2", v=v_1),
                ),
                mistake(
                    "The block rises by h, not by the length of the rope.",
                    wrong("g*h = v^2/2", h=L, v=v_1),
                ),
            ],
            check="Neither the mass nor the rope matters: it is the speed of a fall through h.",
        ),
        step(
            v_0,
            "In the hit no outside force acts along the motion, for the rope hangs straight down: momentum "
            "is kept, and both move on together.",
            sticking(before=[(mA, v_0), (mB, 0)], together=v_1),
            answers="a",
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when a bullet gets stuck: most of it is lost. Use momentum "
                    "in the hit.",
                    wrong(
                        "v_0 = v_1*sqrt((m_A + m_B)/m_A)",
                        m_A=mA,
                        m_B=mB,
                    ),
                ),
                mistake(
                    "That is the speed just after the hit; the bullet alone had all of the momentum before.",
                    wrong("v_0 = v_1"),
                ),
                mistake(
                    "The masses have changed places.",
                    wrong(
                        "m_B*v_0 = (m_A + m_B)*v_1",
                        m_A=mA,
                        m_B=mB,
                    ),
                ),
            ],
            check=(
                "A bullet a hundred times as light as the block must be about a hundred times as fast as "
                "both are afterwards."
            ),
        ),
        step(
            dK,
            "The change is the kinetic energy of both together just after the hit, less that of the bullet "
            "before it.",
            change_of_kinetic_energy(dK, before=[(mA, v_0), (mB, 0)], after=[(mA, v_1), (mB, v_1)]),
            answers="b",
            routes=[
                route(
                    "The same from the bullet's speed alone.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = -(m_A*m_B/(m_A + m_B))*v_0^2/2",
                        source="(12.88)",
                        m_A=mA,
                        m_B=mB,
                    ),
                ),
            ],
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong(
                        "dK = (m_A + m_B)*v_1^2 - m_A*v_0^2",
                        m_A=mA,
                        m_B=mB,
                    ),
                ),
                mistake(
                    "That is the energy that is left after the hit, and lifts the block; asked is the "
                    "change in the hit.",
                    wrong("dK = (m_A + m_B)*v_1^2/2", m_A=mA, m_B=mB),
                ),
                mistake(
                    "Momentum is not energy: kinetic energy goes with the square of the speed.",
                    wrong("dK = -m_A*v_0/2", m_A=mA),
                ),
            ],
            check="It is negative, and nearly all that the bullet brought.",
        ),
        step(
            q,
            "Compare with the kinetic energy before, which is the bullet's alone.",
            law("Relative change", "q = dK/(m_A*v_0^2/2)", m_A=mA),
            answers="b_rel",
            routes=[
                route(
                    "With the common velocity put in only the masses are left.",
                    law("Relative change", "q = -m_B/(m_A + m_B)", source="(12.97)", m_A=mA, m_B=mB),
                )
            ],
            mistakes=[
                mistake(
                    "That is the fraction that is left, $m_A/(m_A + m_B)$; asked is the change.",
                    wrong("q = m_A/(m_A + m_B)", m_A=mA, m_B=mB),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("q = dK/(m_A*v_0^2)", m_A=mA),
                ),
            ],
            check="Only the masses matter: a light bullet loses practically all of its energy.",
        ),
        step(
            theta,
            "At the angle θ the block is lower than the upper end of the rope by L cos θ, at the start by L.",
            rope_height(h, L, theta),
            answers="d",
            where=theta <= sympy.pi,
            mistakes=[
                mistake(
                    "The height is not $L\\sin\\theta$, which is how far the block has moved sideways.",
                    wrong("theta = asin(h/L)", theta=theta),
                ),
                mistake(
                    "The cosine belongs to what is left of the height, $L - h$, not to h.",
                    wrong("theta = acos(h/L)", theta=theta),
                ),
                mistake(
                    "The block moves on an arc: h is not the length of the arc.",
                    wrong("theta = h/L", theta=theta),
                ),
            ],
            check="For h = L the rope would be horizontal, θ = 90°.",
        ),
        neglected(
            "a",
            "the swing while the bullet is stopped",
            u,
            "By then block and bullet have moved by at most x, and the rope, which carries their weight on "
            "a circle, pulls them back with at most F. "
            "The momentum J that it takes from them was the bullet's too.",
            law("Way", "x = v_1*tau"),
            law(
                "Pull of the rope",
                "F = (m_A + m_B)*(g + v_1^2/L)*x/L",
                m_A=mA,
                m_B=mB,
            ),
            law("Impulse", "J = F*tau", source="(12.20)"),
            law("Momentum", "J = m_A*u", source="(12.15)", m_A=mA),
            also=[x, F, J],
            supposing=[stopped],
        ),
        printed("a", "245 m/s", "(12.93)"),
    )


def scene(mA, mB, h, L, g, answer, neglected):
    """The bullet of the speed found is braked inside the block; and as slowly as supposed, in a block that hangs."""
    shot = {"g": g, "v": answer["a"]}
    return [
        simulate(
            "bullet_block",
            shot | {"m": mA, "M": mB},
            velocities=(answer["c"], answer["c"]),
            energy_change=answer["b"],
        ),
        simulate(
            "ballistic_pendulum",
            shot | {"mA": mA, "mB": mB, "L": L, "dt": 1e-3},
            animated=True,
            height=h,
            angle=answer["d"],
            neglected=2 * neglected["a"] / answer["a"],
        ),
    ]
