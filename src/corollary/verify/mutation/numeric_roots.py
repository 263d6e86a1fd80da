"""Roots of a step's laws in doubles: every root that a search finds, with no algebra."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from corollary.formula.arithmetics import DOUBLES, Evaluation, NotAvailable, ready
from corollary.formula.ast import Expr, Relation, Sum, calls, names
from corollary.formula.operators import has_operators

FAILURES = (ValueError, ZeroDivisionError, OverflowError, TypeError, KeyError)
"""What an evaluation in doubles raises where there is no value."""
Values = tuple[float, ...]
LINEAR = 1e-9  # relative: what is further off a straight line is none
SAME = 1e-7  # relative: roots so near are one
SMALL = 1e-8  # of the terms of an equation: so small a residual is rounding
ROUNDED = 1e-12  # of the true root: so small a root is nothing, and no positive one
STEPS, DECADES = 24, 4  # points a decade, and decades to each side of the true root, where roots are sought
TURN = 180  # points of a full turn, where an angle is sought


class NumericEquations:
    """Laws ready to be evaluated: `sides` of each, in doubles."""

    def __init__(self, relations: Sequence[Relation], unknowns: Sequence[str]):
        """Raises NotAvailable where a law holds derivatives or the like."""
        if any(has_operators(each) for each in relations):
            raise NotAvailable("derivatives and integrals are not solved in numbers")
        self.unknowns = tuple(unknowns)
        self.letters = names(*relations) - {"pi"}
        self.sides: list[tuple[Evaluation, Evaluation]] = [
            (_in_doubles(each.left), _in_doubles(each.right)) for each in relations
        ]
        self.relations = relations
        self.angular = any(_in_a_sine(each, self.unknowns) for each in relations)

    @cached_property
    def terms(self) -> list[list[Evaluation]]:
        """What a residual is nothing beside: where one side is 0, the other's terms cancel."""
        return [
            [_in_doubles(term) for side in (each.left, each.right) for term in _terms(side)]
            for each in self.relations
        ]

    def residuals(self, letters: Mapping[str, float]) -> list[float]:
        """Left minus right of each equation."""
        return [left(letters) - right(letters) for left, right in self.sides]

    def hold(self, letters: Mapping[str, float], within: float = SMALL) -> bool:
        """Whether the sides agree; False where one has no value."""
        try:
            for (left, right), terms in zip(self.sides, self.terms, strict=True):
                one, other = left(letters), right(letters)
                size = max(abs(term(letters)) for term in terms)
                if not math.isfinite(one - other) or abs(one - other) > within * size:
                    return False
        except FAILURES:
            return False
        return True

    def roots(self, letters: Mapping[str, float], near: Values) -> list[Values] | None:
        """The roots for these values of the other letters, sought around the true one; None where one stays free."""
        return _roots(self, dict(letters), near)


@lru_cache(maxsize=4096)  # most laws are not the bent one
def _in_doubles(tree: Expr) -> Evaluation:
    return ready(tree, DOUBLES)


def _terms(side: Expr) -> tuple[Expr, ...]:
    return side.terms if isinstance(side, Sum) else (side,)


def _in_a_sine(relation: Relation, unknowns: Sequence[str]) -> bool:
    return any(
        call.function in ("sin", "cos", "tan") and names(call) & {*unknowns} for call in calls(relation)
    )


def _roots(equations: NumericEquations, letters: dict[str, float], near: Values) -> list[Values] | None:
    size = max(map(abs, near), default=0.0) or 1.0
    scales = [abs(value) or size for value in near]

    def residuals(at: Sequence[float]) -> list[float]:
        letters.update(zip(equations.unknowns, at, strict=True))
        return equations.residuals(letters)

    straight = _straight(residuals, near, scales)
    if straight is not None and all(straight.linear):
        return _linear(straight, near, scales)
    if len(near) == 1:
        return _of_one(equations, letters, residuals, near[0], scales[0])
    if straight is not None and any(straight.linear):
        found = _on_a_line(equations, letters, residuals, straight, near, scales)
        if found is not None:
            return found
    return _of_several(equations, letters, residuals, near, scales)


Residuals = Callable[[Sequence[float]], list[float]]


@dataclass(frozen=True, slots=True)
class Straight:
    """Slopes and values at the true root, and which equations are linear in the unknowns."""

    slopes: np.ndarray
    start: np.ndarray
    linear: list[bool]


