"""A long throw: a free fall upwards and downwards, and a steady motion sideways."""

from math import cos, pi

from corollary.author import derivation, mistake, simulate, step, unknowns, vector
from corollary.laws import law, position_at, without_time, wrong
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(v, theta, g):
    w = vector("w")
    H, t, R, u = unknowns("H t R u")
    return derivation(
        step(w[0], "The horizontal component of the velocity.", law("Component", "w_x = v*cos(theta)")),
        step(w[1], "The vertical component.", law("Component", "w_y = v*sin(theta)")),
        step(
            H,
            "At the highest point the vertical velocity is zero.",
            without_time(0, v_0=w[1], a=-g, s=H),
            answers="a",
            mistakes=[
                mistake(
                    "Only the vertical component carries it up; you took all of the speed.",
                    wrong("v^2 = 2*g*H"),
                ),
                mistake("That is the horizontal component.", wrong("(v*cos(theta))^2 = 2*g*H")),
            ],
        ),
        step(
            t,
            "The flight ends at the height from which it began.",
            position_at(0, v_0=w[1], a=-g, t=t),
            where=t > 0,
            answers="b",
            mistakes=[
                mistake(
                    "That is the time to the highest point; it comes down again.", wrong("0 = w_y - g*t")
                ),
                mistake(
                    "Only the vertical component of the velocity counts.",
                    wrong("0 = v*t - g*t^2/2"),
                    where=t > 0,
                ),
                mistake(
                    "That is the horizontal component: the angle is measured from the ground.",
                    wrong("0 = w_x*t - g*t^2/2"),
                    where=t > 0,
                ),
            ],
        ),
        step(
            R,
            "Horizontally nothing changes the velocity.",
            law("Constant velocity", "R = w_x*t"),
            answers="c",
            mistakes=[
                mistake("Sideways the ball does not have all of its speed.", wrong("R = v*t")),
                mistake("That component carries it up, not away.", wrong("R = w_y*t")),
            ],
            check="The range is $v^2\\sin 2\\theta/g$: the same for an angle and for what is missing to 90°.",
        ),
        step(
            u,
            "At the top only the horizontal component is left.",
            law("Speed at the top", "u = w_x"),
            answers="d",
            mistakes=[
                mistake(
                    "The ball is not at rest at the top, nor is its speed that of the throw: one component "
                    "has gone.",
                    wrong("u = v"),
                ),
                mistake("This is the component that is used up at the top.", wrong("u = w_y")),
            ],
        ),
    )


def scene(v, theta, g, answer):
    start = (v * cos(theta), v * cos(pi / 2 - theta))
    ball = Body(0.2, (0.0, 0.0), start)
    top = Scene((ball,), (Weight(g),), until=answer["b"] / 2)
    caught = Scene((ball,), (Weight(g),), until=answer["b"])
    return [
        simulate(top, trajectory=(answer["c"] / 2, answer["a"]), velocities=(answer["d"], 0.0)),
        simulate(caught, trajectory=(answer["c"], 0.0)),
    ]
