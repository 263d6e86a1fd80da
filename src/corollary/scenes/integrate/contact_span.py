"""From the moment of the first touch to that of the last opening, both found within the steps of a motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.motion import Trajectory
from corollary.scenes.integrate.step import IntegrationStep
from corollary.scenes.scene import Scene, overlap, pairs, place


@dataclass(frozen=True, slots=True)
class Span:
    """`lasts` (s), and by how much (s) both of its ends may be off: as long as it takes to cross what the places there may be off."""

    lasts: float
    error_estimate: float


def contact_span(scene: Scene, path: Trajectory) -> Span | None:
    """How long there was a contact; none when there was none.

    Steps end just beyond a beginning or an opening. The moment itself is looked up from there, and steps are added up rather than
    times taken from each other: a short contact after a long flight keeps its digits.
    """
    touched = [
        i for i in range(len(path.steps)) if any(_depths(scene, path, i, a, b) for a, b in pairs(scene))
    ]
    if not touched:
        return None
    first, last = touched[0], touched[-1]
    began, ended = _beginning(scene, path, first), _ending(scene, path, last)
    steps = math.fsum(step.h for step in path.steps[first : last + 1])
    rounding = (last - first + 4) * math.ulp(
        max(abs(x) for step in path.steps[first : last + 1] for x in _places(scene, step.before))
    )
    # A touch is met to the error a step was allowed in a place, and a slow one late by so much over its speed.
    off = rounding + path.allowed
    return Span(max(steps - began.before - ended.left, 0.0), off * (began.slowness + ended.slowness))


@dataclass(frozen=True, slots=True)
class _Moment:
    """`before` and `left` are the times to it from the start of its step, and from it to the end; 1/speed is its slowness (s/m)."""

    before: float
    left: float
    slowness: float


def _places(scene: Scene, state: Sequence[float]) -> Sequence[float]:
    return [x for i in range(len(scene.bodies)) for x in place(scene, state, i)]


def _depths(scene: Scene, path: Trajectory, i: int, a: int, b: int) -> tuple[float, float] | None:
    """The overlaps at both ends of a step in which two bodies touch; what turned at a wall there has not moved."""
    after = path.steps[i + 1].before if i + 1 < len(path.steps) else path.state
    depths = overlap(scene, path.steps[i].before, a, b)[0], overlap(scene, after, a, b)[0]
    return depths if max(depths) > 0.0 else None


def _beginning(scene: Scene, path: Trajectory, i: int) -> _Moment:
    step = path.steps[i]
    found = {pair: depths for pair in pairs(scene) if (depths := _depths(scene, path, i, *pair))}
    if any(old >= 0.0 for old, _ in found.values()):
        return _Moment(0.0, step.h, 0.0)
    return min((_crossing(scene, step, a, b) for a, b in found), key=lambda moment: moment.before)


def _ending(scene: Scene, path: Trajectory, i: int) -> _Moment:
    step = path.steps[i]
    found = {pair: depths for pair in pairs(scene) if (depths := _depths(scene, path, i, *pair))}
    if any(new > 0.0 for _, new in found.values()):
        return _Moment(step.h, 0.0, 0.0)
    return max((_crossing(scene, step, a, b) for a, b in found), key=lambda moment: moment.before)


def _crossing(scene: Scene, step: IntegrationStep, a: int, b: int) -> _Moment:
    """When the overlap was zero in a step that ends just beyond: one step of Newton's method back from there."""
    depth, growing = overlap(scene, step.after, a, b)
    if growing == 0.0:
        return _Moment(step.h, 0.0, math.inf)
    left = min(max(depth / growing, 0.0), step.h)
    return _Moment(step.h - left, left, 1.0 / abs(growing))
