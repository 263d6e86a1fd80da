"""Kicking a ball: an impulse is a change of momentum, and a force is how fast it comes."""

from corollary.author import simulate


def scene(m, v, w, dt, answer):
    """A push of the mean force found, over the time of contact, must give the ball its velocity."""
    return [
        simulate(
            "kick",
            {"m": m, "v0": 0.0, "F": answer["c"], "dt": dt},
            animated=True,
            velocities=(v,),
            impulse=answer["b"],
        ),
        simulate("kick", {"m": m, "v0": -w, "F": answer["d"], "dt": dt}, velocities=(v,)),
    ]
