"""Under water: pressure of a column, force on an area."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(h, d, p, rho, g):
    q, S, F = unknowns("q S F")
    return derivation(
        step(
            q,
            "The water above adds its weight per area to the pressure of the air.",
            law("Hydrostatic pressure", "q = p + rho*g*h"),
            answers="a",
            mistakes=[
                mistake("The air presses on the water as well.", wrong("q = rho*g*h")),
                mistake("The pressure grows with depth.", wrong("q = p - rho*g*h")),
            ],
            check="Some ten metres of water weigh as much as the air above.",
        ),
        step(S, "The window is round.", law("Area of a circle", "S = pi*d^2/4", S=S)),
        step(
            F,
            "Outside presses the water, inside the air.",
            law("Force of pressure", "F = (q - p)*S", S=S),
            answers="b",
            mistakes=[
                mistake("The air inside pushes back.", wrong("F = q*S", S=S)),
                mistake(
                    "Take the radius for the area of a circle: you were given the diameter.",
                    wrong("F = (q - p)*pi*d^2"),
                ),
            ],
        ),
        choice(
            "c",
            "The part of the water doubles, that of the air does not.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "That is so for the part of the water only.",
                "c": "Is there a part that does not grow?",
            },
        ),
    )
