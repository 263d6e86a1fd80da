"""Intervals of doubles rounded outwards, and the functions of laws on them, there and back."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from flint import arb

INFINITY = math.inf
FARTHEST_TURN = 1e12  # beyond it a double tells no angle within a turn


class Enclosure(NamedTuple):
    """All real numbers from `low` to `high`; infinite ends are not among them."""

    low: float
    high: float

    @property
    def width(self) -> float:
        return self.high - self.low

    @property
    def finite(self) -> bool:
        return self.low > -INFINITY and self.high < INFINITY

    def has(self, number: float) -> bool:
        return self.low <= number <= self.high


ALL = Enclosure(-INFINITY, INFINITY)
NOT_NEGATIVE = Enclosure(0.0, INFINITY)
ONE = Enclosure(1.0, 1.0)
UNIT = Enclosure(-1.0, 1.0)
Pieces = tuple[Enclosure, ...]


class Empty(Exception):
    """No real number is left."""


def below(number: float) -> float:
    return math.nextafter(number, -INFINITY)


def above(number: float) -> float:
    return math.nextafter(number, INFINITY)


def meet(one: Enclosure, other: Enclosure) -> Enclosure:
    """What both have. Raises Empty."""
    low, high = max(one.low, other.low), min(one.high, other.high)
    if not low <= high or low == INFINITY or high == -INFINITY:
        raise Empty
    return Enclosure(low, high)


def meet_pieces(one: Enclosure, pieces: Pieces) -> Enclosure:
    """The smallest interval around what one has in common with several. Raises Empty."""
    ends: list[float] = []
    for piece in pieces:
        low, high = max(one.low, piece.low), min(one.high, piece.high)
        if low <= high and low < INFINITY and high > -INFINITY:
            ends += (low, high)
    if not ends:
        raise Empty
    return Enclosure(min(ends), max(ends))


def of_ball(ball: arb) -> Enclosure:
    """The doubles around a ball."""
    if not ball.is_finite():
        return ALL
    return Enclosure(below(float(ball.lower())), above(float(ball.upper())))


def negative(x: Enclosure) -> Enclosure:
    return Enclosure(-x.high, -x.low)


def add(x: Enclosure, y: Enclosure) -> Enclosure:
    return Enclosure(below(x.low + y.low), above(x.high + y.high))


def subtract(x: Enclosure, y: Enclosure) -> Enclosure:
    return Enclosure(below(x.low - y.high), above(x.high - y.low))


def multiply(x: Enclosure, y: Enclosure) -> Enclosure:
    ends = [_times(one, other) for one in x for other in y]
    return Enclosure(below(min(ends)), above(max(ends)))


def _times(one: float, other: float) -> float:
    return 0.0 if one == 0 or other == 0 else one * other  # an infinite end is no number: 0 times it stays 0


def inverse(x: Enclosure) -> Pieces:
    """1/x: two pieces where 0 is inside, none where x is 0."""
    if x.low > 0 or x.high < 0:
        return (Enclosure(below(1 / x.high), above(1 / x.low)),)
    pieces: list[Enclosure] = []
    if x.low < 0:
        pieces.append(Enclosure(-INFINITY, above(1 / x.low)))
    if x.high > 0:
        pieces.append(Enclosure(below(1 / x.high), INFINITY))
    return tuple(pieces)


def divide(x: Enclosure, y: Enclosure) -> Pieces:
    """x/y: what times a number of y can be a number of x; everything where 0 is in both."""
    if x.has(0) and y.has(0):
        return (ALL,)
    return tuple(multiply(x, each) for each in inverse(y))


def hull(pieces: Pieces) -> Enclosure:
    """The smallest interval around all pieces. Raises Empty."""
    if not pieces:
        raise Empty
    return Enclosure(min(each.low for each in pieces), max(each.high for each in pieces))


def growing(function: Callable[[arb], arb]) -> Callable[[Enclosure], Enclosure]:
    """A function that grows, from what it is of balls; at infinite ends it is unbounded."""

    def run(x: Enclosure) -> Enclosure:
        low = -INFINITY if x.low == -INFINITY else of_ball(function(arb(x.low))).low
        high = INFINITY if x.high == INFINITY else of_ball(function(arb(x.high))).high
        return Enclosure(low, high)

    return run


_exponential = growing(lambda ball: ball.exp())
_logarithm = growing(lambda ball: ball.log())
_arc_sine = growing(lambda ball: ball.asin())
_arc_cosine_reversed = growing(lambda ball: -ball.acos())
_arc_tangent = growing(lambda ball: ball.atan())
HALF_TURN = math.pi / 2
RIGHT = Enclosure(below(-HALF_TURN), above(HALF_TURN))


def exponential(x: Enclosure) -> Enclosure:
    low, high = _exponential(x)
    return Enclosure(max(0.0, low), high)


def logarithm(x: Enclosure) -> Enclosure:
    """Raises Empty where nothing is positive."""
    x = meet(x, NOT_NEGATIVE)
    if x.high == 0:
        raise Empty
    return Enclosure(
        _logarithm(x).low if x.low > 0 else -INFINITY, _logarithm(Enclosure(x.high, x.high)).high
    )


def arc_sine(x: Enclosure) -> Enclosure:
    return meet(RIGHT, _arc_sine(meet(x, UNIT)))


def arc_cosine(x: Enclosure) -> Enclosure:
    return negative(_arc_cosine_reversed(meet(x, UNIT)))


def arc_tangent(x: Enclosure) -> Enclosure:
    return meet(RIGHT, _arc_tangent(x))


def power(x: Enclosure, exponent: int) -> Enclosure:
    """x^n for n > 0."""
    if exponent % 2 == 0:
        x = absolute(x)
    low = -INFINITY if x.low == -INFINITY else of_ball(arb(x.low) ** exponent).low
    high = INFINITY if x.high == INFINITY else of_ball(arb(x.high) ** exponent).high
    return Enclosure(max(0.0, low) if exponent % 2 == 0 else low, high)


def root(x: Enclosure, degree: int) -> Enclosure:
    """The root that is not negative, of what is not negative. Raises Empty."""
    x = meet(x, NOT_NEGATIVE)
    low = 0.0 if x.low == 0 else of_ball(arb(x.low).root(degree)).low
    high = 0.0 if x.high == 0 else INFINITY if x.high == INFINITY else of_ball(arb(x.high).root(degree)).high
    return Enclosure(max(0.0, low), high)


def signed_root(x: Enclosure, degree: int) -> Enclosure:
    """For an odd degree."""
    ends: list[Enclosure] = []
    if x.high >= 0:
        ends.append(root(Enclosure(max(0.0, x.low), x.high), degree))
    if x.low <= 0:
        ends.append(negative(root(Enclosure(max(0.0, -x.high), -x.low), degree)))
    return hull(tuple(ends))


def absolute(x: Enclosure) -> Enclosure:
    if x.low >= 0:
        return x
    return negative(x) if x.high <= 0 else Enclosure(0.0, max(-x.low, x.high))


def both_signs(x: Enclosure) -> Pieces:
    """The numbers whose absolute value is in x. Raises Empty."""
    x = meet(x, NOT_NEGATIVE)
    return negative(x), x


def sine(x: Enclosure) -> Enclosure:
    if not x.finite or x.width >= 2 * math.pi or max(-x.low, x.high) > FARTHEST_TURN:
        return UNIT
    first = math.floor((x.low - HALF_TURN) / math.pi) - 1
    last = math.ceil((x.high - HALF_TURN) / math.pi) + 1
    ends = [of_ball(arb(end).sin()) for end in x]
    low, high = min(each.low for each in ends), max(each.high for each in ends)
    for turn in range(first, last + 1):  # at pi/2 + n pi it is 1 or -1
        slack = 4e-16 * (abs(turn) + 2) * math.pi
        if x.low - slack <= HALF_TURN + turn * math.pi <= x.high + slack:
            low, high = (low, 1.0) if turn % 2 == 0 else (-1.0, high)
    return Enclosure(max(-1.0, low), min(1.0, high))


def sine_back(x: Enclosure, y: Enclosure) -> Enclosure:
    """Of x what has its sine in y. Raises Empty."""
    arc = arc_sine(y)
    return _periodic(x, lambda turn: arc if turn % 2 == 0 else negative(arc))


def tangent(x: Enclosure) -> Enclosure:
    if not x.finite or x.width >= math.pi or max(-x.low, x.high) > FARTHEST_TURN:
        return ALL
    turn = round(x.low / math.pi)
    for pole in (turn - 1, turn, turn + 1):
        slack = 4e-16 * (abs(pole) + 2) * math.pi
        if x.low - slack <= HALF_TURN + pole * math.pi <= x.high + slack:
            return ALL
    return Enclosure(of_ball(arb(x.low).tan()).low, of_ball(arb(x.high).tan()).high)


def tangent_back(x: Enclosure, y: Enclosure) -> Enclosure:
    """Of x what has its tangent in y. Raises Empty."""
    arc = arc_tangent(y)
    return _periodic(x, lambda _: arc)


def _periodic(x: Enclosure, branch: Callable[[int], Enclosure]) -> Enclosure:
    """Of x what is in one of the branches, which lie within a right angle of each multiple of pi. Raises Empty."""

    def first(end: float, step: int, default: float) -> float:
        if abs(end) > FARTHEST_TURN:
            return default
        turn = math.floor((end + HALF_TURN) / math.pi) - step
        for _ in range(5):
            slack = 4e-16 * (abs(turn) + 2) * math.pi
            piece = branch(turn)
            low, high = piece.low + turn * math.pi - slack, piece.high + turn * math.pi + slack
            low, high = max(low, x.low), min(high, x.high)
            if low <= high:
                return low if step > 0 else high
            turn += step
        raise Empty

    low, high = first(x.low, 1, x.low), first(x.high, -1, x.high)
    return meet(x, Enclosure(low, high))


def direction(y: Enclosure, x: Enclosure) -> Enclosure:
    """atan2(y, x)."""
    whole = Enclosure(below(-math.pi), above(math.pi))
    if not (x.finite and y.finite) or (x.low <= 0 and y.has(0)):
        return whole
    ends = [of_ball(arb.atan2(arb(one), arb(other))) for one in y for other in x]
    return Enclosure(min(each.low for each in ends), max(each.high for each in ends))
