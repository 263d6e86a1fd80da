"""A long cable: the current goes there and back."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(L, A, I, U, rho):
    R, V, P = unknowns("R V P")
    return derivation(
        step(
            R,
            "Twice the length, for there and back.",
            law("Resistance of a wire", "R = rho*2*L/A", R=R),
            answers="a",
            mistakes=[
                mistake("The current must come back, too.", wrong("R = rho*L/A", R=R)),
                mistake(
                    "The two wires follow one another; they are not side by side.",
                    wrong("R = rho*L/(2*A)", R=R),
                ),
            ],
        ),
        step(
            V,
            "The cable takes its part of the voltage.",
            law("Kirchhoff's voltage law", "U = V + I*R", U=U, V=V, R=R),
            answers="b",
            mistakes=[
                mistake("That is the voltage lost in the cable.", wrong("V = I*R", V=V, R=R)),
                mistake("Both wires take voltage.", wrong("U = V + I*R/2", U=U, V=V, R=R)),
            ],
        ),
        step(
            P,
            "Current squared times resistance.",
            law("Power", "P = I^2*R", P=P, R=R),
            answers="c",
            mistakes=[
                mistake("That is the power of the heater.", wrong("P = V*I", P=P, V=V)),
                mistake("Not all of the voltage lies across the cable.", wrong("P = U^2/R", P=P, U=U, R=R)),
            ],
        ),
        choice(
            "d",
            "The cross section goes with the square of the diameter.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "By what factor does the cross section grow?",
                "c": "A cross section is an area, not a volume.",
            },
        ),
    )
