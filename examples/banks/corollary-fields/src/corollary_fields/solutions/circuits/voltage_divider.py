"""A loaded voltage divider: what is measured changes by being used."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(U, R, S, T):
    u, Q, v, P = unknowns("u Q v P", Q="resistance of the lower resistor and the load together")
    return derivation(
        step(
            u,
            "The same current flows through both.",
            law("Voltage divider", "u*(R + S) = U*S", u=u, U=U, R=R, S=S),
            answers="a",
            mistakes=[
                mistake(
                    "That is the voltage across the upper one.", wrong("u*(R + S) = U*R", u=u, U=U, R=R, S=S)
                ),
                mistake(
                    "The lower voltage is compared with all of it, not with that of the upper one.",
                    wrong("u*R = U*S", u=u, U=U, R=R, S=S),
                ),
            ],
        ),
        step(Q, "Lower resistor and load side by side.", law("Parallel", "1/Q = 1/S + 1/T", Q=Q, S=S, T=T)),
        step(
            v,
            "Now the divider's lower part is smaller.",
            law("Voltage divider", "v*(R + Q) = U*Q", v=v, U=U, R=R, Q=Q),
            answers="b",
            mistakes=[
                mistake("The load takes current, and the voltage falls.", wrong("v = u", v=v, u=u)),
                mistake(
                    "Side by side the two make a smaller resistance, not a larger one.",
                    wrong("v*(R + S + T) = U*(S + T)", v=v, U=U, R=R, S=S, T=T),
                ),
                mistake(
                    "The load does not take the place of the lower resistor: that one is still there.",
                    wrong("v*(R + T) = U*T", v=v, U=U, R=R, T=T),
                ),
            ],
        ),
        step(
            P,
            "Voltage squared by resistance.",
            law("Power", "P = v^2/T", P=P, v=v, T=T),
            answers="c",
            mistakes=[
                mistake("With the load the voltage has fallen.", wrong("P = u^2/T", P=P, u=u, T=T)),
                mistake("That is the power of both together.", wrong("P = v^2/Q", P=P, v=v, Q=Q)),
            ],
        ),
    )
