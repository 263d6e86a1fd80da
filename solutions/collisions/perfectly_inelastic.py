"""Perfectly inelastic collision: momentum alone, and what it costs in kinetic energy."""

from corollary.author import simulate


def scene(mA, mB, vA, vB, answer):
    """A gets stuck in B, seen from B: then B is at rest before, and every velocity is less by B's."""
    free = {"m": mA, "M": mB}
    return [
        simulate(
            "bullet_block",
            free | {"v": vA},
            animated=True,
            velocities=(answer["a"], answer["a"]),
            energy_change=answer["c"],
        ),
        simulate(
            "bullet_block",
            free | {"v": vA - vB},
            velocities=(answer["d"] - vB, answer["d"] - vB),
            energy_change=answer["e"],
        ),
    ]
