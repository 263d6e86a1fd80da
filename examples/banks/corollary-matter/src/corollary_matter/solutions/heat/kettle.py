"""An electric kettle: heat, power, time."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, T, B, P, eta, c, L):
    Q, t, u = unknowns("Q t u")
    return derivation(
        step(
            Q,
            "Mass, specific heat, and the difference of the temperatures.",
            law("Heat", "Q = m*c*(B - T)", Q=Q, B=B, T=T),
            answers="a",
            mistakes=[
                mistake("The water is not at zero before.", wrong("Q = m*c*(B - T_0)", Q=Q, B=B, T_0=273.15)),
                mistake(
                    "Only the difference of the temperatures has to be paid for; you also evaporate a part.",
                    wrong("Q = m*c*(B - T) + m*L/2", Q=Q, B=B, T=T),
                ),
            ],
        ),
        step(
            t,
            "Only a part of the power gets into the water.",
            law("Power", "eta*P*t = Q", P=P, Q=Q),
            answers="b",
            mistakes=[
                mistake("Some of the power goes elsewhere.", wrong("P*t = Q", P=P, Q=Q)),
                mistake("Losses make it longer, not shorter.", wrong("P*t = eta*Q", P=P, Q=Q)),
            ],
        ),
        step(
            u,
            "Half of the mass evaporates, at the boiling point.",
            law("Power", "eta*P*u = m*L/2", P=P, u=u),
            answers="c",
            mistakes=[
                mistake("By then all of it would have gone.", wrong("eta*P*u = m*L", P=P, u=u)),
                mistake("Some of the power goes elsewhere, as before.", wrong("P*u = m*L/2", P=P, u=u)),
            ],
            check="It takes longer than to bring all of the water to the boil.",
        ),
    )
