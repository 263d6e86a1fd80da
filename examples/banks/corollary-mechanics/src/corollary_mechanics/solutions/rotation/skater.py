"""A turning skater: the angular momentum stays, the energy does not."""

from math import cos, pi, sin, sqrt

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


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
