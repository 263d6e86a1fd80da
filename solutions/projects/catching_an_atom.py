"""Catching an atom: a well, a sticking collision in it, and what a plane adds: angular momentum."""

import math

from corollary.author import (
    module,
    simulate,
)

ORBIT = module("catching_an_atom/judge_orbit.py")
CAUGHT = module("catching_an_atom/judge_catch.py")
FIGURE = module("catching_an_atom/judge_orbit_plot.py")


def scene(m, k, b, d, vA0, x, xp, yp, eps, epsx, v0, v, s, alpha, v1, answer):
    """The atom bound on a line and across it, falling in, circling, and the pair (as light and as hard as one atom) just out and just not."""
    well = {"m": m, "k": k, "b": b, "d": d}
    line, edge, swift = well | {"dimension": 1}, (b + d) * (1 - 1e-9), 1 + 1e-9
    near, far = answer["a1"]
    pair = well | {"m": 2 * m, "k": 2 * k}
    sin, cos = math.sin(alpha), math.cos(alpha)
    return [
        simulate("atom", line | {"r0": near, "v0": 0.0}, turning_points=(near, far), period=answer["a2"]),
        simulate("atom", line | {"r0": b, "v0": math.sqrt(epsx * k / m) * d}, velocities=answer["a3"]),
        simulate("atom", line | {"r0": b, "v0": -answer["c"]}, velocities=vA0),
        simulate(
            "atom",
            well | {"r0": b, "v0": v0},
            turning_points=(b, answer["h1"]),
            period=answer["h2"],
            angle=answer["h3"],
        ),
        simulate(
            "atom",
            well | {"r0": answer["i1"], "v0": v},
            turning_points=(answer["i1"], answer["i1"]),
            neglected=1e-7,
        ),
        simulate(
            "atom",
            pair | {"r0": (b, 0.0), "v0": (swift * answer["k2"] / 2 * cos, swift * answer["k2"] / 2 * sin)},
            escapes=1.0,
        ),
        simulate(
            "atom",
            pair | {"r0": (b, 0.0), "v0": (answer["k2"] / 2 / swift * cos, answer["k2"] / 2 / swift * sin)},
            escapes=0.0,
        ),
        *(
            simulate(
                "atom",
                pair | {"r0": (b, 0.0), "v0": halved(m, k, b, d, s, answer["k3"] * share)},
                escapes=out,
            )
            for share, out in ((swift, 1.0), (1 / swift, 0.0))
        ),
        simulate(
            "atom", well | {"r0": (b, 0.0), "v0": halved(m, k, b, d, 0.0, answer["e"] * swift)}, escapes=1.0
        ),
        simulate("atom", well | {"r0": edge, "v0": (0.0, 0.999 * answer["i2"])}, escapes=0.0),
    ]


def halved(m, k, b, d, s, v):
    """Velocity of the pair just after the collision at (b, 0), when A had the speed v and the impact parameter s outside."""
    across = v * s / b
    return math.sqrt(v**2 + k * d**2 / m - across**2) / 2, across / 2
