"""A pump at a well: power is energy in a time, and some of it is lost."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(q, h, eta, T, rho, g):
    P, E, W = unknowns("P E W")
    return derivation(
        step(
            P,
            "In each second the mass $\\rho q$ is lifted by h.",
            law("Power of lifting", "P = rho*q*g*h", P=P),
            answers="a",
            mistakes=[
                mistake(
                    "The height does not need a mean: each litre is lifted all the way.",
                    wrong("P = rho*q*g*h/2", P=P),
                ),
                mistake(
                    "Losses come before the water: the useful power is what lifts it, all of it.",
                    wrong("P = eta*rho*q*g*h", P=P),
                ),
            ],
        ),
        step(
            E,
            "Only a part of the electric power lifts water.",
            law("Efficiency", "P = eta*E", P=P, E=E),
            answers="b",
            mistakes=[
                mistake("The pump must take more than it gives.", wrong("E = eta*P", P=P, E=E)),
                mistake(
                    "That is what would be lost if the useful power were taken in: losses count from the "
                    "electric power.",
                    wrong("E = (2 - eta)*P", P=P, E=E),
                ),
            ],
            check="It is larger than the useful power.",
        ),
        step(
            W,
            "Energy is power times time.",
            law("Energy", "W = E*T", W=W, E=E),
            answers="c",
            mistakes=[
                mistake(
                    "That is the energy of the lifted water; the meter counts what the pump takes.",
                    wrong("W = P*T", W=W, P=P),
                ),
                mistake(
                    "The losses are counted in the electric power already.", wrong("W = E*T/eta", W=W, E=E)
                ),
            ],
        ),
    )
