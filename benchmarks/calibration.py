"""How far the errors that ready scenes state can be trusted: random and extreme runs of each family against references.

    python benchmarks/calibration.py --runs 10000 [--anew] [--seconds 500] [--family NAME]

writes benchmarks/results/calibration.md: for each family the share of values whose true error is within the stated one, and the worst
ratio of the two. Every draw has a seed of its own, its number: what was counted before (calibration.json beside the table) is gone on with
unless it is asked `--anew`, so the whole can be done in pieces of so many `--seconds`. tests/extremes runs the first draws.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import flint
import mpmath as mp
from flint import arb

from corollary.scenes.catalogue import run
from corollary.scenes.run import BadSetting, GuardFailed, Run, components

RESULTS = Path(__file__).parent / "results" / "calibration.md"
COUNTED = RESULTS.with_suffix(".json")
Reference = Mapping[str, tuple[Any, ...]]


@dataclass(slots=True)
class Family:
    """`draw` gives settings, `reference` the true values of a run (in any number type)."""

    name: str
    scene: str
    against: str
    draw: Callable[[random.Random], dict[str, Any]]
    reference: Callable[[dict[str, Any], Run], Reference]
    tolerance: float = 1e-9
    digits: int = 50


@dataclass(slots=True)
class Tally:
    """`worst` is the largest ratio of true to stated error, met with `settings`."""

    runs: int = 0
    refused: int = 0
    values: int = 0
    inside: int = 0
    worst: float = 0.0
    bounds: int = 0
    settings: dict[str, Any] = field(default_factory=dict[str, Any])


def powers(rng: random.Random, low: float, high: float) -> float:
    return 10.0 ** rng.uniform(low, high)


def two_blocks(rng: random.Random) -> dict[str, Any]:
    v = powers(rng, -100, 100)
    return {
        "mA": powers(rng, -100, 100),
        "mB": powers(rng, -100, 100),
        "vA": v,
        "vB": rng.uniform(-3.0, 0.9999) * v,
        "r": rng.choice([0.0, 1.0, rng.random()]),
    }


def of_two_blocks(given: dict[str, Any], _: Run) -> Reference:
    a, b, u, v, r = (Fraction(given[name]) for name in ("mA", "mB", "vA", "vB", "r"))
    impulse = (1 + r) * (u - v) * a * b / (a + b)
    return {"velocities": (u - impulse / a, v + impulse / b), "impulse": (impulse,)}


def bullet(rng: random.Random) -> dict[str, Any]:
    return {name: powers(rng, -40, 40) for name in ("m", "M", "v", "mu", "g")}


def of_bullet(given: dict[str, Any], _: Run) -> Reference:
    m, block, v, mu, g = (Fraction(given[name]) for name in ("m", "M", "v", "mu", "g"))
    common = m * v / (m + block)
    lost = -m * block * v * v / (2 * (m + block))
    return {"velocities": (common, common), "energy_change": (lost,), "distance": (common**2 / (2 * mu * g),)}


def ball(rng: random.Random) -> dict[str, Any]:
    span = rng.choice([2, 30])
    given = {
        "m": powers(rng, -span, span),
        "k": powers(rng, -span, span),
        "v0": -powers(rng, -span / 2, span / 2),
    }
    # Weight from nothing to what decides the contact.
    return given | {"q": rng.choice([1.0, 1.5, 2.0, 3.0]), "g": powers(rng, -8, 3), "R": 1.0, "y0": 1.0}


@cache
def double_exponential(steps: int) -> tuple[tuple[arb, arb, arb], ...]:
    """Places y in (0, 1), 1 - y and weights of the tanh-sinh rule with so many nodes for a unit of its variable."""
    found: list[tuple[arb, arb, arb]] = []
    for i in range(-6 * steps, 6 * steps + 1):
        t = arb(i) / steps
        u = arb.pi() * t.sinh()
        y, left = 1 / (1 + (-u).exp()), 1 / (1 + u.exp())
        weight = arb.pi() * t.cosh() * y * left / steps
        if weight > 1e-130:
            found.append((y.mid(), left.mid(), weight.mid()))
    return tuple(found)


def of_ball(given: dict[str, Any], found: Run, steps: int = 128) -> Reference:
    """Energy's integral by the tanh-sinh rule in 450 binary digits, with x = top (1 - y^2) where the ball turns back."""
    with flint.ctx.workprec(450):
        m, k, v, q, g = (arb(given[name]) for name in ("m", "k", "v0", "q", "g"))
        v, p = -v, q + 1
        stiff = 2 * k / (p * m)
        one, two = (v**2 / stiff) ** (1 / p), (2 * g / stiff) ** (1 / q)
        top = 2 * (one if one > two else two)
        for _ in range(200):
            top = (top - (v**2 + 2 * g * top - stiff * top**p) / (2 * g - stiff * p * top**q)).mid()
        if given["q"] == 1:
            turning = (k / m).sqrt()  # a swing about the place where the spring carries the ball
            lasts = 2 / turning * (arb.pi() - (turning * v / g).atan())
        else:
            lasts = arb(0)
            for y, z, weight in double_exponential(steps):
                e = y * y
                fallen = -((-e).log1p() * p).expm1() if e < 0.5 else 1 - (z * (1 + y)) ** p
                lasts += weight * y / (stiff * top**p * fallen - 2 * g * top * e).sqrt()
            lasts *= 4 * top
        true = {
            "duration": lasts,
            "impulse": 2 * m * v + m * g * lasts,
            "largest_overlap": top,
            "peak_force": k * top**q,
        }
        return {name: (mp.mpf(x.str(110, radius=False)),) for name, x in true.items()}


