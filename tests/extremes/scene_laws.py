"""What must hold of a run however extreme: momentum, energy, closed forms and their limits."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from corollary.scenes.run import Observed, Run


@dataclass(frozen=True, slots=True)
class SceneLaw:
    """What must hold of one observed value: `off` says by how much a run misses it (relative; nan when it cannot be told)."""

    observed: str
    off: Callable[[Run], float]


def numbers(seen: Observed) -> tuple[float, ...]:
    return seen if isinstance(seen, tuple) else (seen,)


def row_law(*masses: float) -> SceneLaw:
    """Momentum and energy of a row whose first body came in at 1 m/s: relative to what it brought."""
    shares = [m / masses[0] for m in masses]

    def off(found: Run) -> float:
        velocities = numbers(found.observed["velocities"])
        momentum = math.fsum(s * v for s, v in zip(shares, velocities, strict=True)) - 1.0
        energy = math.fsum(s * v * v for s, v in zip(shares, velocities, strict=True)) - 1.0
        return max(abs(momentum), abs(energy))

    return SceneLaw("velocities", off)


def meets(name: str, *expected: float, within: float = 0.0) -> SceneLaw:
    """An observed value against a closed form; relative to its length. Where the form is a limit, it may be off by `within`."""

    def off(found: Run) -> float:
        seen = numbers(found.observed[name])
        size = math.hypot(*expected) or 1.0
        return max(math.dist(seen, expected) / size - within, 0.0) if len(seen) == len(expected) else math.nan

    return SceneLaw(name, off)


def ends(outcome: str, then: SceneLaw) -> SceneLaw:
    """The run ends so, and the law holds."""
    return SceneLaw(then.observed, lambda found: then.off(found) if found.outcome == outcome else math.nan)


def two(ma: float, mb: float, va: float, vb: float, r: float) -> tuple[float, float]:
    """Velocities of two bodies after a collision with restitution r."""
    change = (1.0 + r) * (va - vb) / (ma + mb)
    return va - mb * change, vb + ma * change


def pair_law(ma: float, mb: float, name: str = "velocities") -> SceneLaw:
    """Momentum of two spheres of which A came in at (1, 0), and their energy if undamped: relative to what A brought."""

    def off(found: Run) -> float:
        ax, ay, bx, by = numbers(found.observed[name])
        share = mb / ma
        momentum = math.hypot(ax + share * bx - 1.0, ay + share * by)
        energy = ax * ax + ay * ay + share * (bx * bx + by * by) - 1.0
        return max(momentum, abs(energy) if not found.settings["eta"] else max(energy, 0.0))

    return SceneLaw(name, off)
