"""A wheelbarrow: a lever whose pivot is the wheel."""

from corollary.author import derivation, mistake, route, step, unknowns
from corollary.laws import law, wrong


def derive(m, d, L, F, g):
    H, N, M = unknowns("H N M")
    return derivation(
        step(
            H,
            "Torques about the axle.",
            law("Equilibrium of torques", "H*L = m*g*d", H=H),
            answers="a",
            mistakes=[
                mistake(
                    "The arm of the hands reaches from the axle to the handles, not from the load.",
                    wrong("H*(L - d) = m*g*d", H=H),
                ),
                mistake("The wheel carries a part.", wrong("H = m*g", H=H)),
            ],
            check="Less than the weight: that is what the lever is for.",
        ),
        step(
            N,
            "Hands and wheel together carry the weight.",
            law("Equilibrium of forces", "N + H = m*g", H=H),
            answers="b",
            routes=[
                route("Or torques about the handles.", law("Equilibrium of torques", "N*L = m*g*(L - d)"))
            ],
            mistakes=[
                mistake("The hands carry a part.", wrong("N = m*g")),
                mistake("The hands lift, they do not press the wheel down.", wrong("N = m*g + H", H=H)),
            ],
        ),
        step(
            M,
            "The same lever with the largest force.",
            law("Equilibrium of torques", "F*L = M*g*d"),
            answers="c",
            mistakes=[
                mistake("That could be lifted without a lever.", wrong("F = M*g")),
                mistake(
                    "A mass is asked; divide the weight by g, and take the arms the right way round.",
                    wrong("F*d = M*g*L"),
                ),
            ],
        ),
    )
