"""Curves as drawn and curves as asked for, held against each other along their whole length."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, cast, runtime_checkable

import numpy as np
import numpy.typing as npt
from scipy.spatial import KDTree

from corollary.grading.programs.work import count

Numbers = npt.NDArray[np.float64]

NEAR = 0.05  # between curves, as parts of the two scales added up: a time step too late is 0.01, a straight line 0.09 and more
GAP = 0.12  # how far the next drawn point may be from any place of the curve asked for; points that stand alone, too
MOST_POINTS = 2_000  # a curve is looked at in so many places, and at its own points
FINE = 0.2 * NEAR  # points that follow each other more closely are one place
LOOKED_AT = 200  # places of the curve asked for
BEYOND = 1e6  # parts of a scale: no curve that was asked for goes so far
OFFSETS = np.linspace(-NEAR, NEAR, 33)


@dataclass(frozen=True, slots=True)
class DrawnCurve:
    """One line or cloud of points: `x` and `y`, equally long; `joined` when a line is drawn through them."""

    x: Numbers
    y: Numbers
    joined: bool

    @property
    def visible(self) -> bool:
        return bool((np.isfinite(self.x) & np.isfinite(self.y)).any())

    @property
    def straight(self) -> bool:
        """A level or an upright line, or a few marked points: what helps the eye, and is no curve."""
        seen = np.isfinite(self.x) & np.isfinite(self.y)
        x, y = self.x[seen], self.y[seen]
        return (not self.joined and len(x) <= 3) or any(
            float(np.ptp(each)) <= 1e-6 * float(np.abs(each).max()) for each in (x, y)
        )

    def points(self, scales: tuple[float, float]) -> tuple[Numbers, Numbers]:
        """Its places in parts of the scales: its points but for those next to another, and places on the lines between them."""
        x, y = self.x / scales[0], self.y / scales[1]
        seen = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
        x, y = x[seen], y[seen]
        if not len(x) or max(float(np.abs(x).max()), float(np.abs(y).max())) > BEYOND:
            return np.empty(0), np.empty(0)
        steps = _steps(x, y)
        cells = np.floor(np.concatenate(([0.0], np.cumsum(steps))) / FINE)
        own = np.concatenate(([True], np.diff(cells) > 0))
        own[-1] = True
        if not self.joined:
            return x[own], y[own]
        # A gap in the line has no length: a place there is one of its ends.
        along = np.concatenate(([0.0], np.cumsum(np.where(np.diff(seen) == 1, steps, 0.0))))
        between = np.arange(0.0, float(along[-1]), max(FINE, float(along[-1]) / MOST_POINTS))
        order = np.argsort(np.concatenate((along[own], between)), kind="stable")
        return (
            np.concatenate((x[own], np.interp(between, along, x)))[order],
            np.concatenate((y[own], np.interp(between, along, y)))[order],
        )

    def in_units(self, x_unit: float, y_unit: float) -> DrawnCurve:
        """The same in SI, when its numbers are in these units."""
        return DrawnCurve(self.x * x_unit, self.y * y_unit, self.joined)

    def moved(self, by: float) -> DrawnCurve:
        """The same with x counted from elsewhere."""
        return DrawnCurve(self.x - by, self.y, self.joined)

    def middle_of_change(self) -> float | None:
        """The x about which y changes, whatever is drawn before and after; None where it does not."""
        seen = np.isfinite(self.x) & np.isfinite(self.y)
        change = np.abs(np.diff(self.y[seen]))
        total = float(change.sum())
        x = self.x[seen]
        return float((change * (x[1:] + x[:-1])).sum() / 2 / total) if 0 < total < np.inf else None


def _steps(x: Numbers, y: Numbers) -> Numbers:
    return np.abs(np.diff(x)) + np.abs(np.diff(y))


class Asked(Protocol):
    """A curve asked for: its name in a sentence, and whether what was drawn is it."""

    @property
    def name(self) -> str: ...

    def fits(self, curve: DrawnCurve) -> bool: ...


@runtime_checkable
class HasMiddle(Protocol):
    """A curve asked for that changes about some x, wherever x is counted from."""

    def middle(self) -> float | None: ...


@dataclass(frozen=True, slots=True)
class Graph:
    """A function of x, wanted over `span` at least; `scales` are the lengths along x and y in which nearness is counted."""

    name: str
    at: Callable[[Numbers], Numbers]
    span: tuple[float, float]
    scales: tuple[float, float]

    def fits(self, curve: DrawnCurve) -> bool:
        x, y = curve.points(self.scales)
        if not near_all(x, y, self._far):
            return False
        places = np.linspace(*self.span, 4 * LOOKED_AT)
        return covers((x, y), (places / self.scales[0], self.at(places) / self.scales[1]))

    def _far(self, x: Numbers, y: Numbers) -> bool:
        """Whether any place is too far from the function: sideways and upwards, added up."""
        with np.errstate(all="ignore"):
            aside = ~(np.abs(y - self.at(x * self.scales[0]) / self.scales[1]) <= NEAR)
            x, y = x[aside], y[aside]
            values = self.at((x[:, None] + OFFSETS) * self.scales[0]) / self.scales[1]
            apart = np.abs(y[:, None] - values) + np.abs(OFFSETS)
        return not bool((apart <= NEAR).any(axis=1).all())

    def middle(self) -> float | None:
        """The x about which it changes."""
        places = np.linspace(*self.span, 4 * LOOKED_AT)
        return DrawnCurve(places, self.at(places), joined=True).middle_of_change()


@dataclass(frozen=True, slots=True)
class PlanePath:
    """A path in a plane from one end to the other, in `places` (x, y); `near` is how far (in their unit) another may be from it."""

    name: str
    places: tuple[Numbers, Numbers]
    near: float

    def fits(self, curve: DrawnCurve) -> bool:
        unit = self.near / NEAR
        x, y = curve.points((unit, unit))
        path = DrawnCurve(*self.places, joined=True).points((unit, unit))

        def far(x: Numbers, y: Numbers) -> bool:
            return not bool((_apart((x, y), path) <= NEAR).all())

        return near_all(x, y, far) and covers((x, y), path)


def near_all(x: Numbers, y: Numbers, far: Callable[[Numbers, Numbers], bool]) -> bool:
    """Whether there are places, and none is `far`: most curves that do not fit are told by a few of them."""
    count(2 * LOOKED_AT)
    if not len(x):
        return False
    some = slice(None, None, 1 + len(x) // LOOKED_AT)
    if far(x[some], y[some]):
        return False
    count(len(x))
    return not far(x, y)


def covers(drawn: tuple[Numbers, Numbers], asked: tuple[Numbers, Numbers]) -> bool:
    """Whether each place of the curve asked for has a drawn one near it; both in parts of the scales."""
    along = np.concatenate(([0.0], np.cumsum(_steps(*asked))))
    places = np.linspace(0.0, float(along[-1]), LOOKED_AT)
    x, y = (np.interp(places, along, each) for each in asked)
    return bool((_apart((x, y), drawn) <= GAP).all())


def _apart(places: tuple[Numbers, Numbers], others: tuple[Numbers, Numbers]) -> Numbers:
    """How far each place is from the nearest of the others; infinite beyond twice GAP."""
    tree = KDTree(np.column_stack(others))
    return cast("Numbers", tree.query(np.column_stack(places), p=1, distance_upper_bound=2 * GAP)[0])


def curves(lines: Any) -> list[DrawnCurve]:
    """The lines and clouds of one pair of axes, their numbers as drawn; empty ones are left out."""
    found = [
        DrawnCurve(np.asarray(line.x), np.asarray(line.y), line.kind == "line")
        for line in lines
        if line.kind != "bars" and len(line.x)
    ]
    return [curve for curve in found if curve.visible]
