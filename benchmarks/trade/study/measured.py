"""The runs of the study: every method on every draw at every setting, in turns, and what became of each."""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np

from corollary.scenes.run import BadSetting, GuardFailed

from . import composed, contacts, loops, series, solvers
from .problem import Found, Problem, TooDear

FAMILIES: dict[str, Callable[[int], Problem]] = {
    "row": contacts.row,
    "spheres": contacts.spheres,
    "wall": composed.wall,
    "friction": composed.friction,
    "orbit": composed.orbit,
    "fluid": composed.fluid,
}
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
STEPS = (50, 200, 800, 3200, 12_800, 51_200)
BY_PYTHON = (200, 800)
"""Steps of a loop that is not compiled: its error is that of the compiled one, so longer runs would only cost time."""
COMPOSED_ROWS = 1
"""Draws of the row that are also asked for as a composed scene, which costs about a second each."""


@dataclass(frozen=True, slots=True)
class Timed:
    """One run. `end` and `along` are errors in natural units, `stated` what the package says of `end`; nan where there is none.

    `outcome` is "found", or why nothing was: "refused", "too dear", "failed"; a value that is no number counts as failed.
    """

    family: str
    draw: int
    method: str
    setting: float
    end: float
    along: float
    stated: float
    warned: bool
    evaluations: int
    seconds: float
    outcome: str


def methods(
    problem: Problem, draw: int
) -> Iterator[tuple[str, tuple[float, ...], Callable[[float], Callable[[], Found]]]]:
    """Each method with its settings; for a setting what is to be timed, with whatever is compiled already compiled."""
    for name, ask in problem.ours.items():
        if name == "compiled" and draw == 0:
            ask(1e-6)
        if (problem.family, name) != ("row", "composed") or draw < COMPOSED_ROWS:
            yield f"ours {name}", TOLERANCES, lambda tolerance, ask=ask: partial(ask, tolerance)
    compiled = loops.compiled(problem.right_side)
    compiled(0.0, problem.start, problem.p, problem.mode)
    for name in ("DOP853", "Radau", "LSODA", *solvers.ADDED):
        try:
            method = solvers.method_named(name)
        except ImportError:
            continue
        ways = {"events": solvers.through_events}
        if problem.without_events:
            ways = {"": solvers.straight} | (ways if problem.events(problem.mode) else {})
        for way, run in ways.items():
            yield (
                f"{name} {way}".strip(),
                TOLERANCES,
                partial(_partial, run, problem, problem.right_side, method),
            )
            if name == "DOP853" and way == list(ways)[-1]:
                yield (
                    f"{name} {way} compiled".replace("  ", " "),
                    TOLERANCES,
                    partial(_partial, run, problem, compiled, method),
                )
    for name in loops.LOOPS:
        yield (
            f"{name} compiled",
            STEPS,
            lambda n, name=name: _warm(partial(loops.run, problem, name, int(n), True)),
        )
    for name in ("book", "verlet"):
        yield name, BY_PYTHON, lambda n, name=name: partial(loops.run, problem, name, int(n), False)
    if problem.series is not None and series.installed():
        yield "heyoka", TOLERANCES, lambda tolerance: _warm(series.Taylor(problem, tolerance))


def _partial(
    run: Any, problem: Problem, right_side: Any, method: Any, tolerance: float
) -> Callable[[], Found]:
    return partial(run, problem, right_side, method, tolerance)


def _warm(call: Callable[[], Found]) -> Callable[[], Found]:
    """Run once, so that compiling is not timed; a failure is left for the run that counts."""
    try:
        call()
    except (ArithmeticError, RuntimeError, ValueError):
        return call
    return call


def one_round(family: str, draw: int) -> list[Timed]:
    """Every method at every setting on one drawn problem."""
    problem, found = FAMILIES[family](draw), []
    for name, settings, prepared in methods(problem, draw):
        dear = False
        for setting in settings:
            if dear:
                found.append(
                    Timed(
                        family,
                        draw,
                        name,
                        setting,
                        math.nan,
                        math.nan,
                        math.nan,
                        False,
                        0,
                        math.nan,
                        "too dear",
                    )
                )
                continue
            found.append(timed(problem, draw, name, setting, prepared(setting)))
            dear = found[-1].outcome == "too dear"
    return found


def timed(problem: Problem, draw: int, name: str, setting: float, call: Callable[[], Found]) -> Timed:
    """One run by the processor's clock, and its errors."""
    begin, outcome = time.process_time(), "found"
    made: Found | None = None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            made = call()
        except TooDear:
            outcome = "too dear"
        except (BadSetting, GuardFailed):
            outcome = "refused"
        except (ArithmeticError, RuntimeError, ValueError, KeyError, IndexError):
            outcome = "failed"
    seconds = time.process_time() - begin
    end = along = math.nan
    if made is not None:
        end = float(np.max(np.abs(np.array(made.velocities) - problem.truth.velocities))) / problem.fast
        if made.places is not None:
            along = float(np.max(np.abs(made.places - problem.truth.places))) / problem.long
        if not math.isfinite(end):
            outcome, end, along = "failed", math.nan, math.nan
    evaluations = made.evaluations if made else 0
    stated = made.stated if made else math.nan
    return Timed(
        problem.family,
        draw,
        name,
        setting,
        end,
        along,
        stated,
        bool(made and made.notes),
        evaluations,
        seconds,
        outcome,
    )


def as_rows(runs: list[Timed]) -> dict[str, Any]:
    """Column by column, with no more figures than are meant."""
    columns: dict[str, list[Any]] = {}
    for run in runs:
        for name, value in asdict(run).items():
            short = None if isinstance(value, float) and not math.isfinite(value) else value
            columns.setdefault(name, []).append(float(f"{short:.3g}") if isinstance(short, float) else short)
    return columns


def from_rows(columns: dict[str, Any]) -> list[Timed]:
    names = list(columns)
    return [
        Timed(**{name: math.nan if value is None else value for name, value in zip(names, row, strict=True)})
        for row in zip(*columns.values(), strict=True)
    ]
