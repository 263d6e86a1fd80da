"""Two resistors, two ways: one current, or one voltage."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(U, R, S):
    i, u, j = unknowns("i u j")
    return derivation(
        step(
            i,
            "The same current flows through both; their voltages add up to that of the battery.",
            law("Kirchhoff's voltage law", "U = i*R + i*S", U=U, R=R, S=S),
            answers="a",
            mistakes=[
                mistake("There is another resistor in the way.", wrong("U = i*R", U=U, R=R)),
                mistake(
                    "That is what the battery gives to the two side by side.",
                    wrong("i = U/R + U/S", U=U, R=R, S=S),
                ),
            ],
        ),
        step(
            u,
            "Ohm's law for the second one.",
            law("Ohm's law", "u = i*S", u=u, S=S),
            answers="b",
            mistakes=[
                mistake("The battery's voltage is shared by both resistors.", wrong("u = U", u=u, U=U)),
                mistake("That is the voltage across the first one.", wrong("u = i*R", u=u, R=R)),
            ],
            check="The larger resistor has the larger voltage.",
        ),
        step(
            j,
            "Each has the full voltage; the currents add.",
            law("Kirchhoff's current law", "j = U/R + U/S", U=U, R=R, S=S),
            answers="c",
            mistakes=[
                mistake(
                    "Side by side, the current has two ways: it is not the one from before.", wrong("j = i")
                ),
                mistake(
                    "Resistances do not add side by side, currents do.",
                    wrong("j = 2*U/(R + S)", U=U, R=R, S=S),
                ),
            ],
        ),
        choice(
            "d",
            "At the same voltage the larger current takes the larger power.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "The voltage of the battery is the same. In which case does it give the larger current?",
                "c": "The battery is the same, but is the current?",
            },
        ),
    )
