"""A pendulum on another planet: small swings measure gravity."""

from math import pi, sin

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(L, n, t, tick, g):
    T, a, U, D = unknowns("T a U D")
    return derivation(
        step(T, "The time of one oscillation.", law("Period", "T = t/n")),
        step(
            a,
            "Small swings of a pendulum.",
            law("Period of a pendulum", "T = 2*pi*sqrt(L/a)"),
            answers="a",
            mistakes=[
                mistake(
                    "A swing from one side to the other is only half an oscillation; the period has $2\\pi$.",
                    wrong("T = pi*sqrt(L/a)"),
                ),
                mistake(
                    "That is as if gravity went with the period, not with its square: take the ratio with "
                    "the pendulum at home again.",
                    wrong("a = g*2*pi*sqrt(L/g)/T"),
                ),
            ],
        ),
        step(
            U,
            "The same pendulum with the gravity of home.",
            law("Period of a pendulum", "U = 2*pi*sqrt(L/g)", U=U),
            answers="b",
            mistakes=[
                mistake(
                    "A stronger pull makes it swing faster, not more slowly.", wrong("U = T*sqrt(g/a)", U=U)
                ),
                mistake("The period goes with the root of gravity.", wrong("U = T*a/g", U=U)),
            ],
        ),
        step(
            D,
            "From one period to another the length goes with the square.",
            law("Period of a pendulum", "D = a*tick^2/(4*pi^2)", D=D),
            answers="c",
            mistakes=[
                mistake("That is the length on Earth.", wrong("D = g*tick^2/(4*pi^2)", D=D)),
                mistake("The length goes with the square of the period.", wrong("D = L*tick/T", D=D)),
            ],
        ),
    )


def scene(L, n, t, tick, g, answer):
    """A pendulum on a rod, let go a thousandth of a radian aside: half a period later it is on the other side."""
    small = 1e-3
    nail = Body(float("inf"), (0.0, 0.0), (0.0, 0.0))
    bob = Body(0.1, (L * sin(small), -L * sin(pi / 2 - small)), (0.0, 0.0))
    half = Scene((nail, bob), (Rod((0, 1)), Weight(answer["a"])), until=t / n / 2)
    return [simulate(half, trajectory=(0.0, 0.0, -bob.place[0], bob.place[1]), neglected=small**2)]
