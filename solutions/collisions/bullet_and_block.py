"""Bullet and a block: work and energy on the rough table, momentum in the hit."""

from corollary.author import simulate


def scene(m, M, mu, d, g, answer):
    """A bullet of the speed found is braked inside the block; then friction stops both, where it must."""
    return [
        simulate(
            "bullet_block",
            {"m": m, "M": M, "mu": mu, "g": g, "v": answer["a"]},
            animated=True,
            distance=d,
            energy_change=answer["b"],
        )
    ]