def _straight(residuals: Residuals, near: Values, scales: Sequence[float]) -> Straight | None:
    """None where an equation has no value on the way."""
    try:
        start = np.array(residuals(near))
        bowed = np.zeros(len(start), dtype=bool)
        columns: list[np.ndarray] = []
        for place, scale in enumerate(scales):
            ahead = [value + scale * (at == place) for at, value in enumerate(near)]
            back = [value - 1.7 * scale * (at == place) for at, value in enumerate(near)]
            one, other = np.array(residuals(ahead)) - start, (np.array(residuals(back)) - start) / -1.7
            bowed |= np.abs(one - other) > LINEAR * (np.abs(one) + np.abs(other) + 1e-3 * np.abs(start))
            columns.append(one / scale)
        slopes = np.array(columns).T
        mixed = [value + 0.7 * scale for value, scale in zip(near, scales, strict=True)]
        step = slopes @ np.array([0.7 * scale for scale in scales])
        off = np.array(residuals(mixed)) - start - step
        bowed |= np.abs(off) > LINEAR * (np.abs(slopes) @ np.array(scales) + 1e-3 * np.abs(start))
    except FAILURES:
        return None
    if not (np.all(np.isfinite(slopes)) and np.all(np.isfinite(start))):
        return None
    return Straight(slopes, start, [not each for each in bowed.tolist()])


def _linear(straight: Straight, near: Values, scales: Sequence[float]) -> list[Values] | None:
    scaled, start = straight.slopes * np.array(scales), straight.start
    rows = np.max(np.abs(scaled), axis=1)
    live = rows > 0
    if np.any(~live & (np.abs(start) > 0)):  # a law without an unknown that does not hold
        return []
    matrix, wanted = scaled[live] / rows[live, None], -start[live] / rows[live]
    found, *_ = np.linalg.lstsq(matrix, wanted, rcond=None)
    fits = bool(np.all(np.abs(matrix @ found - wanted) <= SMALL * (1 + np.abs(wanted))))
    if np.linalg.matrix_rank(matrix, tol=1e-10) < len(near):
        return None if fits else []
    if not fits:
        return []
    root = [value + scale * float(step) for value, scale, step in zip(near, scales, found, strict=True)]
    return [tuple(0.0 if abs(x) < 1e-13 * scale else x for x, scale in zip(root, scales, strict=True))]


def _on_a_line(
    equations: NumericEquations,
    letters: dict[str, float],
    residuals: Residuals,
    straight: Straight,
    near: Values,
    scales: Sequence[float],
) -> list[Values] | None:
    """Roots where the linear equations leave a line, on which the others are quadratic; None where it is not so."""
    linear = np.array(straight.linear)
    rows = straight.slopes[linear] * np.array(scales)
    sizes = np.max(np.abs(rows), axis=1)
    if np.any(sizes == 0) or len(rows) != len(near) - 1:
        return None
    matrix, wanted = rows / sizes[:, None], -straight.start[linear] / sizes
    if np.linalg.matrix_rank(matrix, tol=1e-10) < len(matrix):
        return None
    foot, *_ = np.linalg.lstsq(matrix, wanted, rcond=None)
    along = np.linalg.svd(matrix)[2][-1]

    def at(way: float) -> list[float]:
        return [
            value + scale * float(step)
            for value, scale, step in zip(near, scales, foot + way * along, strict=True)
        ]

    try:
        points = [np.array(residuals(at(way)))[~linear] for way in (-2.0, -1.0, 0.0, 1.0, 2.0)]
    except FAILURES:
        return None
    bow = (points[3] + points[1]) / 2 - points[2]
    slope = (points[3] - points[1]) / 2
    size = np.abs(bow) + np.abs(slope) + np.abs(points[2])
    for way, point in ((-2.0, points[0]), (2.0, points[4])):
        if not np.all(np.abs(bow * way**2 + slope * way + points[2] - point) <= 1e-8 * size):
            return None
    found: list[Values] = []
    for way in _of_a_parabola(float(bow[0]), float(slope[0]), float(points[2][0])):
        root = tuple(at(way))
        letters.update(zip(equations.unknowns, root, strict=True))
        if equations.hold(letters, 1e-7) and not any(_same(root, other) for other in found):
            found.append(root)
    return found


def _of_a_parabola(bow: float, slope: float, start: float) -> list[float]:
    """The real zeros of `bow` x² + `slope` x + `start`."""
    size = abs(bow) + abs(slope) + abs(start)
    if abs(bow) <= 1e-12 * size:
        return [-start / slope] if abs(slope) > 1e-12 * size else []
    under = slope**2 - 4 * bow * start
    if under < -1e-12 * (slope**2 + abs(4 * bow * start)):
        return []
    half = -0.5 * (slope + math.copysign(math.sqrt(max(0.0, under)), slope))
    return [half / bow, *([start / half] if half else [])]


