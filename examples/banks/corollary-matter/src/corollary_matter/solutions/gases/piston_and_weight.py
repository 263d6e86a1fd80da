"""A piston with a weight: equal temperature first, equal height afterwards."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(d, h, m, p, g):
    S, q, x, f = unknowns("S q x f")
    return derivation(
        step(S, "The piston is round.", law("Area of a circle", "S = pi*d^2/4", S=S)),
        step(
            q,
            "The gas must carry the air outside and the weight.",
            law("Equilibrium of forces", "q*S = p*S + m*g", S=S),
            answers="a",
            mistakes=[
                mistake("The air presses on the piston, too.", wrong("q*S = m*g", S=S)),
                mistake("You took the diameter for the radius.", wrong("q = p + m*g/(pi*d^2)")),
            ],
        ),
        step(
            x,
            "At the same temperature the product of pressure and volume stays the same.",
            law("Boyle", "q*x = p*h"),
            answers="b",
            mistakes=[
                mistake("The column gets lower when it is pressed.", wrong("p*x = q*h")),
                mistake(
                    "Only the excess has grown from zero; pressures in a gas law count from a vacuum.",
                    wrong("x = h*(1 - m*g/(p*S))", S=S),
                ),
            ],
        ),
        step(
            f,
            "At the same volume as at first, temperature goes with the pressure.",
            law("Gay-Lussac", "f = q/p"),
            answers="c",
            mistakes=[
                mistake("It must become warmer, not colder.", wrong("f = p/q")),
                mistake(
                    "The pressure of the air outside has not gone: what is the whole pressure of the gas?",
                    wrong("f = (q - p)/p"),
                ),
            ],
        ),
    )
