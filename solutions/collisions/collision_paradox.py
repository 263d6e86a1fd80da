"""A collision paradox: kinetic energy depends on the observer, its change in a collision does not."""

from corollary.author import simulate


def scene(m, v0, u, m2, w, answer):
    """One car gets stuck in the other, seen from the other, where the change of kinetic energy must be the same."""
    return [
        simulate(
            "bullet_block", {"m": m, "M": m, "v": 2 * v0}, velocities=(v0, v0), energy_change=answer["e"]
        ),
        simulate("bullet_block", {"m": m, "M": m2, "v": v0 + w}, energy_change=answer["h"]),
    ]
