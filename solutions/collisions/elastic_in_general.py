"""General elastic collision: momentum and energy, with both blocks moving."""

from corollary.author import simulate


def scene(mA, mB, vA, vB, answer):
    """Two elastic spheres, head-on, from Newton's second law."""
    settings = {
        "mA": mA,
        "mB": mB,
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (vA, 0.0),
        "vB": (vB, 0.0),
    }
    return [simulate("spheres", settings, animated=True, velocities=(answer["a"], 0.0, answer["b"], 0.0))]
