"""A block on a spring: what it has at equilibrium is the spring's where it turns."""

from corollary.author import derivation, mistake, step, unknown, vector
from corollary.laws import energy_of_an_oscillator, law


def derive(m, k, v):
    A = unknown("A")
    x = vector("x", "low high")
    return derivation(
        step(
            A,
            "All energy is kinetic at equilibrium, and all of it is the spring's at the turning point.",
            energy_of_an_oscillator(m=m, k=k, v=v, x=A),
            answers="a",
            where=A >= 0,
            mistakes=[
                mistake(
                    "The energies go with the squares: take the root of m/k.",
                    law("Energy of an oscillator", "m*v = k*x", m=m, v=v, k=k, x=A),
                ),
                mistake(
                    "The root belongs to m/k alone, or square the speed first.",
                    law("Energy of an oscillator", "m*v^2 = k*x", m=m, v=v, k=k, x=A),
                ),
            ],
            check="A stiffer spring turns it round sooner.",
        ),
        step(
            x,
            "It turns where it is one amplitude away, on either side.",
            law("Turning points", "x = a", x=x, a=(-A, A)),
            answers="b",
            mistakes=[
                mistake(
                    "It starts at equilibrium, but swings to both sides of it.",
                    law("Turning points", "x = a", x=x, a=(0, A)),
                ),
                mistake(
                    "The amplitude is the distance to each side, not between the two ends.",
                    law("Turning points", "x = a", x=x, a=(-A / 2, A / 2)),
                ),
            ],
            check="The interval is as long on the one side as on the other.",
        ),
    )
