"""Ball colliding with the floor: energy gives the velocity after it, momentum the mean force."""

from corollary.author import simulate


def scene(m, v0, dt, g, answer):
    """The mean net force, for the time of contact, turns the velocity round."""
    return [
        simulate(
            "kick", {"m": m, "v0": v0, "F": answer["b"], "dt": dt}, velocities=(-v0,), impulse=answer["a"]
        )
    ]
