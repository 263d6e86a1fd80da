"""One step of a motion in balls: a Taylor polynomial, and a bound on everything it leaves out.

Source: the a priori enclosure is Picard's and Lindelöf's in a disc of complex time (N. S. Nedialkov, K. R. Jackson and G. F. Corliss,
Appl. Math. Comput. 105 (1999) 21, for the real one); Cauchy's estimate on that disc bounds what follows the polynomial. Balls grow from
step to step by more than what they hold: they begin as points, and there are digits enough to lose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any, Protocol

from flint import acb, arb, arb_poly, arb_series, ctx

from corollary.scenes.run import GuardFailed

DISC = 4
"""So many steps long is the radius of the disc in which the motion is enclosed: each further term is smaller by this factor."""
DIGITS_USED = 0.75
"""What a polynomial leaves out may be seen in so much of the digits: the rest are for what balls grow."""
SHRINK, GROW, TRIES = 0.93, 1.7, 300


class RightSide(Protocol):
    """A motion's right side. `on` says of each contact whether its force is resolved; numbers are balls, complex balls, or series of them.

    `pull` gives the rates of the speeds, `drift` those of the places. `unresolved` bounds what contacts that are not resolved may add to any
    rate when their overlaps are at most so large, `steepness` bounds how fast rates change with the state (the row sum norm).
    """

    def pull(self, speeds: Sequence[Any], places: Sequence[Any], on: Sequence[bool]) -> list[Any]: ...

    def drift(self, speeds: Sequence[Any], places: Sequence[Any]) -> list[Any]: ...

    def unresolved(self, overlaps: Sequence[arb], on: Sequence[bool]) -> arb: ...

    def steepness(self, speeds: Sequence[arb], places: Sequence[arb], on: Sequence[bool]) -> arb: ...


@dataclass(frozen=True, slots=True)
class State:
    """Speeds and places in balls; the first places are the overlaps of the contacts."""

    speeds: tuple[arb, ...]
    places: tuple[arb, ...]


@dataclass(frozen=True, slots=True)
class Disc:
    """In complex times up to `radius` from a state no component of the motion goes farther from its start than `reach` says.

    Nor farther than `bend` from where it would be had it gone on at its first rate.
    """

    radius: arb
    reach: tuple[arb, ...]
    bend: tuple[arb, ...]


@dataclass(frozen=True, slots=True)
class EnclosedStep:
    """The motion from `start` over `length`, as polynomials; `left_out` bounds what each component may be off at any time of it."""

    start: State
    length: arb
    polynomials: tuple[Any, ...]
    left_out: tuple[arb, ...]

    def at(self, time: arb) -> State:
        """The state after a time since the start; a ball of times gives a ball of states."""
        seen = [p(time) + arb(0, off) for p, off in zip(self.polynomials, self.left_out, strict=True)]
        count = len(self.start.speeds)
        return State(tuple(seen[:count]), tuple(seen[count:]))

    def during(self) -> State:
        """All states of the step in one box."""
        half = self.length / 2
        return self.at(arb(half.mid(), half.upper()))


def disc(law: RightSide, state: State, on: Sequence[bool], longest: arb) -> Disc:
    """A disc, as large as is easily found. Raises GuardFailed when there is none of any use."""
    start, count = (*state.speeds, *state.places), len(state.speeds)
    radius = longest.mid()
    for resolved, d, rate in zip(on, state.places, law.drift(state.speeds, state.places), strict=False):
        if resolved and radius * abs(rate).mid() > d.mid():
            radius = (d / abs(rate)).mid()
    for _ in range(TRIES):
        reach = [arb(0)] * len(start)
        for _ in range(6):
            box = [acb(x + arb(0, r), arb(0, r)) for x, r in zip(start, reach, strict=True)]
            places = box[count:]
            if any(resolved and not places[j].real > 0 for j, resolved in enumerate(on)):
                break
            rates = law.pull(box[:count], places, on) + law.drift(box[:count], places)
            goes = [(radius * abs(rate)).upper() for rate in rates]
            if not all(each.is_finite() for each in goes):
                break
            if all(g <= r for g, r in zip(goes, reach, strict=True)):
                first = law.pull(state.speeds, state.places, on) + law.drift(state.speeds, state.places)
                bend = [
                    (radius * abs(rate - at_first)).upper()
                    for rate, at_first in zip(rates, first, strict=True)
                ]
                return Disc(radius, tuple(reach), tuple(bend))
            reach = [(g * arb(1.05)).upper().max(r) for g, r in zip(goes, reach, strict=True)]
        radius = (radius * arb(SHRINK)).mid()
    raise GuardFailed(
        "The motion hangs so strongly on its start that no ball with so many digits holds it; choose milder settings."
    )


def enclosed_step(
    law: RightSide, state: State, on: Sequence[bool], within: Disc, length: arb, tops: Sequence[arb]
) -> EnclosedStep | None:
    """The step of a length of at most the disc's radius over DISC; none where what is not resolved could change too much.

    `tops` are at least the largest overlaps there are as long as no force acts that is not resolved.
    """
    part = length / within.radius
    moved = [(r * part).upper() for r in within.reach]
    off = _perturbed(law, state, on, length, moved, tops)
    if off is None:
        return None
    order, left = 2, part * part / (1 - part)
    most = reduce(arb.max, within.bend).max(arb(2) ** -ctx.prec)
    goal = arb(2) ** (-DIGITS_USED * ctx.prec) / most
    while left > goal and order < ctx.prec:
        order, left = order + 1, left * part
    left_out = tuple((bend * left).upper() + off for bend in within.bend)
    return EnclosedStep(state, length, _polynomials(law, state, on, order), left_out)


def _perturbed(
    law: RightSide, state: State, on: Sequence[bool], length: arb, moved: Sequence[arb], tops: Sequence[arb]
) -> arb | None:
    """How far the forces that are not resolved take any component from where the others take it (Gronwall's lemma); none for too far."""
    if all(on):
        return arb(0)
    extra, count = arb(0), len(state.speeds)
    for _ in range(4):  # what it may be off makes it farther off
        box = [x + arb(0, m + extra) for x, m in zip((*state.speeds, *state.places), moved, strict=True)]
        places = box[count:]
        if any(resolved and not places[j] > 0 for j, resolved in enumerate(on)):
            return None
        most = law.unresolved([(top + extra).upper() for top in tops], on)
        steep = law.steepness(box[:count], places, on)
        if not (steep * length < 0.5):
            return None
        off = (2 * most * length).upper()
        if off <= extra or off.is_zero():
            return off
        extra = 2 * off
    return None


def _polynomials(law: RightSide, state: State, on: Sequence[bool], order: int) -> tuple[Any, ...]:
    """The Taylor polynomials with so many terms: each round of integrals makes the series longer by a term or two."""
    before = ctx.cap
    ctx.cap = order
    try:
        speeds, places = ([arb_series([x], 1) for x in each] for each in (state.speeds, state.places))
        while min(each.prec for each in (*speeds, *places)) < order:
            pulled = law.pull(speeds, places, on)
            speeds = [_integral(x, rate, order) for x, rate in zip(state.speeds, pulled, strict=True)]
            drifted = law.drift(speeds, places)
            places = [_integral(x, rate, order) for x, rate in zip(state.places, drifted, strict=True)]
    finally:
        ctx.cap = before
    return tuple(arb_poly(each.coeffs()) for each in (*speeds, *places))


def _integral(start: arb, rate: Any, order: int) -> Any:
    return arb_series([start, rate], order) if isinstance(rate, arb) else rate.integral() + start