def _of_one(
    equations: NumericEquations, letters: dict[str, float], residuals: Residuals, near: float, scale: float
) -> list[Values]:
    """Roots in one unknown: of a parabola, or between points where an equation changes its sign; if all equations hold there."""
    if equations.angular:
        points = [math.pi * (place / TURN * 2 - 1) for place in range(TURN + 1)]
    else:
        sizes = [scale * 10 ** (place / STEPS) for place in range(-STEPS * DECADES, STEPS * DECADES + 1)]
        points = [-each for each in reversed(sizes)] + [0.0] + sizes
    found: list[Values] = []

    def add(at: float) -> None:
        at = 0.0 if abs(at) <= ROUNDED * scale else at
        letters[equations.unknowns[0]] = at
        if all(abs(at - other) > SAME * max(abs(at), abs(other)) for (other,) in found) and equations.hold(
            letters
        ):
            found.append((at,))

    def value(at: float) -> float | None:
        try:
            one = residuals((at,))[0]
        except FAILURES:
            return None
        return one if math.isfinite(one) else None

    if not equations.angular and (zeros := _quadratic(value, scale)) is not None:
        for at in zeros:
            add(at)
        return found
    before: tuple[float, float] | None = None
    for at in points:
        now = value(at)
        if now == 0.0:
            add(at)
        elif now is not None and before is not None and before[1] * now < 0:
            add(_between(value, before, (at, now)))
        before = None if now is None else (at, now)
    return found


def _quadratic(value: Callable[[float], float | None], scale: float) -> list[float] | None:
    """The zeros of an equation that is a parabola; None for another."""
    points = [value(way * scale) for way in (-2.0, -1.0, 0.0, 1.0, 2.0, 5.0)]
    one, two, three, four, five, six = points
    if one is None or two is None or three is None or four is None or five is None or six is None:
        return None
    bow, slope = (four + two) / 2 - three, (four - two) / 2
    size = abs(bow) + abs(slope) + abs(three)
    for way, point in ((-2.0, one), (2.0, five), (5.0, six)):
        if abs(bow * way**2 + slope * way + three - point) > 1e-9 * way**2 * size:
            return None
    return [scale * each for each in _of_a_parabola(bow, slope, three)]


def _between(
    value: Callable[[float], float | None], left: tuple[float, float], right: tuple[float, float]
) -> float:
    """By bisection and secants in turn (Dekker), to the last bits."""
    (a, at_a), (b, at_b) = left, right
    for turn in range(200):
        middle = 0.5 * (a + b)
        if turn % 3 and at_a != at_b:
            middle = b - at_b * (b - a) / (at_b - at_a)
            if not min(a, b) < middle < max(a, b):
                middle = 0.5 * (a + b)
        now = value(middle)
        if now is None or now == 0.0 or abs(b - a) <= 4e-16 * max(abs(a), abs(b)):
            return middle
        if (now < 0) == (at_a < 0):
            a, at_a = middle, now
        else:
            b, at_b = middle, now
    return 0.5 * (a + b)


def _of_several(
    equations: NumericEquations,
    letters: dict[str, float],
    residuals: Residuals,
    near: Values,
    scales: Sequence[float],
) -> list[Values]:
    """Roots in several unknowns: Newton's steps from the true root with its signs and sizes changed."""
    found: list[Values] = []
    for start in _starts(near, scales):
        root = _newton(residuals, start, scales)
        if root is None or any(_same(root, other) for other in found):
            continue
        letters.update(zip(equations.unknowns, root, strict=True))
        if equations.hold(letters, 1e-7):
            found.append(root)
    return found


def _starts(near: Values, scales: Sequence[float]) -> Iterator[list[float]]:
    signs = list(itertools.islice(itertools.product((1, -1), repeat=len(near)), 16))
    for factor in (1.03, 0.4, 2.3, 11.0):
        for each in signs:
            yield [
                factor * sign * (value or 0.1 * scale)
                for sign, value, scale in zip(each, near, scales, strict=True)
            ]


def _newton(residuals: Residuals, start: list[float], scales: Sequence[float]) -> Values | None:
    at = np.array(start)
    try:
        now = np.array(residuals(at.tolist()))
        for _ in range(40):
            slopes = np.empty((len(now), len(at)))
            for place, scale in enumerate(scales):
                step = 1e-6 * max(abs(at[place]), 1e-3 * scale)
                moved = at.copy()
                moved[place] += step
                slopes[:, place] = (np.array(residuals(moved.tolist())) - now) / step
            move, *_ = np.linalg.lstsq(slopes, -now, rcond=None)
            at = at + move
            now = np.array(residuals(at.tolist()))
            if not np.all(np.isfinite(now)):
                return None
            if np.all(np.abs(move) <= 1e-12 * np.abs(at)):
                break
    except (*FAILURES, np.linalg.LinAlgError):
        return None
    return tuple(map(float, at))


def _same(one: Values, other: Values) -> bool:
    return math.dist(one, other) <= SAME * (math.hypot(*one) + math.hypot(*other))
