"""A plank with two children: torques about the pivot, forces on the plank."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, M, d, P, g):
    x, N = unknowns("x N")
    return derivation(
        step(
            x,
            "About the pivot the plank itself has no torque: its centre is there.",
            law("Equilibrium of torques", "m*g*d = M*g*x"),
            answers="a",
            mistakes=[
                mistake("That would be balanced by equal masses only.", wrong("x = d")),
                mistake(
                    "The heavier one must sit nearer to the pivot: you have turned the ratio round.",
                    wrong("M*g*d = m*g*x"),
                ),
            ],
        ),
        step(
            N,
            "The pivot carries all three weights.",
            law("Equilibrium of forces", "N = (m + M + P)*g", P=P),
            answers="b",
            mistakes=[
                mistake("The plank has a weight, too, though no torque.", wrong("N = (m + M)*g")),
                mistake(
                    "The weights of both children point downwards; they do not cancel, only their torques do.",
                    wrong("N = P*g", P=P),
                ),
            ],
        ),
        choice(
            "c",
            "The arms grow by the same length; with the larger weight that is the larger torque.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "What grows equally: the torques, or the arms?",
                "c": "Whose torque grows more when the arm grows by a metre?",
            },
        ),
    )
