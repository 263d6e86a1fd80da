"""A turning skater: the angular momentum stays, the energy does not."""

from math import cos, pi, sin, sqrt

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(I, J, n):
    f, W = unknowns("f W")
    return derivation(
        step(
            f,
            "No torque acts about the axis; the factor $2\\pi$ stands on both sides.",
            law("Conservation of angular momentum", "I*n = J*f"),
            answers="a",
            mistakes=[
                mistake(
                    "Her energy does change: she pulls. What stays the same when no torque acts?",
                    wrong("I*n^2 = J*f^2"),
                    where=f > 0,
                ),
                mistake(
                    "With her arms drawn in she should turn faster, not more slowly.", wrong("J*n = I*f")
                ),
            ],
        ),
        step(
            W,
            "Work is the change of kinetic energy, with the angular velocity $2\\pi$ times the turns per "
            "second.",
            law("Work and kinetic energy", "W = J*(2*pi*f)^2/2 - I*(2*pi*n)^2/2", W=W),
            answers="b",
            mistakes=[
                mistake(
                    "The angular velocity is in radians: each turn counts $2\\pi$.",
                    wrong("W = J*f^2/2 - I*n^2/2", W=W),
                ),
                mistake(
                    "That is the kinetic energy in the end; some was there before.",
                    wrong("W = J*(2*pi*f)^2/2", W=W),
                ),
                mistake(
                    "Her moment of inertia is another one afterwards.",
                    wrong("W = I*(2*pi*f)^2/2 - I*(2*pi*n)^2/2", W=W),
                ),
            ],
            check="It is positive: she must pull.",
        ),
        choice(
            "c",
            "The arms move inwards along the force that keeps them on their circle.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Friction would take energy, and angular momentum with it.",
                "c": "Compare the two kinetic energies.",
            },
        ),
    )


def scene(I, J, n, answer):
    """A kilogram on a rope round the axis, at the distance that makes its moment of inertia I, drawn in evenly to that of J.

    The rope pulls along the radius alone. How fast it goes round in the end, and with what energy, is Newton's second law.
    """
    far, near, drawn = sqrt(I), sqrt(J), 0.5

    def pull(t, place, velocity):
        x, y = place
        across = (x * velocity[1] - y * velocity[0]) / (x * x + y * y)  # the angular velocity
        return -x * across**2, -y * across**2

    stone = Body(1.0, (far, 0.0), (-drawn, 2 * pi * n * far))
    angle, round_axis = 2 * pi * n * I / drawn * (1 / near - 1 / far), 2 * pi * answer["a"] * near
    return [
        simulate(
            Scene((stone,), (ForceFunction(0, pull),), until=(far - near) / drawn),
            velocities=(
                -drawn * cos(angle) - round_axis * sin(angle),
                -drawn * sin(angle) + round_axis * cos(angle),
            ),
            energy=I * (2 * pi * n) ** 2 / 2 + answer["b"] + drawn**2 / 2,
        )
    ]
