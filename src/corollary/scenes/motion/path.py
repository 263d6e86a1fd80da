"""Trajectory of a scene, stretch by stretch, and the isolation of the first root of a function within one.

The function is sampled at 17 Chebyshev points, which is exact for what is of degree 16 in a step's own polynomial (the square of a
distance has degree 14 in DOP853's dense output). A series whose constant exceeds the sum of its other coefficients has no root, one
whose derivative does so is monotone; what is neither is halved. Source: J. P. Boyd, SIAM J. Numer. Anal. 40 (2002) 1666.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, Radau
from scipy.optimize import brentq

from corollary.scenes.motion.equations_of_motion import Mode

Array = NDArray[np.float64]

DEGREE = 16
POINTS: Array = 0.5 * (1.0 - np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE))
"""Where on a step (0 to 1) a function is sampled: closest at its ends, which are among them."""

# A series is resolved when its last coefficients are this share of the largest; a function that is no polynomial is halved until then.
RESOLVED = 1e-9
MOST_HALVINGS = 48
MOST_RESAMPLED = 6


def _transform() -> Array:
    """From values at POINTS to Chebyshev coefficients on (-1, 1)."""
    j = np.arange(DEGREE + 1)
    weights = np.where((j == 0) | (j == DEGREE), 0.5, 1.0)
    cosines = np.cos(np.pi * np.outer(j, DEGREE - j) / DEGREE)
    return weights[:, None] * cosines * weights[None, :] * 2.0 / DEGREE


def _halving(side: float) -> Array:
    """From the coefficients on (-1, 1) to those on its left (-1) or right (+1) half."""
    x = 2.0 * POINTS - 1.0
    values = np.polynomial.chebyshev.chebvander(0.5 * (x + side), DEGREE)
    return TRANSFORM @ values


def _derivative() -> Array:
    """From the coefficients of a series to those of its derivative."""
    derived = np.polynomial.chebyshev.chebder(np.eye(DEGREE + 1))
    return np.vstack([derived, np.zeros(DEGREE + 1)]).astype(np.float64)


TRANSFORM = _transform()
LEFT, RIGHT = _halving(-1.0), _halving(1.0)
DERIVATIVE = _derivative()


def coefficients(values: Array) -> Array:
    """Chebyshev coefficients of functions from their values at POINTS: the last axis of `values`."""
    return values @ TRANSFORM.T


def certainly_positive(series: Array) -> NDArray[np.bool_]:
    """For each row of coefficients whether the series is above zero everywhere."""
    return series[..., 0] > np.abs(series[..., 1:]).sum(axis=-1)


def first_fall(values_at: Callable[[Array], Array], values: Array) -> tuple[float, float] | None:
    """The first part of a step (0 to 1) on which a function falls from above zero to zero or below, monotonously; none if it never does.

    `values` are those at POINTS, `values_at` gives them anywhere. One that begins at or below zero and falls, falls at once: (0, 0). One that begins there and rises
    is waited for until it is above.
    """
    return _in_piece(values_at, coefficients(values), 0.0, 1.0, 0, False)


def bracketed(value: Callable[[float], float], left: float, right: float) -> tuple[float, float]:
    """A fall's bracket with its ends moved to where the function is above zero, and to where it no longer is.

    Where it is not smooth, its series may be off by more than it is there. An end for which there is no such place stays as it is.
    """
    before, after, back, ahead = left, right, 2.0**-MOST_RESAMPLED, 2.0**-MOST_RESAMPLED
    while before > 0.0 and value(before) <= 0.0:
        before, back = max(before - back, 0.0), 2.0 * back
    while after < 1.0 and value(after) > 0.0:
        after, ahead = min(after + ahead, 1.0), 2.0 * ahead
    return (
        before if before == left or value(before) > 0.0 else left,
        after if after == right or value(after) <= 0.0 else right,
    )


def root_of(value: Callable[[float], float], left: float, right: float) -> float:
    """Where a function that has opposite signs at two places is zero, to the last digit (Brent's method)."""
    return float(brentq(value, left, right, xtol=1e-16, rtol=1e-15, disp=False))  # pyright: ignore[reportArgumentType]


def _in_piece(
    values_at: Callable[[Array], Array], series: Array, left: float, right: float, resampled: int, above: bool
) -> tuple[float, float] | None:
    """`above` says whether the piece before this one ends above zero: where not all is resolved, the two may not agree on where they meet."""
    largest = np.abs(series).max()
    if largest == 0.0:
        return None
    if abs(series[-1]) + abs(series[-2]) > RESOLVED * largest and resampled < MOST_RESAMPLED:
        middle = 0.5 * (left + right)
        for low, high in ((left, middle), (middle, right)):
            values = values_at(low + (high - low) * POINTS)
            found = _in_piece(values_at, coefficients(values), low, high, resampled + 1, above)
            if found:
                return found
            above = float(values[-1]) > 0.0
        return None
    return _isolated(series, left, right, 0, above)


def _isolated(
    series: Array, left: float, right: float, halvings: int, above: bool
) -> tuple[float, float] | None:
    rest = np.abs(series[1:]).sum()
    if series[0] > rest:
        return None
    begin, end = float(series[::2].sum() - series[1::2].sum()), float(series.sum())
    slope = DERIVATIVE @ series
    steepness = np.abs(slope[1:]).sum()
    if abs(slope[0]) > steepness or halvings == MOST_HALVINGS:
        if slope[0] >= 0.0 or end > 0.0:
            return None
        if begin <= 0.0:
            return (left, left) if left == 0.0 else (left, right)
        return left, right
    if series[0] < -rest and left > 0.0:
        return (left, left) if above else None
    middle = 0.5 * (left + right)
    first = LEFT @ series
    found = _isolated(first, left, middle, halvings + 1, above)
    return found or _isolated(RIGHT @ series, middle, right, halvings + 1, float(first.sum()) > 0.0)


def minima(values: Array) -> list[tuple[float, float]]:
    """Where (0 to 1) a function sampled at POINTS is least within a step, or at its very ends, and how large it is there."""
    series = coefficients(values)
    slope = np.polynomial.chebyshev.chebder(series)
    bend = np.polynomial.chebyshev.chebder(slope)
    roots = np.polynomial.chebyshev.chebroots(slope)
    found = [float(x.real) for x in roots if abs(x.imag) < 1e-6 and abs(x.real) < 1.0 + 1e-6]
    return [
        (0.5 * (x + 1.0), float(np.polynomial.chebyshev.chebval(x, series)))
        for x in found
        if np.polynomial.chebyshev.chebval(x, bend) > 0.0
    ]


@dataclass(frozen=True, slots=True)
class Stretch:
    """One step: from `begin` (s) for `lasts` (s), in one mode; of order eight if it is `explicit`.

    `dense` gives the state, and `slope` its rate of change, at a time since `offset` before its begin.
    """

    begin: float
    lasts: float
    before: list[float]
    after: list[float]
    mode: Mode
    since: list[float]
    dense: Callable[[float | Array], Array]
    slope: Callable[[float, Array], Array | list[float]]
    offset: float
    explicit: bool = True

    @classmethod
    def made(
        cls, solver: DOP853 | Radau, begun: float, before: list[float], mode: Mode, since: list[float]
    ) -> Stretch:
        """The last step of a solver whose time is counted from `begun` (s)."""
        last, now = float(solver.t_old or 0.0), float(solver.t)
        explicit, dense = isinstance(solver, DOP853), solver.dense_output()
        after: list[float] = solver.y.tolist()
        return cls(begun + last, now - last, before, after, mode, since, dense, solver.fun, last, explicit)

    def at(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of it."""
        if part <= 0.0:
            return self.before
        if part >= 1.0:
            return self.after
        state: list[float] = self.dense(self.offset + part * self.lasts).tolist()
        return state

    def again(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of it by a step that ends there: the polynomial is of a lower order than the step."""
        if part <= 0.0 or part >= 1.0 or not self.explicit:
            return self.at(part)
        lasts = part * self.lasts
        step = DOP853(
            lambda t, y: self.slope(self.offset + t, y),
            0.0,
            np.array(self.before),
            lasts,
            first_step=lasts,
            rtol=1.0,
            atol=math.inf,
        )
        step.step()
        state: list[float] = step.y.tolist()
        return state

    def bent(self, count: int) -> float:
        """How far (m/s) velocities are from the slopes of the `count` places on its polynomial, but for rounding."""
        states = np.array(self.sampled()).T
        series = coefficients(states[:count]) @ DERIVATIVE.T
        slopes = 2.0 / self.lasts * np.polynomial.chebyshev.chebval(2.0 * POINTS - 1.0, series.T)
        rounding = 1e-13 * float(np.abs(states[:count]).max()) / self.lasts
        return float(np.abs(slopes - states[count : 2 * count]).max()) - rounding

    def states(self, parts: Array) -> list[list[float]]:
        """The states after several parts of it, worked out at once."""
        inside: list[list[float]] = self.dense(self.offset + parts * self.lasts).T.tolist()
        return [
            self.before if part <= 0.0 else self.after if part >= 1.0 else state
            for part, state in zip(parts.tolist(), inside, strict=True)
        ]

    def sampled(self) -> list[list[float]]:
        """The states at the points where events are looked for."""
        return self.states(POINTS)


@dataclass(frozen=True, slots=True)
class Happening:
    """Something that changed the law: which, when, and how sure (s) its moment is.

    `together`: bodies that touched have parted, but for errors as fast as each other.
    """

    what: str
    time: float
    stretch: int
    slack: float = 0.0
    together: bool = False


@dataclass(frozen=True, slots=True)
class Turn:
    """A moment (s) at which the distance from the origin turns, that distance (m), and whether it had come inward."""

    time: float
    distance: float
    inward: bool


@dataclass(slots=True)
class Trajectory:
    """`happenings` are in order; `rests` the times (s) at which bounces without end were over.

    `grazes` is when (s) errors decide about a touch first: it is missed, or met, by less than `near` (m). `dropped` is a speed (m/s) that
    was taken for rest; `fast` (m/s), `long` and `deep` (m, of overlaps) are the sizes of the scene,
    `allowed` (m) is what a step may be off. `fades`: what faded held steps down, and errors with it.
    `turned` are the turns of the first body's distance, once they have been looked for.
    """

    count: int
    """How many places a state has."""
    stretches: list[Stretch] = field(default_factory=list[Stretch])
    time: float = 0.0
    state: list[float] = field(default_factory=list[float])
    mode: Mode | None = None
    happenings: list[Happening] = field(default_factory=list[Happening])
    rests: list[float] = field(default_factory=list[float])
    evaluations: int = 0
    dropped: float = 0.0
    grazes: float = math.inf
    near: float = 0.0
    allowed: float = 0.0
    fast: float = 0.0
    long: float = 0.0
    deep: float = math.inf
    shallow: float = math.inf
    """How deep (m) at least bodies squeeze each other where one of them is fast."""
    settled: bool = False
    fades: bool = False
    turned: list[Turn] | None = None
    bends: dict[int, bool] = field(default_factory=dict[int, bool])
    """Of the stretches in which a moment was looked up: whether the polynomial is too far off for it."""

    def graze(self, time: float) -> None:
        """Errors decide about a touch at a time (s)."""
        self.grazes = min(self.grazes, time)

    def hits_before(self, time: float) -> int:
        """How many hits there have been by a time (s)."""
        return sum(each.what.startswith("hit") and each.time <= time for each in self.happenings)

    def ends(self) -> list[list[float]]:
        """The states at all ends of steps."""
        return [*(stretch.before for stretch in self.stretches), self.state]

    def touching(self) -> tuple[bool, ...]:
        """Which pairs touch in the end, or have only parted together since they did."""
        return (
            _touching(self.mode, {each.what: each.together for each in self.happenings}) if self.mode else ()
        )

    def at(self, time: float) -> list[float]:
        """The state at a time between the start and the end."""
        if not self.stretches:
            return self.state
        low = max(bisect_right(self.stretches, time, key=lambda stretch: stretch.begin) - 1, 0)
        stretch = self.stretches[low]
        part = (time - stretch.begin) / stretch.lasts if stretch.lasts else 1.0
        if 0.0 < part < 1.0 and low not in self.bends:
            self.bends[low] = stretch.bent(self.count) * stretch.lasts > 0.2 * self.allowed
        return stretch.again(part) if self.bends.get(low) else stretch.at(part)


def _touching(mode: Mode, parted: Mapping[str, bool]) -> tuple[bool, ...]:
    """Which pairs touch, or have only `parted` together."""
    return tuple(on or parted.get(f"touch {j}", False) for j, on in enumerate(mode.touching))
