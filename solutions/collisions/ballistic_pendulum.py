"""Ballistic pendulum: momentum in the hit, energy in the swing, and never the other way round."""

from corollary.author import simulate


def scene(mA, mB, h, L, g, answer, neglected):
    """The bullet of the speed found is braked inside the block; and as slowly as supposed, in a block that hangs."""
    shot = {"g": g, "v": answer["a"]}
    return [
        simulate(
            "bullet_block",
            shot | {"m": mA, "M": mB},
            velocities=(answer["c"], answer["c"]),
            energy_change=answer["b"],
        ),
        simulate(
            "ballistic_pendulum",
            shot | {"mA": mA, "mB": mB, "L": L, "dt": 1e-3},
            animated=True,
            height=h,
            angle=answer["d"],
            neglected=2 * neglected["a"] / answer["a"],
        ),
    ]
