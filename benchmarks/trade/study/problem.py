"""One drawn problem: its equations as any solver takes them, its scene as the package takes it, and what is true."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from corollary.scenes.run import Run

Mode = int
NO_EVENTS = 2
"""The mode in which a right side decides by itself which law holds, for solvers that are not stopped at events."""


@dataclass(frozen=True, slots=True)
class Event:
    """`value(y)` crosses zero in a direction; `after(y, mode)` says how it goes on. Plain arithmetic: series are made of it, too."""

    value: Callable[[Any], Any]
    direction: int
    after: Callable[[Any, Mode], tuple[Any, Mode]]


@dataclass(frozen=True, slots=True)
class Truth:
    """Velocities at the end, and places (one row for each time) on the way; SI, `digits` of them are right."""

    velocities: np.ndarray
    places: np.ndarray
    digits: int


@dataclass(frozen=True, slots=True)
class Problem:
    """`right_side(t, y, p, mode)` is an array function that numba compiles as it stands; so is `fix(y, before, p)`, what the chapter's
    loop would do after each step. y is all places, then all velocities.

    `place` and `velocity` make the observed values of a state. Errors are in units of `long` (m) and `fast` (m/s). `ours(tolerance)`
    asks the package and `pick` takes values and errors out of its run. `series(hy, y, mode)` is the right side for heyoka, None where there
    is none; `smooth` says that no event is needed.
    """

    family: str
    right_side: Callable[..., np.ndarray]
    fix: Callable[..., None]
    p: np.ndarray
    start: np.ndarray
    until: float
    times: tuple[float, ...]
    mode: Mode
    events: Callable[[Mode], Sequence[Event]]
    truth: Truth
    long: float
    fast: float
    ours: dict[str, Callable[[float], Found]]
    place: Callable[[Any], Any]
    velocity: Callable[[Any], Any]
    series: Callable[[Any, Any, Mode], Sequence[Any]] | None = None
    without_events: bool = True


@dataclass(frozen=True, slots=True)
class Found:
    """What a method found: velocities at the end and places on the way (None: not asked), what it cost, and the error it states, if any,
    relative to `fast` at the end."""

    velocities: np.ndarray
    places: np.ndarray | None
    evaluations: int
    stated: float = float("nan")
    notes: tuple[str, ...] = field(default=())


class TooDear(RuntimeError):
    """A run that would ask for the right side too often."""


def nothing(y: np.ndarray, before: np.ndarray, p: np.ndarray) -> None:
    """No event: after a step of the loop all is as it is."""


def no_events(mode: Mode) -> tuple[Event, ...]:
    return ()


def halves(y: Any) -> tuple[Any, Any]:
    """Places and velocities of a state."""
    n = len(y) // 2
    return y[:n], y[n:]


def of_run(run: Run, fast: float, velocities: slice, places: slice, axes: int, count: int) -> Found:
    """The observed values of some bodies: `velocities` of all components at the end; `places` of those at each of `count` times."""
    v, errors = run.measured["velocities"].value, run.measured["velocities"].error
    found = None
    if "trajectory" in run.measured and count:
        found = np.array(run.measured["trajectory"].value).reshape(count, axes)[:, places]
    return Found(
        np.array(v)[velocities],
        found,
        run.evaluations,
        max(np.array(errors)[velocities]) / fast,
        tuple(run.warnings),
    )
