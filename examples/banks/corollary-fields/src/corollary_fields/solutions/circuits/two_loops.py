"""Two batteries, three branches: Kirchhoff's laws as a linear system."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(E, F, R, S, T):
    i, j, k, u = unknowns("i j k u", j="current through the right battery", k="current in the middle")
    node = law("Kirchhoff's current law", "i + j = k")
    left = law("Left loop", "E = i*R + k*T", E=E, R=R, T=T)
    right = law("Right loop", "F = j*S + k*T", F=F, S=S, T=T)
    return derivation(
        step(
            i,
            "Both currents meet in the middle; once round each loop the voltages add up.",
            node,
            left,
            right,
            also=[j, k],
            answers="a",
            mistakes=[
                mistake(
                    "Through the middle flows the current of the other battery, too.",
                    law("Left loop", "E = i*(R + T)", E=E, R=R, T=T),
                    instead="Left loop",
                ),
                mistake(
                    "Both currents flow into the upper node: they add in the middle.",
                    law("Kirchhoff's current law", "i - j = k"),
                    instead="Kirchhoff's current law",
                ),
            ],
        ),
        step(
            j,
            "The left loop gives the current in the middle, and the node the rest.",
            node,
            left,
            also=[k],
            answers="b",
            mistakes=[
                mistake(
                    "That is what flows through the middle.",
                    law("Not shared", "j = k"),
                    instead="Kirchhoff's current law",
                ),
                mistake(
                    "Both currents flow into the upper node: they add in the middle.",
                    law("Kirchhoff's current law", "i - j = k"),
                    instead="Kirchhoff's current law",
                ),
            ],
        ),
        step(
            u,
            "Ohm's law with the sum of both currents.",
            law("Ohm's law", "u = (i + j)*T", u=u, T=T),
            answers="c",
            mistakes=[
                mistake("The current of the other battery flows there, too.", wrong("u = i*T", u=u, T=T)),
                mistake("The currents add in the middle.", wrong("u = (i - j)*T", u=u, T=T)),
            ],
            check="It is lower than either battery's voltage here, since both give current.",
        ),
    )
