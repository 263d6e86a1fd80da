"""Pendulum and block: energy on the way down and up, momentum and energy in the collision."""

import math

from corollary.author import simulate


def scene(m, M, L, g, answer, neglected):
    """Sphere and block during the collision, from Newton's second law; and the whole way of the pendulum, with a touch that takes its time."""
    whole = {"m": m, "M": M, "L": L, "g": g}
    return [
        simulate("cradle", {"N": 2, "masses": (m, M), "v0": answer["a0"]}, velocities=answer["a"]),
        simulate(
            "pendulum_block",
            whole,
            velocities=answer["a"],
            neglected=neglected["a"] / math.hypot(*answer["a"]),
        ),
        simulate(
            "pendulum_block", whole, animated=True, height=answer["b"], neglected=neglected["b"] / answer["b"]
        ),
    ]
