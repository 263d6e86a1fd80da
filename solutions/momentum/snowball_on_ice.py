"""Snowball on ice: momentum is kept along the ice, where nothing pushes from outside."""

from corollary.author import simulate


def scene(M, Ms, m, v, theta, answer):
    """A throw and a catch by forces between two bodies at a time."""
    return [
        simulate(
            "snowball",
            {"M": M, "Ms": Ms, "m": m, "v": v, "theta": theta},
            animated=True,
            momentum=answer["a"],
            velocities_after_throw=(answer["b"], answer["b2"]),
            velocities=(answer["c"], answer["c2"]),
        )
    ]
