"""Pulled and let go: period, and energy to and fro."""

from math import pi, sqrt

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.scene import Body, Scene


def derive(m, k, A):
    T, v, u, low, high = unknowns("T v u low high")
    return derivation(
        step(
            T,
            "A body on a linear spring.",
            law("Period of an oscillator", "T = 2*pi*sqrt(m/k)"),
            answers="a",
            mistakes=[
                mistake(
                    "A heavier glider is slower, a stiffer spring makes it faster: look at the fraction.",
                    wrong("T = 2*pi*sqrt(k/m)"),
                ),
                mistake(
                    "That is the time for a radian. A whole oscillation is a full turn of the phase.",
                    wrong("T = sqrt(m/k)"),
                ),
                mistake("That is how long it takes from one side to the other.", wrong("T = pi*sqrt(m/k)")),
            ],
        ),
        step(
            v,
            "At equilibrium all the energy is kinetic; where it turned, all of it was the spring's.",
            law("Conservation of energy", "k*A^2/2 = m*v^2/2", A=A),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake("The mean speed over a period is less than the largest.", wrong("v = 4*A/T", A=A)),
                mistake(
                    "That is the amplitude times the frequency; the angular frequency has a factor more.",
                    wrong("v = A/T", A=A),
                ),
            ],
        ),
        step(
            u,
            "Halfway a quarter of the energy is the spring's.",
            law("Conservation of energy", "k*A^2/2 = m*u^2/2 + k*(A/2)^2/2", A=A, u=u),
            where=u > 0,
            answers="c",
            mistakes=[
                mistake(
                    "The speed does not grow in proportion to the way; energies go with squares.",
                    wrong("u = v/2", u=u),
                ),
                mistake(
                    "The spring's energy goes with the square of the distance: halfway it is not a half.",
                    wrong("k*A^2/2 = m*u^2/2 + k*A^2/4", A=A, u=u),
                    where=u > 0,
                ),
            ],
            check="Halfway it has 87 % of its largest speed already.",
        ),
        step(
            (low, high),
            "At half of the largest speed a quarter of the energy is kinetic, on either side.",
            law("Conservation of energy", "k*A^2/2 = m*(v/2)^2/2 + k*x^2/2", A=A, v=v, x=low),
            law("On the other side", "high = -low"),
            where=low < 0,
            answers="e",
            mistakes=[
                mistake(
                    "Speed and distance do not go together in proportion; energies go with squares.",
                    law("In proportion", "low = -A/2", A=A),
                    instead="Conservation of energy",
                ),
                mistake(
                    "It swings to both sides of its position of equilibrium.",
                    law("One side", "high = 0"),
                    instead="On the other side",
                ),
            ],
            check="It is nearly all of the way: 87 % of it.",
        ),
        choice(
            "d",
            "Everything is twice as fast and twice as far.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "The way is longer. What does the stronger pull do to the speed?",
                "c": "The way is longer. What does the stronger pull do to the speed?",
            },
        ),
    )


def scene(m, k, A, answer):
    """A spring between a nail and a body: a quarter of a period, and a sixth, when the cosine is one half."""
    nail, glider = Body(float("inf"), (0.0,), (0.0,)), Body(m, (1.0 + A,), (0.0,))
    quarter = Scene((nail, glider), (Spring((0, 1), k, length=1.0),), until=answer["a"] / 4)
    sixth = Scene((nail, glider), (Spring((0, 1), k, length=1.0),), until=pi / 3 * sqrt(m / k))
    return [
        simulate(quarter, trajectory=(0.0, 1.0), velocities=(0.0, -answer["b"])),
        simulate(sixth, trajectory=(0.0, 1.0 + A / 2), velocities=(0.0, -answer["c"])),
    ]
