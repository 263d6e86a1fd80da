"""Golf ball: a heavy club sends a light ball off faster than itself."""

import math

from corollary.author import simulate


def scene(v, M, m, r, answer):
    """Club and ball as two spheres, head-on: without damping, and with as much of it as r asks for."""
    k, loss, mass = 1e9, -math.log(r), M * m / (M + m)
    eta = 2 * math.sqrt(k * mass) * loss / math.hypot(math.pi, loss)
    hit = {"mA": M, "mB": m, "k": k, "q": 1, "dx": 0.08, "dy": 0.0, "vA": (v, 0.0), "vB": (0.0, 0.0)}
    return [
        simulate(
            "spheres",
            hit | {"eta": 0.0},
            animated=True,
            velocities=(v - m / M * answer["b"], 0.0, answer["b"], 0.0),
        ),
        simulate("spheres", hit | {"eta": eta}, velocities=(v - m / M * answer["c"], 0.0, answer["c"], 0.0)),
    ]
