"""How fast a scene is answered beside what is written by hand: rows of 3, 5 and 200 balls.

    python benchmarks/scenes.py --speed

Everything is compiled before it is timed, processor time, best of several; only ratios within the run mean anything. "Asked" is what a
user gets: the values with their errors, from two runs. Each method takes the coarsest setting from which on its error is kept.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from by_hand import row_by_dop853, row_by_rk4

from corollary.scenes.catalogue import run
from corollary.scenes.collision import collide

RESULTS = Path(__file__).parent / "results" / "scenes_speed.md"
MASS, STIFFNESS, Q = 0.1, 1e4, 1.5
Timer = Callable[..., float]


def asked(count: int, tolerance: float) -> tuple[Any, float]:
    """Velocities and duration, as if for the first time."""
    collide.cache_clear()
    found = run("cradle", {"N": count, "q": Q}, tolerance)
    return np.array(found.observed["velocities"]), float(found.observed["duration"])  # pyright: ignore[reportArgumentType]


def kept(settings: Iterable[Any], error: Callable[[Any], float], wanted: float) -> Any:
    """The first setting, coarsest first, whose error is what is wanted, and whose finer neighbour's is, too; none if there is none."""
    good = None
    for setting in settings:
        if error(setting) > wanted:
            good = None
        elif good is not None:
            return good
        else:
            good = setting
    return good


def row(
    count: int, wanted: float, timed: Timer, lists: Callable[[int, float, Any], float] | None
) -> list[str]:
    """One line of the table: milliseconds of the answer, then times as dear as it is each of the others."""
    os.environ["COROLLARY_COMPILED"] = "1"
    truth, lasts = asked(count, 1e-14)
    until = 1.05 * lasts
    start = np.zeros(2 * count)
    start[count] = 1.0

    def off(velocities: Any) -> float:
        return float(np.abs(velocities - truth).max())

    tolerance = kept((1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12), lambda t: off(asked(count, t)[0]), wanted)
    base = timed(lambda: asked(count, tolerance))
    os.environ["COROLLARY_COMPILED"] = "0"
    written = timed(lambda: asked(count, tolerance)) if count < 200 else math.nan
    rk4 = kept(
        (1000 * 2**i for i in range(13)),
        lambda n: off(row_by_rk4(start, until, n, STIFFNESS, Q, MASS)[count:]),
        wanted,
    )
    by_rk4 = timed(lambda: row_by_rk4(start, until, rk4, STIFFNESS, Q, MASS)) if rk4 else math.nan
    by_dop = math.nan
    if count < 200:
        allowed = kept(
            (1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13),
            lambda t: off(row_by_dop853(start, until, t, STIFFNESS, Q, MASS)[count:]),
            wanted,
        )
        if allowed:
            by_dop = timed(lambda: row_by_dop853(start, until, allowed, STIFFNESS, Q, MASS))
    by_lists = lists(count, wanted, truth) if lists else math.nan
    ratios = [by_dop / base, by_lists / base, by_rk4 / base, written / base]
    shown = ["" if math.isnan(x) else f"{x:.3g}" for x in ratios]
    return [f"N = {count}", f"{1e3 * base:.3g}", f"{tolerance:g}", *shown, f"{rk4 or ''}"]


def report(timed: Timer, lists: Callable[[int, float, Any], float]) -> str:
    """The table in Markdown."""
    lines = [
        "# A scene beside what is written by hand",
        "",
        '`python benchmarks/scenes.py --speed`: touching rows, q = 3/2, velocities to 1e-9. "Asked" is the compiled answer with its error, from two runs;',
        "the other columns are times as dear as that. Compilation is not counted. Processor time, so only ratios mean anything.",
        "",
        "| row | asked, ms | tolerance | DOP853, events, compiled right side | book's loop in lists | compiled RK4 | asked, not compiled | RK4 steps |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for count in (3, 5, 200):
        lines.append("| " + " | ".join(row(count, 1e-9, timed, lists if count < 200 else None)) + " |")
        print(lines[-1], flush=True)
    lines.append("")
    return "\n".join(lines)
