"""Down a playground slide: what is missing in the energy has been the work of friction."""

from math import asin, sqrt

from corollary.author import simulate


def scene(m, h, v, L, g, answer):
    """A straight slide, smooth and then as rough as it takes for the mean friction: the bank's own ready-made scene."""
    sine, cosine = h / L, sqrt(1 - (h / L) ** 2)
    rough = answer["c"] / (m * g * cosine)
    return [
        simulate(
            "slide",
            {"m": m, "theta": asin(sine), "mu": mu, "g": g, "t": 2 * L / speed},
            velocities=(speed * cosine, -speed * sine),
        )
        for mu, speed in ((0.0, answer["a"]), (rough, v))
    ]
