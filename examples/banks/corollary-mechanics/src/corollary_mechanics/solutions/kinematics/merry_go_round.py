"""A merry-go-round: steady speed, and yet an acceleration."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.scene import Body, Scene


def derive(n, r):
    T, v, a = unknowns("T v a")
    return derivation(
        step(
            T,
            "The angular velocity of a full turn in the time T.",
            law("Angular velocity", "n = 2*pi/T"),
            answers="a",
            mistakes=[
                mistake(
                    "A rotation is a full turn, not a radian: where is the factor of a full circle?",
                    wrong("n = 1/T"),
                ),
                mistake("Half a circle is not a full turn.", wrong("n = pi/T")),
            ],
        ),
        step(
            v,
            "In a turn the child goes once along the circumference.",
            law("Speed on a circle", "v = 2*pi*r/T"),
            answers="b",
            mistakes=[
                mistake("The circumference is not the diameter.", wrong("v = 2*r/T")),
                mistake("The circumference has the radius twice.", wrong("v = pi*r/T")),
            ],
        ),
        step(
            a,
            "The direction of the velocity changes: the acceleration points to the axis.",
            law("Centripetal acceleration", "a = v^2/r"),
            answers="c",
            mistakes=[
                mistake(
                    "That is how fast the speed would fade, not how the direction turns: square the speed, "
                    "and check the unit.",
                    wrong("a = v^2/(2*r)"),
                ),
                mistake(
                    "A mean velocity over a turn says nothing here: the velocity turns by a full circle in "
                    "T, not from zero to v.",
                    wrong("a = v/T"),
                ),
            ],
            check="At steady speed the acceleration is not zero, since the velocity turns.",
        ),
        choice(
            "d",
            "In the same time the child goes half as far, so v is halved; $v^2/r = (2\\pi/T)^2 r$ is halved, "
            "too.",
            a=False,
            b=True,
            c=False,
            d=False,
            mistakes={
                "a": "The square of the speed is a quarter; and the radius in the denominator?",
                "c": "Does the child still move as fast?",
                "d": "That would be so at the same speed. Does the child still move as fast?",
            },
        ),
    )


def scene(n, r, answer):
    """A body on a rod, without gravity: after a quarter of a turn it is where it should be."""
    nail, child = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(30.0, (r, 0.0), (0.0, answer["b"]))
    quarter = Scene((nail, child), (Rod((0, 1)),), until=answer["a"] / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r))]
