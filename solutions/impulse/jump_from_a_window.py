"""Jump from a window: the fall fixes the change of momentum, the landing only shares it out over time or way."""

from corollary.author import simulate


def scene(h, m, dt, s, g, answer):
    """The film run backwards: the net force the other way brings you from rest to the speed of the landing."""
    return [
        simulate(
            "kick",
            {"m": m, "v0": 0.0, "F": answer["c"], "dt": dt},
            velocities=(answer["a"],),
            impulse=answer["b"],
        )
    ]
