"""Guessing patterns that earn no credit: one number typed nearly everywhere, a wrong answer copied, another part's answer times a
round factor."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from corollary.answers.answer import Numbers
from corollary.answers.expected import Values
from corollary.answers.tolerance import within
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.grading.follow_through import copied
from corollary.grading.key import Key, Truth
from corollary.messages import catalogue
from corollary.problem.part import Part

_ = catalogue(__name__)

TENS = (1.0, *(10.0**power for power in (1, 2, 3, 4, 6, -1, -2, -3, -4, -6)))
ROUND = (2.0, 0.5, 4.0, 0.25, *TENS)
SAME = 1e-9  # a number typed twice, and read in two units


def own_work(verdict: Verdict, values: Values | None, earlier: Mapping[str, Values], again: str) -> Verdict:
    """What only copies a wrong answer earns nothing: where a part is the very same as the part `again`, by a misconception, or one
    number that for these givens happens to follow from itself."""
    if values is None:
        return verdict
    match verdict:
        case Follows(parts) if again in parts and copied(values, earlier[again]):
            return replace(verdict, nothing=True)
        case Follows(parts) if len({*values}) == 1 and any(copied(values, earlier[part]) for part in parts):
            return replace(verdict, nothing=True)
        case Mistaken(_, parts) if any(copied(values, earlier[part]) for part in parts if part in earlier):
            return replace(verdict, nothing=True)
        case _:
            return verdict


def guessed(
    verdict: Verdict, values: Values | None, key: Key, part: Part, earlier: Mapping[str, Values]
) -> Verdict:
    """A factor or a sign is nothing to be paid for where it is found without this part.

    That is where the answer of a part asked before is this one but for a round factor, and something like it was typed; where what
    was typed is such an answer times a round factor (of another dimension: with its digits); where a given was copied, or an own
    answer.
    """
    if not isinstance(verdict, Slip) or verdict.nothing or not verdict.once or values is None:
        return verdict
    truth = key.truths[part.id]
    if truth.is_met_by(values):  # in another unit
        return verdict
    found = any(len(values) == len(each) and copied(values, each) for each in earlier.values())
    found = found or any(
        _related(values, (given,), (1.0,), truth.tolerance) for given in _givens(key, part, truth)
    )
    sign_alone = _related(values, truth.values, (1.0,), truth.tolerance)  # then its size had to be found
    factors = (1.0,) if sign_alone else ROUND
    round_slip = any(factor != 1.0 and math.isclose(abs(verdict.factor), factor) for factor in ROUND)
    exact = tuple(
        verdict.factor * value for value in truth.values
    )  # what was typed, where it is off from the truth itself
    meant = (values, exact) if within(values, exact, truth.tolerance, math.hypot(*exact)) else (values,)
    for other in _asked_before(key, part) if not found else ():
        theirs, alike = key.truths[other.id].values, other.unit.dimension == part.unit.dimension
        if alike and _related(truth.values, theirs, factors, SAME):
            typed = (theirs, earlier.get(other.id, theirs))
            found = found or any(_related(values, each, factors, truth.tolerance) for each in typed)
        elif round_slip and other.id in earlier:
            typed = theirs if key.truths[other.id].is_met_by(earlier[other.id]) else earlier[other.id]
            times = ROUND if alike else TENS
            found = found or any(
                _related(mine, each, times, SAME) for mine in meant for each in (typed, earlier[other.id])
            )
    return replace(verdict, nothing=True) if found else verdict


def _givens(key: Key, part: Part, truth: Truth) -> Iterator[float]:
    """The givens of the part's dimension that are its answer but for a round factor."""
    for given in key.variant.problem.givens:
        if not given.words and given.unit.dimension == part.unit.dimension:
            value = key.variant.si[given.symbol]
            if _related(truth.values, (value,), ROUND, SAME):
                yield value


def _asked_before(key: Key, part: Part) -> Iterator[Part]:
    for each in key.variant.problem.parts:
        if each.id == part.id:
            return
        if each.id in key.truths and not each.of:
            yield each


def _related(values: Values, others: Values, factors: Sequence[float], tolerance: float) -> bool:
    """Whether values are others times one of the factors, whatever the sign."""
    if len(values) != len(others) or not any(others):
        return False
    scaled = ([sign * factor * other for other in others] for factor in factors for sign in (1.0, -1.0))
    return any(within(values, each, tolerance, math.hypot(*each)) for each in scaled)


def one_number(answer: Numbers, part: Part) -> float:
    """The number as it was typed, the same in every component; else not a number."""
    sizes = answer.sizes or (part.unit.si,) * len(answer.values)
    zero = float(part.unit.offset)
    first, *others = ((value - zero) / size for value, size in zip(answer.values, sizes, strict=True))
    return first if all(abs(other - first) <= SAME * abs(first) for other in others) else math.nan


def repeated(typed: Mapping[str, float], judged: Mapping[str, tuple[Verdict, ...]]) -> list[str]:
    """The parts that hold one number which stands in more than half of all parts with a number, and is wrong in one of them.

    Else it may have been found: two bodies have one velocity, one loss of energy is asked for twice.
    """
    for number in typed.values():
        parts = [part for part, other in typed.items() if abs(other - number) <= SAME * abs(number)]
        wrong = any(
            isinstance(verdict, Wrong) or (isinstance(verdict, Mistaken) and verdict.nothing)
            for part in parts
            for verdict in judged[part]
        )
        if wrong and 1 < len(parts) > len(typed) / 2:
            return parts
    return []


def for_nothing(verdict: Verdict) -> Verdict:
    """Of one number typed nearly everywhere only what is right counts."""
    match verdict:
        case Mistaken():
            return replace(verdict, nothing=True)
        case Right(_, False) | Follows(_, True) | Wrong() | Unread() | Unmarked():
            return verdict
        case _:
            return Wrong(
                _("You gave the same number in most parts. It earns points only where it is the answer.")
            )
