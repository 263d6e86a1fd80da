"""Where in the ranges the draws lie that may not be assigned, so that an author knows which range to change, and how."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from corollary.formula.numerals import decimal_text
from corollary.problem.given import Given
from corollary.problem.variant import Variant, number
from corollary.units.unit import show

ENOUGH = 8  # draws on either side of a limit, and a tenth of all: of fewer, none is a share
FEWER = 0.2  # by so much the share refused must fall, or the limit is no help

CANDIDATES = 40  # values that a limit is tried at: of a fine grid not each
A_CONDITION = 0.5  # of a range: that is changed more easily than a condition is added


@dataclass(frozen=True, slots=True)
class TriedDraw:
    """A draw that keeps all conditions, and whether it may be assigned."""

    variant: Variant
    admitted: bool


@dataclass(frozen=True, slots=True)
class RangeLimit:
    """A limit on the draws: what to write, and what shares are refused within it and beyond."""

    words: str
    within: float
    beyond: float
    weight: float


def narrower(tried: Sequence[TriedDraw]) -> str:
    """The one limit within which most draws may be assigned, as a sentence's end; "" where none tells them apart."""
    if not tried:
        return ""
    givens = [each for each in tried[0].variant.problem.givens if each.grid.count > 1 and not each.words]
    best = max(
        (*_of_ranges(givens, tried), *_of_ratios(givens, tried)), key=lambda each: each.weight, default=None
    )
    if best is None:
        return ""
    return f"with {best.words} it would be {best.within:.0%} of them; beyond that it is {best.beyond:.0%}"


def _of_ranges(givens: Sequence[Given], tried: Sequence[TriedDraw]) -> Iterator[RangeLimit]:
    for given in givens:
        unit = f" {show(given.unit)}" if show(given.unit) else ""

        def words(least: bool, value: Fraction, given: Given = given, unit: str = unit) -> str:
            return f"{given.symbol} {'from' if least else 'to'}: {number(given, value)}{unit}"

        pairs = [(each.variant.values[given.symbol], each.admitted) for each in tried]
        yield from _limits(pairs, sorted({value for value, _admitted in pairs}), words, 1.0)


def _of_ratios(givens: Sequence[Given], tried: Sequence[TriedDraw]) -> Iterator[RangeLimit]:
    """Two givens that measure the same, none of which can be zero or less."""
    for one, other in combinations([each for each in givens if each.sign > 0], 2):
        if one.unit.dimension != other.unit.dimension:
            continue

        def words(least: bool, value: Fraction, one: Given = one, other: Given = other) -> str:
            return f"{one.symbol} {'>=' if least else '<='} {decimal_text(float(value), 2)}*{other.symbol} (under where:)"

        ratios = [
            (each.variant.exact[one.symbol].ratio / each.variant.exact[other.symbol].ratio, each.admitted)
            for each in tried
        ]
        neat = {Fraction(decimal_text(float(value), 2)) for value, _admitted in ratios}
        yield from _limits(ratios, sorted(neat), words, A_CONDITION)


def _limits(
    pairs: Sequence[tuple[Fraction, bool]],
    values: Sequence[Fraction],
    words: Callable[[bool, Fraction], str],
    worth: float,
) -> Iterator[RangeLimit]:
    """From each value on, and up to it, where that tells what is refused from what is not."""
    for value in values[:: 1 + len(values) // CANDIDATES]:
        for least in (True, False):
            within = [admitted for each, admitted in pairs if (each >= value if least else each <= value)]
            beyond = [admitted for each, admitted in pairs if not (each >= value if least else each <= value)]
            if min(len(within), len(beyond)) < max(ENOUGH, len(pairs) / 10):
                continue
            inside, outside = (1 - sum(each) / len(each) for each in (within, beyond))
            if outside - inside >= FEWER:
                weight = worth * len(within) * len(beyond) * (outside - inside) ** 2
                yield RangeLimit(words(least, value), inside, outside, weight)
