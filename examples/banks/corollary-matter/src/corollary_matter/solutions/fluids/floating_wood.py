"""A floating beam: what floats displaces its own weight."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(a, S, rho, w):
    x, m = unknowns("x m")
    return derivation(
        step(
            x,
            "The weight of the displaced water is that of the beam; the area and g cancel.",
            law("Archimedes", "w*x = rho*a"),
            answers="a",
            mistakes=[
                mistake("That is how much looks out of the water.", wrong("w*x = (w - rho)*a")),
                mistake(
                    "The wood is the lighter one: does it sink in by more than its height?",
                    wrong("rho*x = w*a"),
                ),
            ],
        ),
        step(
            m,
            "At most the water of the whole beam is displaced; it carries the wood and the passenger.",
            law("Archimedes", "w*S*a = rho*S*a + m", S=S),
            answers="b",
            mistakes=[
                mistake("The water must carry the wood, too.", wrong("w*S*a = m", S=S)),
                mistake("That is the mass of the beam itself.", wrong("m = rho*S*a", S=S)),
            ],
            check="With wood as dense as water nobody could stand on it.",
        ),
        choice(
            "c",
            "Less of the denser water has the weight of the beam.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "The weight displaced is the same. And its volume?",
                "c": "How much of the denser water weighs as much as the beam?",
            },
        ),
    )
