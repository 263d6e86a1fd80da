"""Heat through a wall: layers in a row share the difference of temperature."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(S, d, k, e, i, T, U):
    P, Q, x = unknowns("P Q x")
    return derivation(
        step(
            P,
            "The flow goes with area and difference of temperature, and against the thickness.",
            law("Conduction of heat", "P = k*S*(T - U)/d", P=P, S=S, T=T, U=U),
            answers="a",
            mistakes=[
                mistake(
                    "Through both surfaces goes the same heat: it is not to be shared.",
                    wrong("P = k*S*(T - U)/(2*d)", P=P, S=S, T=T, U=U),
                ),
                mistake(
                    "The difference of the temperatures drives the flow, not their mean.",
                    wrong("P = k*S*(T - T_0)/d", P=P, S=S, T=T, T_0=273.15),
                ),
            ],
        ),
        step(
            Q,
            "The same heat flows through both layers; each takes a part of the difference of temperature, in "
            "proportion to thickness by conductivity.",
            law("Layers in a row", "Q*(d/k + e/i) = S*(T - U)", Q=Q, S=S, T=T, U=U),
            answers="b",
            mistakes=[
                mistake(
                    "That is the insulation alone; the brick holds back some, too.",
                    wrong("Q*e/i = S*(T - U)", Q=Q, S=S, T=T, U=U),
                ),
                mistake(
                    "The flows through the layers do not add: the heat goes through one after the other.",
                    wrong("Q = S*(T - U)*(k/d + i/e)", Q=Q, S=S, T=T, U=U),
                ),
            ],
            check="Less than through the insulation alone.",
        ),
        step(
            x,
            "The flow through the brick.",
            law("Conduction of heat", "Q = k*S*(T - x)/d", Q=Q, S=S, T=T, x=x),
            answers="c",
            mistakes=[
                mistake(
                    "The layers do not share the difference in halves.", wrong("x = (T + U)/2", T=T, U=U, x=x)
                ),
                mistake(
                    "Look at the order of the layers: the insulation lies outside.",
                    wrong("Q = k*S*(x - U)/d", Q=Q, S=S, U=U, x=x),
                ),
            ],
            check="The brick stays nearly as warm as the room.",
        ),
    )
