"""A turning skater: the angular momentum stays, the energy does not."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(I, J, n):
    f, W = unknowns("f W")
    return derivation(
        step(
            f,
            "No torque acts about the axis; the factor $2\\pi$ stands on both sides.",
            law("Conservation of angular momentum", "I*n = J*f"),
            answers="a",
            mistakes=[
                mistake(
                    "Her energy does change: she pulls. What stays the same when no torque acts?",
                    wrong("I*n^2 = J*f^2"),
                    where=f > 0,
                ),
                mistake(
                    "With her arms drawn in she should turn faster, not more slowly.", wrong("J*n = I*f")
                ),
            ],
        ),
        step(
            W,
            "Work is the change of kinetic energy, with the angular velocity $2\\pi$ times the turns per "
            "second.",
            law("Work and kinetic energy", "W = J*(2*pi*f)^2/2 - I*(2*pi*n)^2/2", W=W),
            answers="b",
            mistakes=[
                mistake(
                    "The angular velocity is in radians: each turn counts $2\\pi$.",
                    wrong("W = J*f^2/2 - I*n^2/2", W=W),
                ),
                mistake(
                    "That is the kinetic energy in the end; some was there before.",
                    wrong("W = J*(2*pi*f)^2/2", W=W),
                ),
                mistake(
                    "Her moment of inertia is another one afterwards.",
                    wrong("W = I*(2*pi*f)^2/2 - I*(2*pi*n)^2/2", W=W),
                ),
            ],
            check="It is positive: she must pull.",
        ),
        choice(
            "c",
            "The arms move inwards along the force that keeps them on their circle.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Friction would take energy, and angular momentum with it.",
                "c": "Compare the two kinetic energies.",
            },
        ),
    )
