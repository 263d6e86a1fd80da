"""Newton's cradle: what the conservation laws fix, what they leave open, and what the contact decides."""

from corollary.author import (
    module,
    simulate,
)

ROW = module("newtons_cradle/judge_cradle.py")
FIGURE = module("newtons_cradle/judge_velocity_plot.py")


def scene(m, h0, r, k, v0, g, answer):
    """Two balls from Newton's second law, at the height's speed and at v0; three with gaps for the separate collisions."""
    gap = 100 * v0 * answer["h1"]
    return [
        simulate("cradle", {"N": 2, "q": 1, "m": m, "k": k, "v0": answer["a"]}, velocities=answer["b"]),
        simulate(
            "cradle",
            {"N": 2, "q": 1, "m": m, "k": k, "v0": v0},
            duration=answer["h1"],
            largest_overlap=answer["h2"],
        ),
        simulate(
            "cradle",
            {"N": 3, "q": 1, "m": m, "k": k, "v0": v0, "gaps": (0.0, gap)},
            animated=True,
            velocities=answer["f2"],
        ),
    ]
