"""Two ions: a collision without touching, ruled by energy, angular momentum and the reduced mass."""

from corollary.author import (
    code,
    derivation,
    file,
    mistake,
    module,
    simulate,
    step,
    unknown,
    unknowns,
    vector,
)
from corollary.laws import distance, ionic, law, reduced_mass, wrong

IONS = module("two_ions/judge_ions.py")


def derive(C, mA, mB, v, r0, s, dx, dy):
    r, mu, E, r_b, r_c = unknowns("r mu E r_b r_c", E="energy of the relative motion")
    F = vector("F")
    w = unknown("w", "relative speed at the closest approach")
    return derivation(
        step(
            r,
            "First the distance of the ions.",
            distance(r, (dx, dy)),
            mistakes=[
                mistake(
                    "The distance is the length of the vector: the root of the sum of the squares, not the "
                    "sum.",
                    wrong("r = abs(x) + abs(y)", x=dx, y=dy),
                )
            ],
        ),
        step(
            F,
            "The force on A points from B to A, against $\\Delta\\vec r$: the ions repel each other.",
            ionic(F, C=C, apart=(dx, dy), r=r),
            answers="a",
            mistakes=[
                mistake(
                    "That is the force on B. With $\\Delta\\vec r = \\vec r_B - \\vec r_A$ the force on A "
                    "has a minus sign.",
                    wrong("F = C/r^2*Dr/r", F=F, Dr=(dx, dy)),
                ),
                mistake(
                    "The unit vector is $\\Delta\\vec r/\\Delta r$: together with $1/(\\Delta r)^2$ the "
                    "vector is divided by the third power of the distance.",
                    wrong("F = -C/r^2*Dr", F=F, Dr=(dx, dy)),
                ),
            ],
            check="Its length is $C/(\\Delta r)^2$, whatever the direction.",
        ),
        step(
            mu,
            "Seen from each other, the ions move like one body of the reduced mass, with the force at the "
            "distance r.",
            reduced_mass(mu, mA, mB),
            mistakes=[
                mistake(
                    "You used the mass of one ion. Both move: the reduced mass $m_A m_B/(m_A + m_B)$ "
                    "belongs to the relative motion.",
                    wrong("mu = m_A", m_A=mA),
                ),
                mistake(
                    "The masses do not add up in the relative motion; the reduced mass is smaller than each "
                    "of them.",
                    wrong("mu = m_A + m_B", m_A=mA, m_B=mB),
                ),
            ],
        ),
        step(
            E,
            "The force $C/r^2$ belongs to the potential energy $C/r$; energy of the relative motion at the "
            "start.",
            law(
                "Energy",
                "E = mu*v^2/2 + C/r_0",
                source="(12.25)",
                holds="the potential energy is zero far apart",
                r_0=r0,
            ),
            mistakes=[
                mistake(
                    "At the start the ions repel each other already: $C/r_0$ is part of the energy.",
                    wrong("E = mu*v^2/2"),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("E = mu*v^2 + C/r_0", r_0=r0),
                ),
            ],
        ),
        step(
            r_b,
            "Head-on, the ions do not move against each other at the closest approach: all of the energy is "
            "potential.",
            law(
                "Conservation of mechanical energy",
                "E = C/r",
                holds="the force is conservative",
                r=r_b,
            ),
            answers="b",
            mistakes=[
                mistake(
                    "The potential energy of this force is $C/r$: integrate $C/r^2$ over the distance.",
                    wrong("E = C/(2*r)", r=r_b),
                ),
                mistake(
                    "You balanced the kinetic energy with the difference the wrong way round: the potential "
                    "energy at the start helps the ions apart.",
                    wrong("E + C/r_0 = C/r", r_0=r0, r=r_b),
                ),
            ],
            check="Slow ions (v → 0) turn round at $r_0$ itself; faster or heavier ones come closer.",
        ),
        step(
            r_c,
            "At the closest approach the relative velocity is at right angles to the line of the ions; $w$ "
            "is its size there. Angular momentum of the relative motion is kept, as the force is central.",
            law(
                "Conservation of mechanical energy",
                "E = mu*w^2/2 + C/r",
                holds="the force is conservative",
                r=r_c,
            ),
            law(
                "Conservation of angular momentum",
                "mu*v*s = mu*w*r",
                holds="the force is central",
                r=r_c,
            ),
            answers="c",
            also=[w],
            where=r_c > 0,
            mistakes=[
                mistake(
                    "They do not stop against each other now: at the closest approach they still pass with "
                    "a velocity across the line between them.",
                    law("Conservation of mechanical energy", "E = C/r", r=r_c),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The impact parameter is not the closest distance: the ions push each other further "
                    "away.",
                    law("Conservation of mechanical energy", "r = s", r=r_c),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="With s = 0 it is the answer of (b); without the force (C → 0) it is s.",
        ),
        code(
            "d",
            "Newton's second law for each ion, with the force on B opposite to that on A; velocities first, "
            "then positions with the new velocities. "
            "The total momentum must stay the same, and the energy once the step is small enough.",
            inputs=IONS.ion_inputs,
            judge=IONS.judge_ions,
            example=file("two_ions/ions.py"),
        ),
    )


def scene(C, mA, mB, v, r0, s, dx, dy, answer):
    """The pair in its own two constants of motion: head-on, and with the impact parameter."""
    pair = {"C": C, "mA": mA, "mB": mB, "v": v, "r0": r0}
    return [
        simulate("ions", pair | {"s": 0.0}, turning_points=answer["b"]),
        simulate("ions", pair | {"s": s}, animated=True, turning_points=answer["c"]),
    ]
