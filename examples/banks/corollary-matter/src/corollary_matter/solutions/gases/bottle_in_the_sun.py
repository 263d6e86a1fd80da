"""A bottle in the sun: an ideal gas in a fixed volume."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(V, p, T, S, M, R):
    m, q, s = unknowns("m q s")
    return derivation(
        step(
            m,
            "The ideal gas law, with the temperature in kelvin.",
            law("Ideal gas", "p*V = (m/M)*R*T", p=p, V=V, T=T),
            answers="a",
            mistakes=[
                mistake(
                    "The temperature counts from absolute zero, not from 0 °C.",
                    wrong("p*V = (m/M)*R*(T - T_0)", p=p, V=V, T=T, T_0=273.15),
                ),
                mistake("That is the temperature in the sun.", wrong("p*V = (m/M)*R*S", p=p, V=V, S=S)),
            ],
        ),
        step(
            q,
            "At the same volume the pressure goes with the absolute temperature.",
            law("Gay-Lussac", "q/p = S/T", p=p, q=q, S=S, T=T),
            answers="b",
            mistakes=[
                mistake(
                    "Absolute temperatures are meant: zero Celsius is not zero.",
                    wrong("q/p = (S - T_0)/(T - T_0)", p=p, q=q, S=S, T=T, T_0=273.15),
                ),
                mistake("When it gets warmer the pressure rises.", wrong("q/p = T/S", p=p, q=q, S=S, T=T)),
            ],
            check="Much less than the ratio of the Celsius temperatures suggests.",
        ),
        step(
            s,
            "At the old pressure and the new temperature less gas fills the bottle.",
            law("Ideal gas", "1 - s = T/S", s=s, S=S, T=T),
            answers="c",
            mistakes=[
                mistake("That is what stays in the bottle.", wrong("s = T/S", s=s, S=S, T=T)),
                mistake(
                    "The share counts from the gas that is in the bottle, at its higher pressure.",
                    wrong("s = q/p - 1", p=p, q=q, s=s),
                ),
            ],
        ),
    )
