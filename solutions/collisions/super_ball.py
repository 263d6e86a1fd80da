"""Super-ball: a fall, a floor, and an elastic collision, one after the other."""

import math

from corollary.author import simulate


def scene(mA, mB, h0, g, answer, neglected):
    """A, on its way up, meets B on its way down, as two elastic spheres; the fall again with its own weight; and all of it in one go.

    There the balls are weighed while they touch, as hard ones do for some tenths of a millisecond.
    """
    fall = answer["a"]
    met = {
        "mA": mA,
        "mB": mB,
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (fall, 0.0),
        "vB": (-fall, 0.0),
    }
    dropped = {"mA": mA, "mB": mB, "h0": h0, "g": g, "q": 1.0, "k": 1e9, "weighed": 1}
    return [
        simulate("spheres", met, velocities=(answer["c"], 0.0, answer["b"], 0.0)),
        simulate(
            "spheres",
            met | {"mA": 1e6 * mB},
            neglected=1e-5,
            velocities=(fall, 0.0, math.sqrt(2 * g * answer["e"]), 0.0),
        ),
        simulate(
            "ball_on_floor", {"m": mA, "g": g, "R": 0.02, "y0": 0.02 + h0, "v0": 0.0}, rebound_speed=fall
        ),
        simulate(
            "super_ball",
            dropped,
            animated=True,
            heights=(answer["c"] ** 2 / (2 * g), answer["d"]),
            neglected=neglected["d"] / answer["d"],
        ),
    ]
