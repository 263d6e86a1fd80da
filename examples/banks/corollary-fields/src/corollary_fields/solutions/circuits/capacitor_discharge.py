"""A flash is charged: the voltage nears that of the supply exponentially."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(C, R, U, V):
    i, tau, t, W = unknowns("i tau t W")
    return derivation(
        step(
            i,
            "An empty capacitor has no voltage: all of it lies across the resistor.",
            law("Ohm's law", "U = i*R", U=U, R=R),
            answers="a",
            mistakes=[
                mistake(
                    "That is the current later, when the flash is ready.", wrong("U - V = i*R", U=U, V=V, R=R)
                ),
                mistake(
                    "At first there is no voltage on the capacitor that could be left for the resistor alone.",
                    wrong("V = i*R", V=V, R=R),
                ),
            ],
        ),
        step(
            tau,
            "Resistance times capacitance.",
            law("Time constant", "tau = R*C", R=R, C=C),
            answers="b",
            mistakes=[
                mistake("That is how long it takes to charge one half.", wrong("tau = log(2)*R*C", R=R, C=C)),
                mistake(
                    "A full turn of an oscillation has a factor $2\\pi$; nothing oscillates here.",
                    wrong("tau = 2*pi*R*C", R=R, C=C),
                ),
            ],
        ),
        step(
            t,
            "The voltage that is missing fades exponentially.",
            law("Charging", "V = U*(1 - exp(-t/tau))", U=U, V=V),
            answers="c",
            mistakes=[
                mistake(
                    "That is how the voltage fades when it is discharged.",
                    wrong("V = U*exp(-t/tau)", U=U, V=V),
                ),
                mistake(
                    "The current does not stay as large as it was at first.", wrong("C*V = i*t", C=C, V=V)
                ),
            ],
        ),
        step(
            W,
            "The energy of a capacitor.",
            law("Energy of a capacitor", "W = C*V^2/2", W=W, C=C, V=V),
            answers="d",
            mistakes=[
                mistake(
                    "While it is charged, the voltage is half of that in the mean.",
                    wrong("W = C*V^2", W=W, C=C, V=V),
                ),
                mistake("It has not the voltage of the supply yet.", wrong("W = C*U^2/2", W=W, C=C, U=U)),
            ],
        ),
        choice(
            "e",
            "The current is largest at the first moment and fades, and the voltage of the resistor with it.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Has an empty capacitor a voltage at the first moment?",
                "c": "The supply keeps its voltage as long as it charges.",
            },
        ),
    )
