"""Hitting a tennis ball: momentum is a vector, and an impulse is a difference of vectors."""

import math

from corollary.author import simulate


def scene(m, v0, v1, w, alpha, dt, g, answer, neglected):
    """A push of the mean force found, over the time of contact, for each component; and the lob with the weight besides."""
    push = {"m": m, "dt": dt}
    return [
        simulate("kick", {**push, "v0": -v0, "F": answer["b"][0]}, velocities=(v1,), impulse=answer["a"][0]),
        simulate(
            "kick",
            {**push, "v0": -v0, "F": answer["c2"][0]},
            velocities=(w * math.cos(alpha),),
            impulse=answer["c1"][0],
        ),
        simulate(
            "kick",
            {**push, "v0": 0.0, "F": answer["c2"][1]},
            velocities=(w * math.sin(alpha),),
            impulse=answer["c1"][1],
        ),
        simulate(
            "kick",
            {**push, "v0": 0.0, "F": answer["c2"][1] - m * g},
            velocities=(w * math.sin(alpha),),
            neglected=neglected["c2"] / answer["c2"][1],
        ),
    ]
