"""Off the table: sideways nothing changes, and downwards it is a free fall."""

from math import tan

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, position_at, velocity_at, wrong
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(v, h, g):
    t, x, w, alpha = unknowns("t x w alpha")
    return derivation(
        step(
            t,
            "Vertically the marble starts from rest, whatever it does sideways.",
            position_at(h, v_0=0, a=g, t=t),
            where=t > 0,
            answers="a",
            mistakes=[
                mistake("The factor 1/2 is missing.", wrong("h = g*t^2"), where=t > 0),
                mistake(
                    "The speed along the table has no vertical component; it does not carry the marble down.",
                    wrong("h = v*t + g*t^2/2"),
                    where=t > 0,
                ),
            ],
        ),
        step(
            x,
            "Horizontally nothing pulls.",
            law("Constant velocity", "x = v*t"),
            answers="b",
            mistakes=[
                mistake("Gravity changes the vertical velocity only.", wrong("x = v*t + g*t^2/2")),
                mistake("The horizontal velocity does not fade away: no halving.", wrong("x = v*t/2")),
            ],
        ),
        step(w, "Meanwhile the marble has gained a velocity downwards.", velocity_at(w, v_0=0, a=g, t=t)),
        step(
            alpha,
            "The two components span the angle.",
            law("Direction", "tan(alpha) = w/v"),
            answers="c",
            mistakes=[
                mistake("That is the angle from the vertical.", wrong("tan(alpha) = v/w")),
                mistake(
                    "That is the direction of the straight line from the edge to where it lands; the path is "
                    "bent.",
                    wrong("tan(alpha) = h/x"),
                ),
            ],
            check="The tangent is twice that of the straight line to the place where it lands.",
        ),
        choice(
            "d",
            "The fall does not know the horizontal velocity.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "It goes further. Does the height of the table or the fall change?",
                "c": "Its path is longer, but it is run through faster.",
            },
        ),
    )


def scene(v, h, g, answer):
    flight = Scene((Body(1.0, (0.0, h), (v, 0.0)),), (Weight(g),), until=answer["a"])
    return [simulate(flight, trajectory=(answer["b"], 0.0), velocities=(v, -v * tan(answer["c"])))]
