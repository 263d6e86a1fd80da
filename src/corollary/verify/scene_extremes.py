"""Scenes at the ends of the range: each obeys a law that must hold there, or is refused in a sentence."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from corollary.scenes.catalogue import run
from corollary.scenes.run import BadSetting, GuardFailed, Observed, Run

# A law is met when it is off by no more than the run says of itself, and a few roundings.
ROUNDING = 2e-14


@dataclass(frozen=True, slots=True)
class Law:
    """What must hold of one observed value: `off` says by how much a run misses it (relative; nan when it cannot be told)."""

    observed: str
    off: Callable[[Run], float]


@dataclass(frozen=True, slots=True)
class Extreme:
    """A scene far out, and a law that holds there."""

    what: str
    scene: str
    settings: Mapping[str, Observed]
    law: Law


@dataclass(frozen=True, slots=True)
class Met:
    """`outcome` is that of the run, or `refused`; then `said` is the sentence. `off` is how far the law was missed, `stated` the
    error the run states for what it observed."""

    what: str
    scene: str
    outcome: str
    said: str
    off: float
    stated: float
    seconds: float

    @property
    def ok(self) -> bool:
        return self.outcome == "refused" or self.off <= self.stated + ROUNDING


def play(extreme: Extreme) -> Met:
    """Run one; a refusal is an outcome."""
    begin = time.perf_counter()
    try:
        found = run(extreme.scene, extreme.settings)
    except (BadSetting, GuardFailed) as refused:
        return Met(
            extreme.what, extreme.scene, "refused", str(refused), 0.0, 0.0, time.perf_counter() - begin
        )
    off, stated = extreme.law.off(found), found.errors[extreme.law.observed]
    seconds = time.perf_counter() - begin
    # A law that cannot even be evaluated is broken.
    return Met(
        extreme.what,
        extreme.scene,
        found.outcome,
        found.why,
        math.inf if math.isnan(off) else off,
        stated,
        seconds,
    )


def numbers(seen: Observed) -> tuple[float, ...]:
    return seen if isinstance(seen, tuple) else (seen,)


def row_law(*masses: float) -> Law:
    """Momentum and energy of a row whose first body came in at 1 m/s: relative to what it brought."""
    shares = [m / masses[0] for m in masses]

    def off(found: Run) -> float:
        velocities = numbers(found.observed["velocities"])
        momentum = math.fsum(s * v for s, v in zip(shares, velocities, strict=True)) - 1.0
        energy = math.fsum(s * v * v for s, v in zip(shares, velocities, strict=True)) - 1.0
        return max(abs(momentum), abs(energy))

    return Law("velocities", off)


def meets(name: str, *expected: float, within: float = 0.0) -> Law:
    """An observed value against a closed form; relative to its length. Where the form is a limit, it may be off by `within`."""

    def off(found: Run) -> float:
        seen = numbers(found.observed[name])
        size = math.hypot(*expected) or 1.0
        return max(math.dist(seen, expected) / size - within, 0.0) if len(seen) == len(expected) else math.nan

    return Law(name, off)


def ends(outcome: str, then: Law) -> Law:
    """The run ends so, and the law holds."""
    return Law(then.observed, lambda found: then.off(found) if found.outcome == outcome else math.nan)


def two(ma: float, mb: float, va: float, vb: float, r: float) -> tuple[float, float]:
    """Velocities of two bodies after a collision with restitution r."""
    change = (1.0 + r) * (va - vb) / (ma + mb)
    return va - mb * change, vb + ma * change


def pair_law(ma: float, mb: float, name: str = "velocities") -> Law:
    """Momentum of two spheres of which A came in at (1, 0), and their energy if undamped: relative to what A brought."""

    def off(found: Run) -> float:
        ax, ay, bx, by = numbers(found.observed[name])
        share = mb / ma
        momentum = math.hypot(ax + share * bx - 1.0, ay + share * by)
        energy = ax * ax + ay * ay + share * (bx * bx + by * by) - 1.0
        return max(momentum, abs(energy) if not found.settings["eta"] else max(energy, 0.0))

    return Law(name, off)


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
