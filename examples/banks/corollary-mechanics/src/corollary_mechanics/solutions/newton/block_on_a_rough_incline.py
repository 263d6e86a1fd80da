"""Down a rough incline: the normal force, friction, and what is left to accelerate."""

from math import cos, sin

from corollary.author import simulate


def scene(m, theta, mu, L, g, answer):
    """The bank's own ready-made scene, watched for the time that the slide takes."""
    v = answer["c"]
    return [
        simulate(
            "slide",
            {"m": m, "theta": theta, "mu": mu, "g": g, "t": 2 * L / v},
            velocities=(v * cos(theta), -v * sin(theta)),
            trajectory=(L * cos(theta), -L * sin(theta)),
        )
    ]
