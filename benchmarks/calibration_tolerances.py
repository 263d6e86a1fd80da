"""Whether stated errors hold at coarse tolerances, too: random runs at 1e-11 … 1e-2 beside the same at 1e-14.

    python benchmarks/calibration_tolerances.py [--runs 2000] [--seconds 60]

writes benchmarks/results/calibration_tolerances.md. What calibration.py holds against references at one tolerance serves as the reference
here, with its own error allowed for; rows of very unequal masses are there, too. With numba, else it takes hours.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))

from calibration import FAMILIES

from corollary.derive.ready_scenes import run
from corollary.scenes.integrate import both_ways
from corollary.scenes.run import BadSetting, GuardFailed, Observed, components

RESULTS = Path(__file__).parent / "results" / "calibration_tolerances.md"
FINEST = 1e-14
Seen = Iterator[tuple[float, bool]]
"""For each value the true error over the stated one, and whether a warning says that it is not decided."""


@dataclass(slots=True)
class Count:
    runs: int = 0
    values: int = 0
    inside: int = 0
    said: int = 0
    worst: float = 0.0

    def add(self, seen: Seen) -> None:
        for ratio, said in seen:
            self.values += 1
            if ratio <= 1.0:
                self.inside += 1
            elif said:
                self.said += 1
            else:
                self.worst = max(self.worst, ratio)


def unequal(rng: random.Random) -> dict[str, Any]:
    """A row of two to six balls, each up to a million times as heavy as another."""
    count = rng.randint(2, 6)
    return {
        "N": float(count),
        "q": rng.choice([1.0, 1.3, 1.5, 2.0, 3.0]),
        "masses": tuple(10.0 ** rng.uniform(-3.0, 3.0) for _ in range(count)),
        "gaps": tuple(
            0.0 if rng.random() < 0.6 else 10.0 ** rng.uniform(-5.0, -1.0) for _ in range(count - 1)
        ),
    }


def ratio(value: Observed, stated: Observed, true: Observed, known: Observed) -> Iterator[float]:
    for x, error, y, own in zip(*map(components, (value, stated, true, known)), strict=True):
        off = abs(x - y) - own
        yield off / error if off > 0.0 and error else (float("inf") if off > 0.0 else 0.0)


def single(scene: str, given: dict[str, Any], tolerance: float, second_way: bool) -> Seen:
    rough, fine = (run(scene, given, t, second_way=second_way) for t in (tolerance, FINEST))
    for name in rough.measured.keys() & fine.measured.keys():
        said = name == "duration" and bool(rough.warnings)
        for each in ratio(rough.observed[name], rough.errors[name], fine.observed[name], fine.errors[name]):
            yield each, said


def counted(draw: Callable[[random.Random], Seen], name: str, runs: int, seconds: float) -> Count:
    count, begin = Count(), time.monotonic()
    for i in range(runs):
        if time.monotonic() - begin > seconds:
            break
        try:
            count.add(draw(random.Random(f"{name} {i}")))
        except (BadSetting, GuardFailed):
            continue
        count.runs += 1
    return count


def drawn(
    scene: str, settings: Callable[[random.Random], dict[str, Any]], second_way: bool
) -> Callable[[random.Random], Seen]:
    return lambda rng: single(scene, settings(rng), 10.0 ** rng.uniform(-11.0, -2.0), second_way)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=2000)
    parser.add_argument("--seconds", type=float, default=60.0)
    asked = parser.parse_args()
    os.environ[both_ways.ASKED_BY] = "1"
    draws = {family.name: drawn(family.scene, family.draw, family.second_way) for family in FAMILIES}
    draws["rows of two to six, masses 1e±3"] = drawn("cradle", unequal, False)
    counts = {name: counted(draw, name, asked.runs, asked.seconds) for name, draw in draws.items()}
    lines = [
        "# Stated errors at coarse tolerances",
        "",
        f"Tolerances of 1e-11 … 1e-2, drawn at random, beside {FINEST:g}: `python benchmarks/calibration_tolerances.py --runs {asked.runs} "
        f"--seconds {asked.seconds:g}`, so many seconds for each family. Said: outside, but a warning says that the duration is not decided.",
        "",
        "| family | runs | values | inside | outside, said | outside | worst ratio of these |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for name, c in counts.items():
        lines.append(
            f"| {name} | {c.runs} | {c.values} | {c.inside} | {c.said} | {c.values - c.inside - c.said} | {c.worst:.2g} |"
        )
    RESULTS.write_text("\n".join([*lines, ""]), encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
