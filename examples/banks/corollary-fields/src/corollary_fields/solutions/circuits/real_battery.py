"""A tired battery: an ideal one and a resistor in a row."""

from corollary.author import derivation, mistake, route, step, unknowns
from corollary.laws import law, wrong


def derive(E, R, U):
    i, r, P, j, V = unknowns("i r P j V", j="current with two lamps")
    return derivation(
        step(
            i,
            "The lamp has the voltage that is left.",
            law("Ohm's law", "U = i*R", U=U, R=R),
            answers="a",
            mistakes=[
                mistake(
                    "The lamp does not have the voltage without load any more.", wrong("E = i*R", E=E, R=R)
                ),
                mistake(
                    "That part of the voltage is lost in the battery.", wrong("E - U = i*R", E=E, U=U, R=R)
                ),
            ],
        ),
        step(
            r,
            "The missing voltage lies across the inner resistance.",
            law("Kirchhoff's voltage law", "E = U + i*r", E=E, U=U),
            answers="b",
            mistakes=[
                mistake("That is the whole resistance of the circuit.", wrong("E = i*r", E=E)),
                mistake(
                    "The two voltages do not stand in the same ratio as the resistances here: which voltage "
                    "lies across the inner one?",
                    wrong("r = R*U/E", R=R, U=U, E=E),
                ),
            ],
        ),
        step(
            P,
            "Current times the voltage that is lost inside.",
            law("Power", "P = i^2*r", P=P),
            answers="c",
            routes=[
                route(
                    "Or the missing voltage times the current.",
                    law("Power lost", "P = (E - U)*i", P=P, E=E, U=U),
                )
            ],
            mistakes=[
                mistake("That is the power of the lamp.", wrong("P = U*i", P=P, U=U)),
                mistake("That is all the power that the battery turns out.", wrong("P = E*i", P=P, E=E)),
            ],
        ),
        step(
            j,
            "Two equal lamps side by side have half the resistance of one.",
            law("Kirchhoff's voltage law", "E = j*(R/2) + j*r", E=E, R=R),
        ),
        step(
            V,
            "What is left between the poles.",
            law("Voltage under load", "V = E - j*r", V=V, E=E),
            answers="d",
            mistakes=[
                mistake("The larger current costs more voltage inside.", wrong("V = U", V=V, U=U)),
                mistake(
                    "The current does not quite double, since the voltage of the lamps falls.",
                    wrong("V = E - 2*i*r", V=V, E=E),
                ),
                mistake(
                    "The lamps are side by side: is their resistance larger or smaller than that of one?",
                    wrong("V = E*2*R/(2*R + r)", V=V, E=E, R=R),
                ),
            ],
        ),
    )
