"""What the runs say: the cost of a wanted error on each draw, medians and quartiles over draws, failures, stated against true error."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from .measured import Timed

WANTED = (1e-3, 1e-6, 1e-9)
OURS = {"row": "ours planned", "spheres": "ours planned"}
"""The planner's choice for what is asked at the end; everything else is a composed scene, looked at along the way."""


def planned(family: str) -> str:
    return OURS.get(family, "ours composed")


def error_of(run: Timed) -> float:
    """Velocities at the end where two or three balls part; for composed scenes the worst place on the way."""
    return run.end if run.family in OURS else run.along


def seconds_of(run: Timed) -> float:
    return run.seconds


def evaluations_of(run: Timed) -> float:
    return float(max(run.evaluations, 1))


@dataclass(frozen=True, slots=True)
class Spread:
    """Over draws: the median, the quartiles, and on how many of all the wanted error was reached."""

    median: float
    low: float
    high: float
    reached: int
    draws: int


Curves = dict[tuple[str, str], dict[int, list[Timed]]]


def curves(runs: Iterable[Timed]) -> Curves:
    """The runs of each family, method and draw, the coarsest first."""
    found: Curves = defaultdict(lambda: defaultdict(list))
    for run in runs:
        found[run.family, run.method][run.draw].append(run)
    return found


def cost(
    runs: Sequence[Timed],
    wanted: float,
    of: Callable[[Timed], float],
    error: Callable[[Timed], float] = error_of,
) -> float:
    """What the wanted error costs: between two runs on a straight line of logarithms; nan where it is not reached for good.

    A lucky hit does not count: every finer run that was made keeps the error, too.
    """
    made = [run for run in runs if run.outcome != "too dear"]
    good: Timed | None = None
    for run in reversed(made):
        if run.outcome != "found" or not error(run) <= wanted:
            if good is None or run.outcome != "found" or not error(run) < math.inf or error(good) <= 0.0:
                break
            share = math.log(error(run) / wanted) / math.log(error(run) / error(good))
            return math.exp((1.0 - share) * math.log(of(run)) + share * math.log(of(good)))
        good = run
    return math.nan if good is None else of(good)


def spread(values: Sequence[float]) -> Spread:
    known = [value for value in values if math.isfinite(value)]
    if not known:
        return Spread(math.nan, math.nan, math.nan, 0, len(values))
    low, middle, high = (float(x) for x in np.quantile(known, (0.25, 0.5, 0.75)))
    return Spread(middle, low, high, len(known), len(values))


def costs(
    found: Curves, family: str, method: str, wanted: float, of: Callable[[Timed], float] = evaluations_of
) -> Spread:
    return spread([cost(runs, wanted, of) for runs in found[family, method].values()])


def ratios(found: Curves, family: str, method: str, wanted: float) -> Spread:
    """Processor time over that of the planner's choice on the same draw, in the same round of turns."""
    ours = found[family, planned(family)]
    return spread(
        [
            cost(runs, wanted, seconds_of) / cost(ours[draw], wanted, seconds_of)
            for draw, runs in found[family, method].items()
        ]
    )


def silently_wrong(run: Timed) -> bool:
    """A number handed out without a word, a thousand times farther off than the tolerance and by more than a thousandth."""
    return run.outcome == "found" and not run.warned and run.end > max(1e3 * run.setting, 1e-3)


def failures(runs: Iterable[Timed]) -> dict[str, Counter[str]]:
    """Of each method with a tolerance, at 1e-4 and finer: how many runs, and what became of those that are not right."""
    found: dict[str, Counter[str]] = defaultdict(Counter)
    for run in runs:
        if run.setting < 1e-3:
            found[run.method]["runs"] += 1
            found[run.method]["silently wrong" if silently_wrong(run) else run.outcome] += 1
    return found


@dataclass(frozen=True, slots=True)
class Calibration:
    """Of the errors stated: how many, the share with the truth inside, the worst true error over the stated one, and the median."""

    runs: int
    inside: float
    worst: float
    median: float


def calibration(runs: Iterable[Timed]) -> dict[tuple[str, str], Calibration]:
    """By family and route of the package; the references are known to 1e-15, which is theirs."""
    found: dict[tuple[str, str], list[float]] = defaultdict(list)
    for run in runs:
        if run.outcome == "found" and math.isfinite(run.stated):
            found[run.family, run.method].append(max(run.end - 2e-15, 0.0) / max(run.stated, 1e-300))
    return {
        key: Calibration(
            len(each), sum(r <= 1.0 for r in each) / len(each), max(each), float(np.median(each))
        )
        for key, each in found.items()
    }
