"""Stopping a car: the same change of velocity, and a seatbelt that takes its time."""

from corollary.author import simulate


def scene(v, M, dt, md, td, answer):
    """The film run backwards: the same forces the other way bring car and dummy from rest to v."""
    return [
        simulate("kick", {"m": M, "v0": 0.0, "F": -answer["a"], "dt": dt}, velocities=(v,)),
        simulate("kick", {"m": md, "v0": 0.0, "F": -answer["b"], "dt": td}, velocities=(v,)),
    ]
