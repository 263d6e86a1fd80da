"""A block on a spring: what it has at equilibrium is the spring's where it turns, and shared on the way."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import energy_of_an_oscillator, law, wrong


def derive(m, k, v, u):
    A, E, r = unknowns("A E r")
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
            E,
            "What the block has lost of its kinetic energy is the spring's.",
            law("Conservation of energy", "E + m*u^2/2 = m*v^2/2"),
        ),
        step(
            r,
            "The ratio of the two.",
            law("Ratio", "r = E/(m*u^2/2)"),
            answers="b",
            mistakes=[
                mistake("That is the kinetic energy to the spring's.", wrong("r = (m*u^2/2)/E")),
                mistake("That is to all of the energy.", wrong("r = E/(m*v^2/2)")),
            ],
            check="At equilibrium it is 0.",
        ),
    )
