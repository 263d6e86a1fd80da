"""A spring gun: energy of the spring, of motion, of height."""

from math import sqrt

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def derive(m, k, x, g):
    E, v, H = unknowns("E v H")
    return derivation(
        step(
            E,
            "The force of the spring grows from zero to kx; in the mean it is half of that.",
            law("Energy of a spring", "E = k*x^2/2", E=E),
            answers="a",
            mistakes=[
                mistake(
                    "You let the spring push with its largest force all the way.", wrong("E = k*x^2", E=E)
                ),
                mistake("That is a force; what is its work?", wrong("E = k*x/2", E=E)),
            ],
        ),
        step(
            v,
            "The energy of the spring lifts the ball by x and gives it its speed.",
            law("Conservation of energy", "E = m*v^2/2 + m*g*x", E=E),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake(
                    "The factor 1/2 of the kinetic energy is missing.",
                    wrong("E = m*v^2 + m*g*x", E=E),
                    where=v > 0,
                ),
                mistake(
                    "Count in that the ball has been lifted meanwhile.",
                    wrong("E = m*v^2/2", E=E),
                    where=v > 0,
                ),
                mistake(
                    "Gravity does not help on the way up: mind the sign.",
                    wrong("E = m*v^2/2 - m*g*x", E=E),
                    where=v > 0,
                ),
            ],
        ),
        step(
            H,
            "At the highest point all energy is potential energy of height.",
            law("Conservation of energy", "E = m*g*H", E=E),
            answers="c",
            mistakes=[
                mistake(
                    "Counted from where the ball lay at first, the compression belongs to the height "
                    "already.",
                    wrong("E = m*g*(H - x)", E=E),
                ),
                mistake("The energy of the spring has a factor 1/2.", wrong("k*x^2 = m*g*H")),
            ],
            check="The speed in between is not needed.",
        ),
        choice(
            "d",
            "The energy of a spring goes with the square of the compression.",
            a=False,
            b=False,
            c=True,
            mistakes={
                "a": "There is more energy in the spring.",
                "b": "The force doubles, and the way along which it pushes does, too.",
            },
        ),
    )


def scene(m, k, x, g, answer):
    """The spring pushes while it is shorter than it is at rest; when it has its length again follows from the oscillation."""
    from math import acos, pi

    w = sqrt(k / m)
    lower = m * g / k
    t = acos(-lower / (x - lower)) / w if x > lower else pi
    push = ForceFunction(0, lambda at, y, u: (-k * (y[0] - x),))
    ball = Body(m, (0.0,), (0.0,))
    leaving = Scene((ball,), (Weight(g), push), until=t)
    top = Scene((Body(m, (x,), (answer["b"],)),), (Weight(g),), until=answer["b"] / g)
    return [
        simulate(leaving, velocities=(answer["b"],), trajectory=(x,)),
        simulate(top, trajectory=(answer["c"],)),
    ]
