"""Lifting a chain: every link is caught in a small collision of its own."""

from corollary.author import simulate


def scene(m, L, v0, y, g, answer):
    """A hundred thousand links picked up one by one."""
    return [
        simulate(
            "chain",
            {"N": 100000, "m": m, "L": L, "v0": v0, "g": g, "y": y},
            neglected=2e-5,
            mean_force=answer["a"],
            work=answer["b"],
            energy_lost=answer["c"],
        )
    ]