def spheres(rng: random.Random) -> dict[str, Any]:
    share = rng.choice([rng.random(), 1.0 - powers(rng, -12, -3)])
    speed = powers(rng, -3, 3)
    return {
        "mA": powers(rng, -6, 6),
        "mB": powers(rng, -6, 6),
        "R": 0.02,
        "q": rng.choice([1.0, 1.5, 2.0]),
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.1,
        "dy": 0.04 * share,
        "vA": (speed, 0.0),
    }


def of_spheres(given: dict[str, Any], found: Run, steps: int = 64) -> Reference:
    """Energy's integrals by the tanh-sinh rule in 450 binary digits, with x = top (1 - y^2) where the spheres turn back.

    Differences are written out so that none cancels; with twice the nodes forty digits stay (a test holds it to mpmath's rule).
    """
    with flint.ctx.workprec(450):
        d, k, ma, mb = (arb(x) for x in (2 * given["R"], given["k"], given["mA"], given["mB"]))
        v, q = arb(given["vA"][0]), arb(given["q"])
        p, mu, spin = q + 1, ma * mb / (ma + mb), v * arb(given["dy"])
        root = ((d * v) ** 2 - spin**2).sqrt()
        inward, stiff = root / d, 2 * k / (p * mu)
        top = arb(components(found.observed["largest_overlap"])[0])
        for _ in range(7):
            left = inward**2 - stiff * top**p - spin**2 * (1 / (d - top) ** 2 - 1 / d**2)
            top = (top + left / (stiff * p * top**q + 2 * spin**2 / (d - top) ** 3)).mid()
        near, force = d - top, stiff * top**p
        lasts = turned = arb(0)
        for y, z, weight in double_exponential(steps):
            e, r = y * y, near + top * y * y
            # 1 - (1 - e)^p, and 1 / near^2 - 1 / r^2
            fallen = -((-e).log1p() * p).expm1() if e < 0.5 else 1 - (z * (1 + y)) ** p
            square = force * fallen + spin**2 * top * e * (r + near) / (near * r) ** 2
            pace = weight * y / square.sqrt()
            lasts, turned = lasts + pace, turned + pace * spin / r**2
        lasts, turned = 4 * top * lasts, 4 * top * turned
        angle, across = turned + arb.atan2(spin, root), spin / d
        jx = mu * (inward * angle.cos() - across * angle.sin() + v)
        jy = mu * (inward * angle.sin() + across * angle.cos())
        true = {
            "velocities": (v - jx / ma, -jy / ma, jx / mb, jy / mb),
            "impulse": (jx, jy),
            "duration": (lasts,),
            "largest_overlap": (top,),
        }
        return {
            name: tuple(mp.mpf(x.str(110, radius=False)) for x in values) for name, values in true.items()
        }


def damped_spheres(rng: random.Random) -> dict[str, Any]:
    given = spheres(rng) | {"mA": powers(rng, -2, 0), "mB": powers(rng, -2, 0), "k": 2e4}
    given["vA"] = (rng.uniform(0.1, 1.5), 0.0)
    return given | {"eta": powers(rng, -6, 0.5)}


def damped_ball(rng: random.Random) -> dict[str, Any]:
    given = {"m": powers(rng, -2, 1), "k": powers(rng, 4, 8), "v0": -powers(rng, -1, 1), "R": 1.0, "y0": 1.0}
    return given | {
        "q": rng.choice([1.0, 1.5, 3.0]),
        "g": rng.choice([0.0, 9.8]),
        "eta": powers(rng, -4, 1.5),
    }


def three(rng: random.Random) -> dict[str, Any]:
    masses = tuple(powers(rng, -2, 2) for _ in range(3))
    return {"N": 3.0, "masses": masses, "q": rng.choice([1.0, 1.5, 2.0]), "gaps": rng.choice([0.0, 1e-4])}


