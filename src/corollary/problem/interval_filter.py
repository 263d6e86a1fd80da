"""Conditions at many points at once: decided in doubles where rounding cannot matter, exactly where it can."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from corollary.formula.arithmetics import Arithmetic, NotAvailable, ready
from corollary.formula.ast import Relation, calls, difference, names
from corollary.formula.ball import RationalPi, Undefined, holds
from corollary.formula.functions import FUNCTIONS, Function
from corollary.formula.syntax import author_formula

ULP = 2.0**-52  # twice what one rounding may do
SLACK = 4 * ULP  # what a function of the library may be off
LEAST = 2.0**-1022  # below, a double has fewer figures


@dataclass(frozen=True, slots=True)
class Interval:
    """Doubles, each with a radius within which the exact value lies; NaN or an infinite radius where none is known."""

    value: np.ndarray
    radius: np.ndarray

    @classmethod
    def of(cls, number: Fraction | int) -> Interval:
        value = np.asarray(float(number))
        return cls(value, abs(value) * ULP)

    def __neg__(self) -> Interval:
        return Interval(-self.value, self.radius)

    def __add__(self, other: Interval) -> Interval:
        return _rounded(self.value + other.value, self.radius + other.radius)

    def __sub__(self, other: Interval) -> Interval:
        return self + -other

    def __mul__(self, other: Interval) -> Interval:
        crossed = abs(self.value) * other.radius + abs(other.value) * self.radius + self.radius * other.radius
        return _rounded(self.value * other.value, crossed)

    def __truediv__(self, other: Interval) -> Interval:
        value, left = self.value / other.value, abs(other.value) - other.radius
        return _rounded(value, np.where(left > 0, (self.radius + abs(value) * other.radius) / left, np.inf))

    def __pow__(self, whole: int) -> Interval:
        result = Interval.of(1)
        for _ in range(abs(whole)):
            result = result * self
        return result if whole >= 0 else Interval.of(1) / result


def _rounded(value: np.ndarray, radius: np.ndarray) -> Interval:
    return Interval(value, radius * (1 + SLACK) + abs(value) * ULP + LEAST)


def _sqrt(x: Interval) -> Interval:
    value = np.sqrt(x.value)
    return _rounded(
        value, np.where(x.value > x.radius, value - np.sqrt(x.value - x.radius), np.inf) + SLACK * value
    )


def _power(x: Interval, p: Interval) -> Interval:
    value, low = np.power(x.value, p.value), x.value - x.radius
    grown = abs(p.value) * x.radius / low + abs(np.log(low)) * p.radius
    return _rounded(value, np.where(low > 0, value * np.expm1(grown), np.inf) + SLACK * value)


def _step(row: Function) -> Callable[[Interval], Interval]:
    """Of a step function the values at both ends of where its argument may lie: it never falls."""

    def apply(x: Interval) -> Interval:
        end = _rounded(x.value, x.radius)
        half = 0.5 if row.step == "half" else 0.0
        of = np.ceil if row.name == "ceil" else np.floor
        low, high = of(end.value - end.radius + half), of(end.value + end.radius + half)
        return _rounded((low + high) / 2, (high - low) / 2)

    return apply


def _of_rounded(row: Function) -> Callable[..., Interval] | None:
    """A function of doubles with bounds, from what its row says of its slope; None where that bounds nothing.

    By the mean value theorem it changes by no more than the largest slope between the true argument and the double, which
    the derivative, worked out of the double with its own bound, is never below.
    """
    if (
        row.name == "sqrt"
    ):  # its slope is infinite at 0, where conditions such as sqrt(a) <= b are often decided
        return _sqrt
    if row.step:
        return _step(row)
    of_array = getattr(np, row.array or row.name, None)
    slopes = [author_formula(derivative) for derivative in row.derivatives]
    called = {call.function for slope in slopes for call in calls(slope)}
    bounded = all(name == "sqrt" or FUNCTIONS[name].slope for name in called)
    if of_array is None or not (row.slope or (slopes and bounded and not row.branches)):
        return None
    of_slopes = [ready(slope, INTERVALS) for slope in slopes] if not row.slope else []

    def apply(*at: Interval) -> Interval:
        value = of_array(*(each.value for each in at))
        steepest = [run(dict(zip("xy", at, strict=False))) for run in of_slopes]
        bounds = [abs(slope.value) + slope.radius for slope in steepest] or [row.slope] * len(at)
        moved = [bound * each.radius for bound, each in zip(bounds, at, strict=True)]
        return _rounded(value, sum(moved) + SLACK * np.maximum(abs(value), 1.0))

    return apply


INTERVALS = Arithmetic("doubles with a bound", Interval.of, Interval.of(Fraction(np.pi)), _of_rounded, _power)
SIGNS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "=": lambda gap: gap == 0,
    "!=": lambda gap: gap != 0,
    "<": lambda gap: gap < 0,
    "<=": lambda gap: gap <= 0,
    ">": lambda gap: gap > 0,
    ">=": lambda gap: gap >= 0,
}


@dataclass(frozen=True, slots=True)
class GivenAtPoints:
    """A given at many points: its exact numbers, and which of them each point has. Letters are broadcast together."""

    numbers: Sequence[RationalPi]
    at: np.ndarray


def holding(relation: Relation, letters: Mapping[str, GivenAtPoints]) -> np.ndarray:
    """Where a condition holds; it does not where a side has no value."""
    tied = {name: letters[name] for name in sorted(names(relation) & letters.keys())}
    places = np.broadcast_arrays(*(letter.at for letter in tied.values()))
    with np.errstate(all="ignore"):
        gap = _gap(relation, tied)
        holding = np.broadcast_to(SIGNS[relation.sign](gap.value), places[0].shape).copy()
        doubtful = np.broadcast_to(~(abs(gap.value) > gap.radius), places[0].shape)
    for point in zip(*np.nonzero(doubtful), strict=True):
        exact = {
            name: letter.numbers[int(at[point])]
            for (name, letter), at in zip(tied.items(), places, strict=True)
        }
        holding[point] = _holds(relation, exact)
    return holding


def _gap(relation: Relation, letters: Mapping[str, GivenAtPoints]) -> Interval:
    """Left side minus right side; NaN with an infinite bound where this arithmetic lacks a function or overflows."""
    try:
        numbers = {name: _doubles(letter) for name, letter in letters.items()}
        return ready(difference(relation), INTERVALS)(numbers)
    except (NotAvailable, OverflowError):
        return Interval(np.asarray(np.nan), np.asarray(np.inf))


def _doubles(letter: GivenAtPoints) -> Interval:
    ratios = np.array([float(number.ratio) for number in letter.numbers])[letter.at]
    return Interval(ratios, abs(ratios) * ULP) * INTERVALS.pi ** letter.numbers[0].pi


def _holds(relation: Relation, values: Mapping[str, RationalPi]) -> bool:
    try:
        return bool(holds(relation, values))
    except Undefined:
        return False
