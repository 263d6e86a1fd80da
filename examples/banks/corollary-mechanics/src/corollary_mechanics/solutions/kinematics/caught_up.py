"""Caught up: equal ways are one moment, equal speeds another."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, position_at, velocity_at, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(v, a):
    t, x, u, lead = unknowns("t x u D", u="time at which both are equally fast")
    return derivation(
        step(
            t,
            "They are at the same place again: the car's way from rest is that of the cyclist.",
            position_at(v * t, v_0=0, a=a, t=t),
            where=t > 0,
            answers="a",
            mistakes=[
                mistake(
                    "That is when the car is as fast as the cyclist. By then it is still behind.",
                    wrong("v = a*t"),
                ),
                mistake(
                    "You have turned the factor round: when is the mean speed of the car, half of what it has "
                    "then, that of the cyclist?",
                    wrong("v = 2*a*t"),
                ),
            ],
            check="The car's mean speed is that of the cyclist.",
        ),
        step(
            x,
            "The cyclist's way.",
            law("Constant velocity", "x = v*t"),
            answers="b",
            mistakes=[
                mistake("The car's way at constant acceleration has a factor 1/2.", wrong("x = a*t^2")),
                mistake("That is half of the way: whose mean speed did you take?", wrong("x = v*t/2")),
            ],
        ),
        step(
            u,
            "The lead grows as long as the cyclist is the faster one; it is largest when both are equally "
            "fast.",
            velocity_at(v, v_0=0, a=a, t=u),
        ),
        step(
            lead,
            "The lead is the difference of both ways at that moment.",
            law("Lead", "D = v*u - a*u^2/2", u=u),
            answers="c",
            mistakes=[
                mistake(
                    "That is how far the cyclist has come by then; the car has moved, too.",
                    wrong("D = v*u", u=u),
                ),
                mistake(
                    "The lead is not largest halfway in distance; look for the moment of equal speeds.",
                    wrong("D = v^2*(sqrt(2) - 1)/a"),
                ),
            ],
            check="It is a quarter of the way to the place where they meet.",
        ),
        choice(
            "d",
            "Starting from rest, its mean speed is half of its speed; and its mean speed is that of the "
            "cyclist.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Then it would not overtake; when was it as fast as the cyclist?",
                "c": "Work out the speed from your result for the time: what is left of a?",
            },
        ),
    )


def scene(v, a, answer):
    """The cyclist glides; a steady force pulls the car."""
    cyclist, car = Body(1.0, (0.0,), (v,)), Body(1.0, (0.0,), (0.0,))
    pull = ForceFunction(1, lambda t, x, u: (a,))
    meeting = Scene((cyclist, car), (pull,), until=answer["a"])
    widest = Scene((cyclist, car), (pull,), until=answer["a"] / 2)
    return [
        simulate(meeting, trajectory=(answer["b"], answer["b"])),
        simulate(widest, trajectory=(answer["b"] / 2, answer["b"] / 2 - answer["c"]), velocities=(v, v)),
    ]
