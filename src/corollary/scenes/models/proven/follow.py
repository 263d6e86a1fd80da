"""A collision followed in balls from its first touch to its last opening.

A contact k overlap^q is not smooth where it begins and ends, so no polynomial crosses that. Steps come as near as they can, each by a
share of what is left; over the last bit, of a width that shrinks with the working precision, the force is only bounded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from flint import arb, ctx

from corollary.scenes.models.certain import MoreDigits
from corollary.scenes.models.proven.laws import PairLaw, RowLaw
from corollary.scenes.models.proven.step import (
    DISC,
    GROW,
    Disc,
    EnclosedStep,
    RightSide,
    State,
    disc,
    enclosed_step,
)
from corollary.scenes.progress import tell
from corollary.scenes.run import GuardFailed

MOST_STEPS, USUAL_STEPS = 6000, 500
MOST_HALVINGS, MOST_PIECES = 200, 2000
ON, NEAR, OFF = 1, 0, -1


@dataclass(slots=True)
class Followed:
    """How it ended, the largest overlaps, when the first touch and the last opening were, the largest force squared (of a pair).

    All in the units of the law. `began` is none as long as nothing has touched.
    """

    state: State
    overlaps: list[arb]
    began: arb | None = None
    ended: arb | None = None
    force_square: arb = field(default_factory=arb)
    steps: int = 0


def row(law: RowLaw, start: State) -> Followed:
    """A row of bodies until none comes nearer to another. Raises MoreDigits, and GuardFailed when that takes too long."""
    width = _width()
    seen = Followed(start, [d.max(arb(0)) for d in start.places])
    resting = [d.is_zero() for d in start.places]
    time, state, longest = arb(0), start, arb(1)
    while seen.steps < MOST_STEPS:
        sides = [_side(d, width) for d in state.places]
        rates = law.drift(state.speeds, state.places)
        if all(s == OFF or (s == NEAR and p.is_zero()) for s, p in zip(sides, rates, strict=True)):
            if all(p <= 0 for p in rates):
                seen.state = state
                return seen
            if not any(p > 0 for p in rates):
                raise MoreDigits
        step, within = _step(law, state, sides, width, longest)
        after, longest = step.at(step.length), within.radius * GROW
        during = step.during()
        rates, within_step = law.drift(*_parts(during)), during.places
        for j, (before, rate, then) in enumerate(zip(state.places, rates, after.places, strict=True)):
            if sides[j] == NEAR:
                resting[j] = _note_touch(seen, time, before, rate, then, within_step[j], resting=resting[j])
            if sides[j] != OFF:
                seen.overlaps[j] = _deepest(step, law, j, rate, seen.overlaps[j], near=sides[j] == NEAR)
        time, state, seen.steps = time + step.length, after, seen.steps + 1
        tell(seen.steps / (seen.steps + USUAL_STEPS))
    raise GuardFailed(f"The motion could not be enclosed within {MOST_STEPS} steps.")


def pair(law: PairLaw, start: State) -> Followed:
    """One contact until it ends for the first time. Raises MoreDigits, and GuardFailed when that takes too long."""
    width = _width()
    seen = Followed(start, [start.places[0]], began=arb(0))
    time, state, longest = arb(0), start, arb(1)
    while seen.steps < MOST_STEPS:
        sides = [_side(state.places[0], width)]
        step, within = _step(law, state, sides, width, longest)
        box = _parts(step.during())
        (rate, _), on = law.drift(*box), [sides[0] == ON]
        length, ends = step.length, step.at(step.length).places[0] < 0
        if ends:
            if not (rate < 0 and state.places[0] > 0):
                raise MoreDigits
            # Between the two the overlap falls at some of the rates there are.
            length = state.places[0] / -rate
        elif not (on[0] or rate > 0 or rate < 0) and law.weight > 0 and not box[1][0] > 0:
            raise MoreDigits  # weight may let it leave and come back within the step
        seen.overlaps[0] = _deepest(step, law, 0, rate, seen.overlaps[0], near=not on[0])
        seen.force_square = maximum(
            lambda t, s=step, on=on: law.force_square(*_parts(s.at(t)), on), length, seen.force_square
        )
        time, longest, seen.steps = time + length, within.radius * GROW, seen.steps + 1
        state = step.at(length)
        tell(seen.steps / (seen.steps + USUAL_STEPS))
        if ends:
            seen.state, seen.ended = state, time
            return seen
    raise GuardFailed(f"The contact could not be enclosed within {MOST_STEPS} steps.")


def _width() -> arb:
    """Overlaps and gaps up to this are too small for steps to resolve the force."""
    return arb(2) ** (-2 * ctx.prec // 5)


def _side(overlap: arb, width: arb) -> int:
    if overlap > width:
        return ON
    return OFF if overlap < -width else NEAR


def _parts(state: State) -> tuple[Sequence[arb], Sequence[arb]]:
    return state.speeds, state.places


def _step(
    law: RightSide, state: State, sides: Sequence[int], width: arb, longest: arb
) -> tuple[EnclosedStep, Disc]:
    """A step in which no contact that is off touches, and none whose force is not resolved gets farther than four widths into the other."""
    on = [each == ON for each in sides]
    within = disc(law, state, on, longest)
    length = (within.radius / DISC).mid()
    rates = law.drift(state.speeds, state.places)
    for side, d, rate in zip(sides, state.places, rates, strict=False):
        if side == NEAR and (rate > 0 or rate < 0):
            length = length.min(((1.5 * width + d * (1 if rate < 0 else -1)) / abs(rate)).mid())
        elif side == OFF and rate > 0:
            length = length.min(((-d - 0.5 * width) / rate).mid())
    length, count = length.mid(), len(state.speeds)
    for _ in range(MOST_HALVINGS):
        part = length / within.radius
        reach = [(r * part).upper() for r in within.reach]
        speeds = [v + arb(0, r) for v, r in zip(state.speeds, reach[:count], strict=True)]
        places = [x + arb(0, r) for x, r in zip(state.places, reach[count:], strict=True)]
        ahead = law.drift(speeds, places)
        tops = [d + length * rate.max(arb(0)).upper() for d, rate in zip(state.places, ahead, strict=False)]
        if all(side == ON or top < _limit(side, width) for side, top in zip(sides, tops, strict=False)):
            step = enclosed_step(law, state, on, within, length, tops)
            if step is not None and _stays(step, sides, tops, width):
                return step, within
        length = (length / 2).mid()
    raise MoreDigits


def _limit(side: int, width: arb) -> arb:
    """How far a contact may get into the other within a step that does not resolve its force."""
    return arb(0) if side == OFF else 4 * width


def _stays(step: EnclosedStep, sides: Sequence[int], tops: Sequence[arb], width: arb) -> bool:
    """Whether that holds with the forces, too, that the step does not resolve."""
    off = step.left_out[len(step.start.speeds) :]
    return all(
        side == ON or top + more < _limit(side, width)
        for side, top, more in zip(sides, tops, off, strict=False)
    )


def _deepest(step: EnclosedStep, law: RightSide, j: int, rate: arb, known: arb, *, near: bool) -> arb:
    """The largest overlap of contact j within a step in which it grows at `rate`, or the one `known` so far."""
    ends = step.start.places[j].max(step.at(step.length).places[j])
    if rate > 0 or rate < 0:
        return known.max(ends)
    if near:
        return known.max(ends.union(4 * _width()))

    def overlap(time: arb) -> tuple[arb, arb]:
        state = step.at(time)
        return state.places[j], law.drift(*_parts(state))[j]

    return maximum(overlap, step.length, known)


def _note_touch(
    seen: Followed, time: arb, before: arb, rate: arb, then: arb, between: arb, *, resting: bool
) -> bool:
    """A contact was about its touch in a step that began at `time`: note when it began, or ceased, to touch; whether it only rests.

    Its overlap is `before` at the step's start, `then` at its end, within `between` all the time, and grows at `rate`.
    What touches from the start without closing begins and ends no touch, until it is pressed or has left. Raises MoreDigits for what
    all but touches, and for what all but opens.
    """
    if resting:
        if then > 0 and rate > 0 and before.is_zero():
            seen.began = time if seen.began is None else seen.began.min(time)
        return not (then > 0 or then < 0)
    if before > 0 and then > 0:
        return False
    if before < 0 and then < 0:
        if rate > 0 or rate < 0 or between < 0:
            return False
        raise MoreDigits
    at = time - before / rate
    if before > 0 > then and rate < 0:
        seen.ended = at if seen.ended is None else seen.ended.max(at)
    elif before < 0 < then and rate > 0:
        seen.began = at if seen.began is None else seen.began.min(at)
    else:
        raise MoreDigits
    return False


def maximum(value: Callable[[arb], tuple[arb, arb]], length: arb, known: arb) -> arb:
    """A ball about the largest value on 0 … `length`, or about the one `known`, if that is larger. Raises GuardFailed.

    `value` gives it and its rate at a ball of times.

    At a maximum the rate is small: a piece of width w leaves a doubt of w^2, so half the digits of the place are enough.
    """
    fine = arb(2) ** (16 - ctx.prec)
    least = known.max(value(arb(0))[0]).max(value(length)[0])
    found, pieces = least, [(arb(0), length)]
    for _ in range(MOST_PIECES):
        if not pieces:
            return found
        low, high = pieces.pop()
        middle, half = ((low + high) / 2).mid(), ((high - low) / 2).upper()
        here, (whole, rate) = value(middle)[0], value(arb(middle, half))
        if rate > 0 or rate < 0 or whole < least:
            continue
        least, found = least.max(here), found.max(here)
        doubt = (half * abs(rate)).upper()
        if doubt <= fine * (abs(here) + 1) + here.rad() or half < fine * length:
            found = found.max(here + doubt.union(0))
        else:
            pieces += [(low, middle), (middle, high)]
    raise GuardFailed("A largest value of the motion could not be enclosed.")
