"""Newton's second law integrated in time for any scene, stopping exactly where the law changes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from corollary.scenes.integrate.controller import factor
from corollary.scenes.integrate.equations_of_motion import energy, keeps_energy, kinetic, law_of_motion
from corollary.scenes.integrate.step import EVALUATIONS, IntegrationStep, tried
from corollary.scenes.models.pair import refuse_too_soft
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.scene import Event, Scene, overlap, pairs, seen_from, start_of, velocity

MOST_STEPS = 20_000
# A body that comes back from a wall a millionth as fast as anything in the scene has come to rest.
REST = 1e-6


@dataclass(slots=True)
class Trajectory:
    """The whole motion, step by step; any moment can be looked up again.

    `dropped` is the speed taken for none when a body came to rest at a wall, in units of the fastest there was. `allowed` is the error
    (m) that one step was allowed to make in a place.
    """

    steps: list[IntegrationStep] = field(default_factory=list[IntegrationStep])
    time: float = 0.0
    state: list[float] = field(default_factory=list[float])
    evaluations: int = 0
    came_to_rest: bool = False
    dropped: float = 0.0
    allowed: float = 0.0

    def at(self, time: float) -> list[float]:
        """The state at a time between the start and the end."""
        low, high = 0, len(self.steps) - 1
        while low < high:
            middle = (low + high + 1) // 2
            low, high = (middle, high) if self.steps[middle].x <= time else (low, middle - 1)
        step = self.steps[low]
        return step.part_way((time - step.x) / step.h)


def integrate(scene: Scene, tolerance: float) -> Trajectory:
    """The scene from its start to `until`, or until nothing touches and nothing will.

    `tolerance` is the error allowed to a step, relative to the size of the places and velocities met.
    Raises GuardFailed when energy is lost, or the end is not reached.
    """
    events = [event for force in scene.forces for event in force.events(scene)]
    if scene.until is None and not (scene.contacts == scene.forces and len(scene.bodies) > 1):
        raise BadSetting(
            f"{scene.name}: forces other than contacts never end; say until when to watch, until=…"
        )
    path = Trajectory(state=start_of(scene))
    scale = _scales(scene, path.state)
    # What touches is to be resolved as finely as at the start, however far it has come by then.
    touching = bool(scene.contacts)
    begun_with = energy(scene, 0.0, path.state) if keeps_energy(scene) else None
    h = _first_step(scene, path.state)
    fastest = max(scale[len(scale) // 2 :])
    for _ in range(MOST_STEPS):
        left = math.inf if scene.until is None else scene.until - path.time
        if left <= 1e-15 * max(path.time, h) or (scene.until is None and _over(scene, path.state)):
            _guard(scene, begun_with, path, tolerance)
            return path
        law = law_of_motion(scene, path.state)
        allowed = [tolerance * s for s in scale]
        path.allowed = allowed[0]
        step = tried(law, path.time, path.state, min(h, left), allowed)
        path.evaluations += EVALUATIONS + 1
        if not step.size <= 1.0:
            h = step.h * factor(step.size)
            continue
        if _grazes(scene, step):
            h = 0.5 * step.h
            continue
        size = step.size
        part, event = _first_event(events, step, path)
        if event is not None:
            step = tried(law, path.time, path.state, part * step.h, allowed)
            path.evaluations += EVALUATIONS
            # What the whole step said of its error is not what its part says: a contact's force is least smooth where it ends.
            if not step.size <= 1.0:
                h = 0.5 * step.h
                continue
        _refuse_too_soft(scene, step)
        if step.h > 0.0:
            path.steps.append(step)
        path.time, path.state = step.x + step.h, step.after
        scale = scale if touching else _grown(scale, step.after)
        if event is not None and event.turn is not None and _turn(scene, event, path, fastest):
            return path
        # A law that has just begun to act may be much shorter than the step before: a hard contact throws a stage of too long a step
        # so far out that the later stages, the only ones that count in DOP853, feel nothing, and its error looks like zero.
        h = (
            step.h * factor(size)
            if event is None
            else min(max(step.h, 0.1 * h), _first_step(scene, path.state))
        )
    raise GuardFailed(
        f"{scene.name}: the end was not reached within {MOST_STEPS} steps. Watch for a shorter time."
    )


def _scales(scene: Scene, state: Sequence[float]) -> list[float]:
    """Sizes of the places and of the velocities in a scene, for each component."""
    count = scene.axes * len(scene.bodies)
    long = max(max(map(abs, state[:count])), *(b.radius for b in scene.bodies)) or 1.0
    fast = max(map(abs, state[count:]))
    slope = law_of_motion(scene, state)(0.0, state)
    fast = max(fast, math.sqrt(long * max(map(abs, slope[count:])))) or 1.0
    return [long] * count + [fast] * count


def _grown(scale: list[float], state: Sequence[float]) -> list[float]:
    """The sizes, with the places and velocities met since: a motion that grows is known to a part of what it has become."""
    half = len(scale) // 2
    long, fast = max(scale[0], *map(abs, state[:half])), max(scale[half], *map(abs, state[half:]))
    return [long] * half + [fast] * half


def _first_step(scene: Scene, state: Sequence[float]) -> float:
    scale, slope = _scales(scene, state), law_of_motion(scene, state)(0.0, state)
    return 1e-3 * min(s / abs(r) for s, r in zip(scale, slope, strict=True) if r) if any(slope) else 1e-3


def _over(scene: Scene, state: Sequence[float]) -> bool:
    """Whether nothing touches and no straight line leads to a touch."""
    for a, b in pairs(scene):
        depth, growing = overlap(scene, state, a, b)
        if depth > 0.0 or (growing > 0.0 and _will_meet(scene, state, a, b)):
            return False
    return True


def never_touch(scene: Scene) -> bool:
    """Whether bodies that go on as they start never touch."""
    return _over(scene, start_of(scene))


def _will_meet(scene: Scene, state: Sequence[float], a: int, b: int, within: float = math.inf) -> bool:
    """Whether the straight line two bodies are on brings them into touch within a time (negative: had them in touch)."""
    apart, relative = seen_from(scene, state, a, b)
    speed = math.hypot(*relative)
    if speed == 0.0:
        return False
    along = -sum(x * v for x, v in zip(apart, relative, strict=True)) / speed**2
    when = min(max(along, min(within, 0.0)), max(within, 0.0))
    nearest = math.hypot(*(x + v * when for x, v in zip(apart, relative, strict=True)))
    return nearest < scene.bodies[a].radius + scene.bodies[b].radius


def _grazes(scene: Scene, step: IntegrationStep) -> bool:
    """Whether two bodies may touch and part inside a step; judged by straight lines, so it errs on shorter steps."""
    if not scene.contacts:
        return False
    for a, b in pairs(scene):
        (depth, growing), left = overlap(scene, step.before, a, b), overlap(scene, step.after, a, b)[0]
        if depth == 0.0 and growing > 0.0 > left:  # the whole contact would be leapt over
            return True
        if (
            depth < 0.0
            and left < 0.0
            and (_will_meet(scene, step.before, a, b, step.h) or _will_meet(scene, step.after, a, b, -step.h))
        ):
            return True
    return False


def _refuse_too_soft(scene: Scene, step: IntegrationStep) -> None:
    """Raises BadSetting when two bodies that touch are so soft that their centres all but meet, or have met within a step."""
    if not scene.contacts:
        return
    for a, b in pairs(scene):
        depth = overlap(scene, step.after, a, b)[0]
        if depth > 0.0:
            (was, _), (now, _) = seen_from(scene, step.before, a, b), seen_from(scene, step.after, a, b)
            reach = scene.bodies[a].radius + scene.bodies[b].radius
            met = sum(x * y for x, y in zip(was, now, strict=True)) <= 0.0
            refuse_too_soft(reach if met else depth, reach)


def _first_event(events: list[Event], step: IntegrationStep, path: Trajectory) -> tuple[float, Event | None]:
    """The part of the step at which the first event happens, by false position, and which it is.

    A step ends just beyond an event, so that the next one begins under the new law; but just before a wall, on the right side.
    """
    best, which = 1.0, None
    for event in events:
        old, new = event.value(step.before), event.value(step.after)
        wall = event.turn is not None
        if (not (old >= 0.0 > new)) if wall else (old == 0.0 or old * new >= 0.0):
            continue
        left, right, f, g, side = 0.0, 1.0, old, new, 0
        while right - left > 1e-14:
            middle = left + (right - left) * f / (f - g) if f != g else left
            middle = middle if left < middle < right else 0.5 * (left + right)
            value = event.value(step.part_way(middle))
            path.evaluations += EVALUATIONS
            if value * new <= 0.0:
                left, f, g, side = middle, value, g * (0.5 if side > 0 else 1.0), 1
            else:
                right, g, f, side = middle, value, f * (0.5 if side < 0 else 1.0), -1
        if (left if wall else right) < best:
            best, which = (left if wall else right), event
    return best, which


def _turn(scene: Scene, event: Event, path: Trajectory, fastest: float) -> bool:
    """Give the body its new velocity; true when that is too slow to be told from rest."""
    new: Sequence[float] = event.turn(path.state) if event.turn else ()
    start = scene.axes * (len(scene.bodies) + event.body)
    old = velocity(scene, path.state, event.body)
    changed = math.dist(new, old)
    away = sum(v * (v - u) for u, v in zip(old, new, strict=True)) / changed if changed else 0.0
    path.came_to_rest = away < REST * fastest
    if path.came_to_rest and away > 0.0:
        path.dropped = away / fastest
        new = [v - away * (v - u) / changed for u, v in zip(old, new, strict=True)]
    path.state = [*path.state[:start], *new, *path.state[start + scene.axes :]]
    return path.came_to_rest


def _guard(scene: Scene, before: float | None, path: Trajectory, tolerance: float) -> None:
    if before is None:
        return
    after = energy(scene, path.time, path.state)
    size = max(abs(before), kinetic(scene, path.time, path.state), 1e-300)
    allowed = 1e4 * tolerance + 1e-15 * path.evaluations
    if abs(after - before) > allowed * size:
        changed = (after - before) / size
        raise GuardFailed(
            f"{scene.name}: the energy changed by {changed:.1e} of itself; {allowed:.1e} is allowed."
        )