def finer(scene: str) -> Callable[[dict[str, Any], Run], Reference]:
    """The same in the finest steps: they estimate the error of coarse ones, no more."""

    def reference(given: dict[str, Any], found: Run) -> Reference:
        fine = run(scene, given, 1e-14)
        names = ("velocities", "duration", "largest_overlap", "peak_force")
        return {name: components(fine.observed[name]) for name in names if name in found.observed}

    return reference


FAMILIES = (
    Family("two blocks, masses 1e±100", "two_blocks", "exact fractions", two_blocks, of_two_blocks),
    Family("bullet in a block, all 1e±40", "bullet_block", "exact fractions", bullet, of_bullet),
    Family("ball on a floor with weight", "ball_on_floor", "tanh-sinh, 120 digits", ball, of_ball),
    # A graze changes the velocity along the line of flight by so little that sixty digits of it cancel.
    Family(
        "two spheres, half of them grazing",
        "spheres",
        "tanh-sinh, 120 digits",
        spheres,
        of_spheres,
        digits=120,
    ),
    Family("two spheres, damped", "spheres", "finest steps", damped_spheres, finer("spheres")),
    Family(
        "ball on a floor, damped",
        "ball_on_floor",
        "finest steps",
        damped_ball,
        finer("ball_on_floor"),
    ),
    Family("cradle of three, any masses", "cradle", "finest steps", three, finer("cradle")),
)


def ratios(family: Family, given: dict[str, Any], found: Run) -> Iterator[float]:
    """For each value the true error over the stated one."""
    for name, true in family.reference(given, found).items():
        if name not in found.observed:
            continue
        for x, error, exact in zip(
            components(found.observed[name]), components(found.errors[name]), true, strict=True
        ):
            off = abs(Fraction(x) - exact) if isinstance(exact, Fraction) else abs(mp.mpf(x) - mp.mpf(exact))
            # What cannot be told from the last place of a double, or is below the least of them, is right.
            yield (
                0.0
                if off == 0
                else float(off / (Fraction(error) if isinstance(exact, Fraction) else mp.mpf(error)))
                if error
                else math.inf
            )


def calibrated(family: Family, runs: int, tally: Tally | None = None, seconds: float = math.inf) -> Tally:
    """A family's first draws, the same every time; a tally is gone on with, for so many seconds at most."""
    tally, begin = tally or Tally(), time.monotonic()
    mp.mp.dps = family.digits
    while tally.runs < runs and time.monotonic() - begin < seconds:
        given = family.draw(random.Random(f"{family.name} {tally.runs}"))
        tally.runs += 1
        try:
            found = run(family.scene, given, family.tolerance)
            seen = list(ratios(family, given, found))
        except (BadSetting, GuardFailed):
            tally.refused += 1
            continue
        tally.bounds += found.error_is == "bound"
        for ratio in seen:
            tally.values += 1
            tally.inside += ratio <= 1.0 + 1e-9
            if ratio > tally.worst:
                tally.worst, tally.settings = ratio, given
    return tally


def table(tallies: Mapping[str, Tally]) -> str:
    lines = [
        "# Stated against true errors of ready scenes",
        "",
        "A value is inside when its true error is at most the stated one; `python benchmarks/calibration.py --runs 10000 --anew`.",
        "Families with fewer runs were ended before; without `--anew` the command goes on with them.",
        "",
        "| family | reference | runs | bounds | refused | values | inside | worst ratio |",
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for family in FAMILIES:
        if (t := tallies.get(family.name)) and t.values:
            lines.append(
                f"| {family.name} | {family.against} | {t.runs} | {t.bounds} | {t.refused} | {t.values} "
                f"| {t.inside / t.values:.2%} | {t.worst:.2g} |"
            )
    return "\n".join([*lines, ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--family", choices=[family.name for family in FAMILIES])
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--anew", action="store_true")
    asked = parser.parse_args()
    tallies = {} if asked.anew or not COUNTED.exists() else json.loads(COUNTED.read_text(encoding="utf-8"))
    tallies = {name: Tally(**tally) for name, tally in tallies.items()}
    left = asked.seconds
    for family in FAMILIES:
        if asked.family in (None, family.name):
            begin = time.monotonic()
            t = tallies[family.name] = calibrated(family, asked.runs, tallies.get(family.name), left)
            left -= time.monotonic() - begin
            print(f"{family.name}: {t}", flush=True)
            COUNTED.write_text(
                json.dumps({n: asdict(t) for n, t in tallies.items()}, indent=1) + "\n", encoding="utf-8"
            )
            RESULTS.write_text(table(tallies), encoding="utf-8")


if __name__ == "__main__":
    main()
