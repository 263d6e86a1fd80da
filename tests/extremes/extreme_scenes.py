"""The scenes far out that `corollary verify --extremes` runs, and the law that each must meet."""

from __future__ import annotations

import math

from .extreme_runs import Extreme
from .scene_laws import ends, meets, pair_law, row_law, two

HERTZ = (-0.070952353651436871, 0.076403039071206993, 0.994549314580229878)
"""Three equal balls with Hertz contacts, speed one; the 30-digit reference of the tests."""


def extremes() -> tuple[Extreme, ...]:
    """The table that `corollary verify --extremes` runs."""
    hertz, far, near = {"q": 1.5}, 2.0, 1e-12
    spring, critical = {"q": 1.0, "g": 0.0, "y0": 0.02}, 2.0 * math.sqrt(1e6 * 0.1)
    edge = math.sqrt(50.0 * 0.16 / (1.0 - 1.0 / 1.96))
    return (
        *(
            Extreme(
                f"middle ball {m:g} times as heavy",
                "cradle",
                {"masses": (1.0, m, 1.0), **hertz},
                row_law(1.0, m, 1.0),
            )
            for m in (1e-3, 1e9)
        ),
        Extreme(
            "middle ball 1e-9 times as heavy", "cradle", {"masses": (1.0, 1e-9, 1.0)}, row_law(1.0, 1e-9, 1.0)
        ),
        Extreme(
            "first ball 1e-9 times as heavy",
            "cradle",
            {"masses": (1e-9, 1.0, 1.0), **hertz},
            row_law(1e-9, 1.0, 1.0),
        ),
        Extreme(
            "last ball 1e-9 times as heavy",
            "cradle",
            {"masses": (1.0, 1.0, 1e-9), **hertz},
            row_law(1.0, 1.0, 1e-9),
        ),
        Extreme(
            "first ball 1e9 times as heavy",
            "cradle",
            {"masses": (1e9, 1.0, 1.0), **hertz},
            row_law(1e9, 1.0, 1.0),
        ),
        *(
            Extreme(
                f"mass of A {m:g} kg",
                "two_blocks",
                {"mA": m, "r": 1.0},
                meets("velocities", *two(m, 3.0, 5.0, -1.0, 1.0)),
            )
            for m in (1e-150, 1e-12, 1e12, 1e150)
        ),
        *(
            Extreme(f"stiffness {k:g}", "cradle", {"k": k, **hertz}, meets("velocities", *HERTZ))
            for k in (1e-12, 1e12)
        ),
        *(
            Extreme(
                f"speed {v:g} m/s", "cradle", {"v0": v, **hertz}, meets("velocities", *(v * u for u in HERTZ))
            )
            for v in (1e-150, 1e150)
        ),
        *(Extreme(f"exponent {q:g}", "cradle", {"q": q}, row_law(1.0, 1.0, 1.0)) for q in (1.0, 1.001, 10.0)),
        Extreme("20 balls", "cradle", {"N": 20.0}, row_law(*[1.0] * 20)),
        Extreme("200 balls", "cradle", {"N": 200.0}, row_law(*[1.0] * 200)),
        Extreme(
            "ten balls that just touch", "cradle", {"N": 10.0, "gaps": 0.0, **hertz}, row_law(*[1.0] * 10)
        ),
        Extreme(
            "gaps of the least denormal", "cradle", {"gaps": 5e-324, **hertz}, meets("velocities", *HERTZ)
        ),
        *(
            Extreme(
                f"restitution {r:g}",
                "two_blocks",
                {"r": r},
                meets("velocities", *two(2.0, 3.0, 5.0, -1.0, r)),
            )
            for r in (0.0, 1e-9, 1.0)
        ),
        Extreme(
            "inelastic collapse",
            "bouncing_ball",
            {"r": 0.9, "n": 1000.0},
            meets("rests_after", math.sqrt(2.0 * far / 9.8) * 19.0),
        ),
        Extreme("a ball that never rises", "bouncing_ball", {"r": 0.0}, meets("heights", 0.0, 0.0, 0.0)),
        Extreme(
            "grazing by 1e-10",
            "spheres",
            {"eta": 0.0, "dy": 0.04 * (1.0 - 1e-10)},
            ends("released", meets("energy_ratio", 1.0)),
        ),
        Extreme(
            "missing by 1e-10",
            "spheres",
            {"dy": 0.04 * (1.0 + 1e-10)},
            ends("missed", meets("velocities", 1.0, 0.0, 0.0, 0.0)),
        ),
        Extreme(
            "grazing by 1e-10, damped",
            "spheres",
            {"dy": 0.04 * (1.0 - 1e-10)},
            ends("released", meets("velocities", 1.0, 0.0, 0.0, 0.0, within=2.0 * math.sqrt(2e-10))),
        ),
        Extreme("head-on", "spheres", {"eta": 0.0, "dy": 0.0}, meets("velocities", 0.0, 0.0, 1.0, 0.0)),
        Extreme(
            "1e-12 m from head-on",
            "spheres",
            {"eta": 0.0, "dy": near},
            meets("velocities", 0.0, 0.0, 1.0, 0.0, within=1e-9),
        ),
        *(
            Extreme(
                f"mass of A {m:g} kg, {'damped' if eta else 'undamped'}",
                "spheres",
                {"mA": m, "eta": eta},
                pair_law(m, 0.1),
            )
            for eta in (0.0, 1e-12)
            for m in (1e-150, 1e-12, 1e-9)
        ),
        *(
            # Of a heavy A the law of the pair would not see B: here it leaves head-on with twice A's speed.
            Extreme(
                f"mass of A {m:g} kg, {'damped' if eta else 'undamped'}",
                "spheres",
                {"mA": m, "eta": eta, "dy": 0.0},
                meets(
                    "velocities",
                    two(m, 0.1, 1.0, 0.0, 1.0)[0],
                    0.0,
                    two(m, 0.1, 1.0, 0.0, 1.0)[1],
                    0.0,
                    within=1e-11 if eta else 0.0,
                ),
            )
            for eta in (0.0, 1e-12)
            for m in (1e9, 1e12, 1e150)
        ),
        Extreme("head-on and too soft", "spheres", {"k": 1.0, "dy": 0.0}, pair_law(0.1, 0.1)),
        *(
            Extreme(f"stiffness {k:g}", "spheres", {"k": k, "eta": 0.0}, pair_law(0.1, 0.1))
            for k in (1e-12, 1e12)
        ),
        *(
            Extreme(f"exponent {q:g}", "spheres", {"q": q, "k": 2e4 * 0.005 ** (1.5 - q)}, pair_law(0.1, 0.1))
            for q in (1.0, 10.0)
        ),
        *(
            Extreme(
                f"speed {v:g} m/s",
                "spheres",
                {"vA": (v, 0.0), "k": 2e4 * v**2, "eta": 0.0, "dy": 0.0},
                meets("velocities", 0.0, 0.0, v, 0.0),
            )
            for v in (1e-150, 1e150)
        ),
        *(
            Extreme(
                f"damping {eta:g}, past sticking",
                "spheres",
                {"eta": eta},
                ends("sticks", meets("velocities", 0.5, 0.0, 0.5, 0.0)),
            )
            for eta in (9.6, 1e3)
        ),
        *(
            Extreme(
                f"damping {eta:g}, past sticking",
                "ball_on_floor",
                {"eta": eta},
                ends("sticks", meets("rebound_speed", 0.0)),
            )
            for eta in (1e3, 1e6, 1e12)
        ),
        *(
            Extreme(
                f"{c:.9f} of the critical damping",
                "ball_on_floor",
                {**spring, "eta": c * critical},
                meets("rebound_speed", back),
            )
            for c, back in (
                (0.5, 2.8 * math.exp(-math.pi / math.sqrt(3.0))),
                (1.0 - 1e-9, 0.0),
                (1.0 + 1e-9, 0.0),
            )
        ),
        *(
            Extreme(
                f"speed {v:g} m/s",
                "ball_on_floor",
                {"v0": -v, "y0": 0.02, "g": 0.0},
                meets("rebound_speed", v),
            )
            for v in (1e-150, 1e150)
        ),
        Extreme("exponent 10", "ball_on_floor", {"q": 10.0, "k": 1e30}, meets("energy_ratio", 1.0)),
        Extreme(
            "an orbit just inside the rim",
            "atom",
            {"v0": edge * (1.0 - 1e-9)},
            ends("bound", meets("escapes", 0.0)),
        ),
        Extreme(
            "an orbit just over the rim",
            "atom",
            {"v0": edge * (1.0 + 1e-9)},
            ends("escaped", meets("escapes", 1.0)),
        ),
        Extreme(
            "straight onto the core",
            "atom",
            {"r0": 2.0, "v0": (-5.0, 0.0)},
            ends("escaped", meets("velocities", 5.0, 0.0)),
        ),
        Extreme(
            "1e-12 from along the wall",
            "wall",
            {"theta": near},
            meets("velocities", 8.0 * math.cos(near), 8.0 * math.sin(near)),
        ),
        Extreme(
            "1e-12 from square to the wall",
            "wall",
            {"theta": 0.5 * math.pi - near},
            meets("velocities", 8.0 * near, 8.0),
        ),
    )
