"""How far the errors that ready scenes state can be trusted: random and extreme runs of each family against references.

    python benchmarks/calibration.py --runs 10000 [--anew] [--seconds 500] [--family NAME]

writes benchmarks/results/calibration.md: for each family how many values have a true error larger than the stated one, and the worst
ratio of the two. Every draw has a seed of its own, its number: what was counted before (calibration.json beside the table) is gone on with
unless it is asked `--anew`, so the whole can be done in pieces of so many `--seconds`. tests/extremes runs the first draws.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import sys
import time
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath as mp

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))

from ready import contacts, integrals, momentum, orbits
from ready.family import Family
from ready.motion import TooLong

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting, GuardFailed, Run, components

RESULTS = Path(__file__).parent / "results" / "calibration.md"
COUNTED = RESULTS.with_suffix(".json")


@dataclass(slots=True)
class Tally:
    """`worst` is the largest ratio of true to stated error, met with `settings`; of `unknown` runs the reference came to no end."""

    runs: int = 0
    refused: int = 0
    unknown: int = 0
    values: int = 0
    inside: int = 0
    worst: float = 0.0
    bounds: int = 0
    settings: dict[str, Any] = field(default_factory=dict[str, Any])


FAMILIES = (*momentum.FAMILIES, *integrals.FAMILIES, *contacts.FAMILIES, *orbits.FAMILIES)


def ratios(family: Family, given: dict[str, Any], found: Run) -> Iterator[tuple[str, float]]:
    """For each value its name and the true error over the stated one."""
    for name, true in family.reference(given, found).items():
        if name not in found.observed:
            continue
        values, errors = components(found.observed[name]), components(found.errors[name])
        reach = family.known * float(max(map(abs, true), default=0.0))
        for x, error, exact in zip(values, errors, true, strict=True):
            exactly = isinstance(exact, Fraction)
            off = abs(Fraction(x) - exact) if exactly else abs(mp.mpf(x) - mp.mpf(exact))
            off = max(off - (Fraction(reach) if exactly else reach), 0)
            if off == 0 or not error:
                yield name, math.inf if off else 0.0
            else:
                yield name, float(off / (Fraction(error) if exactly else mp.mpf(error)))


def calibrated(family: Family, runs: int, tally: Tally | None = None, seconds: float = math.inf) -> Tally:
    """A family's first draws, the same every time; a tally is gone on with, for so many seconds at most."""
    tally, begin = tally or Tally(), time.monotonic()
    mp.mp.dps = family.digits
    while tally.runs < runs and time.monotonic() - begin < seconds:
        given = family.draw(random.Random(f"{family.name} {tally.runs}"))
        tally.runs += 1
        try:
            found = run(family.scene, given, family.tolerance, second_way=family.second_way)
            seen = list(ratios(family, given, found))
        except (BadSetting, GuardFailed):
            tally.refused += 1
            continue
        except TooLong:
            tally.unknown += 1
            continue
        tally.bounds += found.error_is == "bound"
        for name, ratio in seen:
            tally.values += 1
            tally.inside += ratio <= 1.0 + 1e-9
            if ratio > tally.worst:
                tally.worst, tally.settings = ratio, given | {"observed": name}
    return tally


def table(tallies: Mapping[str, Tally]) -> str:
    lines = [
        "# Stated against true errors of ready scenes",
        "",
        "A value is outside when its true error is larger than the stated one; `python benchmarks/calibration.py --runs 10000 --anew`.",
        "Families with fewer runs were ended before; without `--anew` the command goes on with them. No reference shares the scene's code:",
        "they are in benchmarks/ready. Refused: in a sentence, by the scene. No reference: the reference's steps did not come to an end.",
        "",
        "| family | reference | runs | bounds | refused | no reference | values | outside | worst ratio |",
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for family in FAMILIES:
        if (t := tallies.get(family.name)) and t.values:
            lines.append(
                f"| {family.name} | {family.against} | {t.runs} | {t.bounds} | {t.refused} | {t.unknown} | {t.values} "
                f"| {t.values - t.inside} | {t.worst:.2g} |"
            )
    return "\n".join([*lines, ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--family", choices=[family.name for family in FAMILIES])
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--anew", action="store_true")
    asked = parser.parse_args()
    counted = json.loads(COUNTED.read_text(encoding="utf-8")) if COUNTED.exists() else {}
    anew = {name for name in counted if asked.anew and asked.family in (None, name)}
    tallies = {name: Tally(**tally) for name, tally in counted.items() if name not in anew}
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
