"""A stone from a bridge: up and down are one motion with one acceleration."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, position_at, without_time, wrong
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(v, h, g):
    s, H, t, w, t1, t2 = unknowns("s H t w t1 t2", s="height above the hand")
    return derivation(
        step(s, "At the highest point the velocity is zero.", without_time(0, v_0=v, a=-g, s=s)),
        step(
            H,
            "The rise is counted from the hand.",
            law("Height", "H = h + s"),
            answers="a",
            mistakes=[
                mistake(
                    "That is how far it rises above the hand. From where is the height asked?", wrong("H = s")
                ),
                mistake("A factor is missing in the rise: $v^2 = 2gs$.", wrong("H = h + v^2/g")),
            ],
        ),
        step(
            t,
            "The whole flight is one motion with the acceleration g downwards; at its end the height is zero.",
            position_at(0, x_0=h, v_0=v, a=-g, t=t),
            where=t > 0,
            answers="b",
            mistakes=[
                mistake(
                    "That would be a stone which is dropped; this one first goes up.",
                    wrong("0 = h - g*t^2/2"),
                    where=t > 0,
                ),
                mistake(
                    "The throw is against gravity: velocity and acceleration have opposite signs.",
                    wrong("0 = h - v*t - g*t^2/2"),
                    where=t > 0,
                ),
                mistake(
                    "That is the time until it is back at the hand.", wrong("0 = v*t - g*t^2/2"), where=t > 0
                ),
            ],
            check="It is longer than the fall of a stone that is just dropped.",
        ),
        step(
            w,
            "It has come down by h, seen from the hand.",
            without_time(w, v_0=v, a=g, s=h),
            where=w > 0,
            answers="c",
            mistakes=[
                mistake(
                    "You left out that it passes the hand with the speed of the throw.",
                    wrong("w^2 = 2*g*h"),
                    where=w > 0,
                ),
                mistake(
                    "Speeds of two motions do not add like this; their squares do.",
                    wrong("w = v + sqrt(2*g*h)"),
                ),
            ],
        ),
        step(
            (t1, t2),
            "It passes that height on its way up and on its way down.",
            law("Constant acceleration", "s/2 = v*t1 - g*t1^2/2"),
            law("Back again", "s/2 = v*t2 - g*t2^2/2"),
            where=t1 < t2,
            answers="e",
            mistakes=[
                mistake(
                    "Half of the height is not half of the time: it gets slower on its way up.",
                    law("Half of the time", "t1 = v/(2*g)"),
                    law("Half of the time", "t2 = 3*v/(2*g)"),
                    instead=["Constant acceleration", "Back again"],
                ),
                mistake(
                    "A factor is missing in the rise: $s = v^2/(2g)$.",
                    law("Constant acceleration", "v^2/(2*g) = v*t1 - g*t1^2/2"),
                    law("Back again", "v^2/(2*g) = v*t2 - g*t2^2/2"),
                    instead=["Constant acceleration", "Back again"],
                ),
            ],
            check="Both are as far from the moment at the top.",
        ),
        choice(
            "d",
            "On its way down the first stone passes the hand at the speed v, and from there on its motion is "
            "that of the second.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "How fast is the first stone when it passes the hand again?",
                "c": (
                    "The first stone comes from higher up, but there it was at rest. What is its speed at "
                    "the hand?"
                ),
            },
        ),
    )


def scene(v, h, g, answer):
    flight = Scene((Body(1.0, (h,), (v,)),), (Weight(g),), until=answer["b"])
    return [simulate(flight, trajectory=(0.0,), velocities=(-answer["c"],))]
