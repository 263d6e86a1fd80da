"""From the moment of the first touch to that of the last opening, both found within the steps of a motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.motion import Leg, Record
from corollary.scenes.scene import Scene, overlap, pairs, place


@dataclass(frozen=True, slots=True)
class Span:
    """`lasts` (s), and by how much (s) the rounding of places may have moved both of its ends."""

    lasts: float
    doubt: float


def contact_span(scene: Scene, record: Record) -> Span | None:
    """How long there was a contact; none when there was none.

    Steps end just beyond a beginning or an opening. The moment itself is looked up from there, and steps are added up rather than
    times taken from each other: a short contact after a long flight keeps its digits.
    """
    touched = [
        i
        for i, leg in enumerate(record.legs)
        if any(_depths(scene, record, i, a, b) for a, b in pairs(scene))
    ]
    if not touched:
        return None
    first, last = touched[0], touched[-1]
    began, ended = _beginning(scene, record, first), _ending(scene, record, last)
    steps = math.fsum(leg.h for leg in record.legs[first : last + 1])
    noise = (last - first + 4) * math.ulp(
        max(abs(x) for leg in record.legs[first : last + 1] for x in _places(scene, leg.before))
    )
    return Span(max(steps - began.before - ended.left, 0.0), noise * (began.slowness + ended.slowness))


@dataclass(frozen=True, slots=True)
class _Moment:
    """`before` and `left` are the times to it from the start of its step, and from it to the end; 1/speed is its slowness (s/m)."""

    before: float
    left: float
    slowness: float


def _places(scene: Scene, state: Sequence[float]) -> Sequence[float]:
    return [x for i in range(len(scene.bodies)) for x in place(scene, state, i)]


def _depths(scene: Scene, record: Record, i: int, a: int, b: int) -> tuple[float, float] | None:
    """The overlaps at both ends of a step in which two bodies touch; what turned at a wall there has not moved."""
    after = record.legs[i + 1].before if i + 1 < len(record.legs) else record.state
    depths = overlap(scene, record.legs[i].before, a, b)[0], overlap(scene, after, a, b)[0]
    return depths if max(depths) > 0.0 else None


def _beginning(scene: Scene, record: Record, i: int) -> _Moment:
    leg = record.legs[i]
    found = {pair: depths for pair in pairs(scene) if (depths := _depths(scene, record, i, *pair))}
    if any(old >= 0.0 for old, _ in found.values()):
        return _Moment(0.0, leg.h, 0.0)
    return min((_crossing(scene, leg, a, b) for a, b in found), key=lambda moment: moment.before)


def _ending(scene: Scene, record: Record, i: int) -> _Moment:
    leg = record.legs[i]
    found = {pair: depths for pair in pairs(scene) if (depths := _depths(scene, record, i, *pair))}
    if any(new > 0.0 for _, new in found.values()):
        return _Moment(leg.h, 0.0, 0.0)
    return max((_crossing(scene, leg, a, b) for a, b in found), key=lambda moment: moment.before)


def _crossing(scene: Scene, leg: Leg, a: int, b: int) -> _Moment:
    """When the overlap was zero in a step that ends just beyond: one step of Newton's method back from there."""
    depth, growing = overlap(scene, leg.part_way(1.0), a, b)
    if growing == 0.0:
        return _Moment(leg.h, 0.0, math.inf)
    left = min(max(depth / growing, 0.0), leg.h)
    return _Moment(leg.h - left, left, 1.0 / abs(growing))
