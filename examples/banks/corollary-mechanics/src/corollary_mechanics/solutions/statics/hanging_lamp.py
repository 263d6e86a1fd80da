"""A lamp on two wires: two unknown tensions, two components."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, alpha, beta, g):
    S, T = unknowns("S T", T="tension of the right wire")
    across = law("Equilibrium, horizontally", "S*cos(alpha) = T*cos(beta)", S=S)
    up = law("Equilibrium, vertically", "S*sin(alpha) + T*sin(beta) = m*g", S=S)
    return derivation(
        step(
            S,
            "The sideways pulls cancel, and together the wires carry the weight.",
            across,
            up,
            also=[T],
            answers="a",
            mistakes=[
                mistake(
                    "Add the components that point upwards, not the tensions themselves.",
                    law("Equilibrium, vertically", "S + T = m*g", S=S),
                    instead="Equilibrium, vertically",
                ),
                mistake(
                    "It is the sideways components that cancel; the vertical ones need not be equal.",
                    law("Equilibrium, horizontally", "S*sin(alpha) = T*sin(beta)", S=S),
                    instead="Equilibrium, horizontally",
                ),
                mistake(
                    "The tensions themselves are not equal, their sideways components are.",
                    law("Equal tensions", "S = T", S=S),
                    instead="Equilibrium, horizontally",
                ),
            ],
        ),
        step(
            T,
            "The sideways pulls cancel.",
            across,
            answers="b",
            mistakes=[
                mistake(
                    "The vertical components are not equal: take those that cancel.",
                    wrong("S*sin(alpha) = T*sin(beta)", S=S),
                ),
                mistake(
                    "Equal tensions would pull the lamp sideways, since the angles differ.",
                    wrong("S = T", S=S),
                ),
            ],
        ),
        choice(
            "c",
            "The sideways components are equal; in the steeper wire it is a smaller part of the tension.",
            a=True,
            b=False,
            mistakes={
                "b": (
                    "Both wires pull sideways equally. In which of them is that the smaller part of the "
                    "tension?"
                )
            },
        ),
    )
