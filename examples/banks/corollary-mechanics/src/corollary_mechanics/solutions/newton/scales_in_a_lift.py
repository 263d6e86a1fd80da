"""Scales in a lift: they show the force with which they push, not the weight."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def derive(m, a, b, g):
    N, W, P, s = unknowns("N W P s")
    return derivation(
        step(
            N,
            "The push of the scales upwards and the weight downwards together accelerate the person upwards.",
            law("Newton's second law", "N - m*g = m*a"),
            answers="a",
            mistakes=[
                mistake("Then there would be no acceleration.", wrong("N = m*g")),
                mistake(
                    "What would you feel in a lift that falls? Here it starts upwards: mind the sign.",
                    wrong("m*g - N = m*a"),
                ),
                mistake("That is the net force; the scales must carry the weight besides.", wrong("N = m*a")),
            ],
        ),
        step(
            W,
            "At constant speed nothing is accelerated, however fast it goes.",
            law("Equilibrium", "W = m*g", W=W),
            answers="b",
            mistakes=[
                mistake("The lift goes up, but it is not accelerated any more.", wrong("W = m*(g + a)", W=W)),
                mistake(
                    "To go on moving no force is needed; the weight has not gone, either.",
                    wrong("W = m*a", W=W),
                ),
            ],
        ),
        step(
            P,
            "It still goes up, but the acceleration points downwards.",
            law("Newton's second law", "P - m*g = -m*b", P=P),
            answers="c",
            mistakes=[
                mistake(
                    "It goes up, but which way does the acceleration point?", wrong("P - m*g = m*b", P=P)
                ),
                mistake("That is the net force alone.", wrong("P = m*b", P=P)),
            ],
            check="Less than the weight: at $b = g$ one would float.",
        ),
        step(
            s,
            "The scales divide the force by g.",
            law("Reading", "N = s*g"),
            answers="d",
            mistakes=[
                mistake(
                    "They would show this at rest. They know the force only, not the mass.", wrong("s = m")
                ),
                mistake(
                    "The scales do not know that the lift is accelerated; they divide by g.",
                    wrong("s = N/(g - a)"),
                ),
            ],
        ),
    )


def scene(m, a, b, g, answer):
    """Weight and the push found, for a second: the velocity gained is the lift's."""

    def ridden(push, start):
        return Scene(
            (Body(m, (0.0,), (start,)),), (Weight(g), ForceFunction(0, lambda t, x, v: (push,))), until=1.0
        )

    return [
        simulate(ridden(answer["a"], 0.0), velocities=(a,)),
        simulate(ridden(answer["b"], 3.0), velocities=(3.0,)),
        simulate(ridden(answer["c"], 3.0), velocities=(3.0 - b,)),
    ]
