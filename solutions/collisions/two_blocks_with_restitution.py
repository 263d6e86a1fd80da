"""Two blocks on a line with restitution: momentum, and what is left of the relative velocity."""

import math

from corollary.author import simulate


def scene(mA, mB, vA, vB, r, answer):
    """Two soft spheres, head-on, with just as much damping in the contact as r asks for."""
    k, loss, mass = 1e9, -math.log(r), mA * mB / (mA + mB)
    eta = 2 * math.sqrt(k * mass) * loss / math.hypot(math.pi, loss)
    settings = {
        "mA": mA,
        "mB": mB,
        "k": k,
        "q": 1,
        "eta": eta,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (vA, 0.0),
        "vB": (vB, 0.0),
    }
    before = (mA * vA * vA + mB * vB * vB) / 2
    return [
        simulate(
            "spheres",
            settings,
            animated=True,
            velocities=(answer["a"], 0.0, answer["b"], 0.0),
            energy_ratio=1 + answer["c"] / before,
        )
    ]
