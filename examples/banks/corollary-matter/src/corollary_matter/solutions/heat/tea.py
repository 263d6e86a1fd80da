"""Ice in the tea: melting takes heat without a change of temperature."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, T, b, c, L, Z):
    Q, x, y = unknowns("Q x y")
    return derivation(
        step(
            Q,
            "Melting takes heat in proportion to the mass.",
            law("Heat of fusion", "Q = b*L", Q=Q, b=b),
            answers="a",
            mistakes=[
                mistake("The ice melts, not the tea.", wrong("Q = m*L", Q=Q)),
                mistake(
                    "To melt, the ice need not become warmer first: it is at its melting point.",
                    wrong("Q = b*(L + c*(T - Z))", Q=Q, b=b, T=T, Z=Z),
                ),
            ],
        ),
        step(
            x,
            "The tea gives the heat that melts the ice and warms the water that it becomes.",
            law("Conservation of energy", "m*c*(T - x) = Q + b*c*(x - Z)", b=b, T=T, x=x, Z=Z, Q=Q),
            answers="b",
            mistakes=[
                mistake("To melt takes heat, too.", wrong("m*c*(T - x) = b*c*(x - Z)", b=b, T=T, x=x, Z=Z)),
                mistake(
                    "What the ice has become is warmed as well.", wrong("m*c*(T - x) = Q", T=T, x=x, Q=Q)
                ),
            ],
        ),
        step(
            y,
            "No melting: only the masses share the heat.",
            law("Conservation of energy", "m*c*(T - y) = b*c*(y - Z)", b=b, T=T, y=y, Z=Z),
            answers="c",
            mistakes=[
                mistake("There are different amounts of the two.", wrong("y = (T + Z)/2", T=T, y=y, Z=Z)),
                mistake(
                    "The masses have changed places.", wrong("b*c*(T - y) = m*c*(y - Z)", b=b, T=T, y=y, Z=Z)
                ),
            ],
            check="Ice cools much better than cold water.",
        ),
    )
