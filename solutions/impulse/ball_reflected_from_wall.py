"""Ball reflected from a wall: momentum is a vector, and only one component of it is turned round."""

from corollary.author import simulate


def scene(m, v0, theta, dt, answer):
    """A smooth wall that gives like a spring and lets go after dt."""
    return [
        simulate(
            "wall",
            {"m": m, "v0": v0, "theta": theta, "dt": dt},
            animated=True,
            momentum_change=answer["a"],
            impulse=answer["b"],
            mean_force=answer["c"],
        )
    ]
