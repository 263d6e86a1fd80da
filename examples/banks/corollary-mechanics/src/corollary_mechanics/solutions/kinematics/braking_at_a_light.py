"""Braking at a traffic light: a way at constant speed, and one at constant deceleration."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, position_at, velocity_at, wrong
from corollary.scenes.forces.contact import Friction
from corollary.scenes.scene import Body, Scene


def derive(v, t, b):
    s, T, x = unknowns("s T x")
    return derivation(
        step(
            s,
            "The speed is constant until the brakes act.",
            law("Constant speed", "s = v*t"),
            answers="a",
            mistakes=[
                mistake(
                    "The car already slows down in your reckoning; the brakes do nothing yet.",
                    wrong("s = v*t - b*t^2/2"),
                ),
                mistake(
                    "That is the way of a car that starts from rest. This one has its full speed all the "
                    "time.",
                    wrong("s = v*t/2"),
                ),
            ],
            check="At 50 km/h it is about 14 m for each second.",
        ),
        step(
            T,
            "The velocity falls steadily from v to zero.",
            velocity_at(0, v_0=v, a=-b, t=T),
            answers="b",
            mistakes=[
                mistake(
                    "You counted the reaction time, too; asked is how long the brakes work.",
                    wrong("T = t + v/b"),
                ),
                mistake(
                    "While it brakes, a mean speed of half as much covers the way; but the whole speed must "
                    "be lost.",
                    wrong("T = v/(2*b)"),
                ),
            ],
        ),
        step(
            x,
            "Behind the reaction way begins the way of braking.",
            position_at(x, x_0=s, v_0=v, a=-b, t=T),
            answers="c",
            mistakes=[
                mistake(
                    "That is the way of braking alone; where was the car when the brakes began to act?",
                    wrong("x = v*T - b*T^2/2"),
                ),
                mistake(
                    "The car has not its full speed while it brakes: in the mean it has half of it.",
                    wrong("x = s + v*T"),
                ),
                mistake(
                    "The acceleration is against the motion: mind its sign.", wrong("x = s + v*T + b*T^2/2")
                ),
            ],
            check="The way of braking is $v^2/2b$, four times as long at twice the speed.",
        ),
        choice(
            "d",
            "The reaction way doubles, the way of braking is four times as long; the sum lies between.",
            a=False,
            b=False,
            c=True,
            d=False,
            mistakes={
                "a": "Both ways become longer by at least a factor of two.",
                "b": "That is so for the reaction way alone. How does the way of braking go with the speed?",
                "d": "That is so for the way of braking alone.",
            },
        ),
    )


def scene(v, t, b, answer):
    """A body that a rough table slows down by b."""
    sliding = Scene((Body(1.0, (answer["a"],), (v,)),), (Friction(0, b / 9.8),), until=2 * answer["b"])
    return [simulate(sliding, trajectory=(answer["c"],))]
