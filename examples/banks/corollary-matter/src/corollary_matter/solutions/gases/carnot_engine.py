"""The best engine: only absolute temperatures count."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(T, S, P):
    eta, Q, W = unknowns("eta Q W")
    return derivation(
        step(
            eta,
            "A reversible engine between two temperatures, in kelvin.",
            law("Carnot", "eta = 1 - S/T", S=S, T=T),
            answers="a",
            mistakes=[
                mistake(
                    "Temperatures count from absolute zero here.",
                    wrong("eta = 1 - (S - T_0)/(T - T_0)", S=S, T=T, T_0=273.15),
                ),
                mistake("That is the share that is given off.", wrong("eta = S/T", S=S, T=T)),
                mistake(
                    "The difference is compared with the hot temperature, from which the heat comes.",
                    wrong("eta = T/S - 1", S=S, T=T),
                ),
            ],
        ),
        step(
            Q,
            "The efficiency is what comes out as work from what goes in as heat.",
            law("Efficiency", "P = eta*Q", P=P, Q=Q),
            answers="b",
            mistakes=[
                mistake("An engine takes in more than it gives.", wrong("Q = eta*P", P=P, Q=Q)),
                mistake("Divide by the efficiency, not by what is lost.", wrong("P = (1 - eta)*Q", P=P, Q=Q)),
            ],
        ),
        step(
            W,
            "What does not become work is given off.",
            law("Conservation of energy", "Q = P + W", P=P, Q=Q, W=W),
            answers="c",
            mistakes=[
                mistake(
                    "That is a share of the useful power; it is lost from the heat that goes in.",
                    wrong("W = (1 - eta)*P", P=P, W=W),
                ),
                mistake("That is more than goes in.", wrong("W = Q + P", P=P, Q=Q, W=W)),
            ],
        ),
        choice(
            "d",
            "In S/T the smaller number is changed by the larger share.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Write the efficiency as 1 - S/T: which of the two changes S/T more?",
                "c": (
                    "The difference of the temperatures grows alike. Is it the difference alone that counts?"
                ),
            },
        ),
    )
