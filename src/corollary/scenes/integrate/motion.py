"""Newton's second law integrated in time for any scene, stopping exactly where the law changes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.equations_of_motion import energy, keeps_energy, kinetic, law_of_motion
from corollary.scenes.integrate.runge_kutta import Slope, doubt, step
from corollary.scenes.models.pair import hold_apart
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.scene import Event, Scene, overlap, pairs, seen_from, start_of, velocity

MOST_STEPS = 20_000
# A body that comes back from a wall a millionth as fast as anything in the scene has come to rest.
REST = 1e-6


@dataclass(frozen=True, slots=True)
class Leg:
    """One step: from a time and state on, for `h`."""

    slope: Slope
    time: float
    before: list[float]
    first: list[float]
    h: float

    def part_way(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of the step."""
        return step(DOP853, self.slope, self.time, self.before, part * self.h, self.first)[0]


@dataclass(slots=True)
class Record:
    """The whole motion, step by step; any moment can be looked up again.

    `dropped` is the speed taken for none when a body came to rest at a wall, in units of the fastest there was.
    """

    legs: list[Leg] = field(default_factory=list)
    time: float = 0.0
    state: list[float] = field(default_factory=list)
    evaluations: int = 0
    came_to_rest: bool = False
    dropped: float = 0.0

    def at(self, time: float) -> list[float]:
        """The state at a time between the start and the end."""
        low, high = 0, len(self.legs) - 1
        while low < high:
            middle = (low + high + 1) // 2
            low, high = (middle, high) if self.legs[middle].time <= time else (low, middle - 1)
        leg = self.legs[low]
        return leg.part_way((time - leg.time) / leg.h)


def integrate(scene: Scene, tolerance: float) -> Record:
    """The scene from its start to `until`, or until nothing touches and nothing will.

    `tolerance` is the error allowed to a step, relative to the size of the places and velocities met.
    Raises GuardFailed when energy is lost, or the end is not reached.
    """
    events = [event for force in scene.forces for event in force.events(scene)]
    if scene.until is None and not (scene.contacts == scene.forces and len(scene.bodies) > 1):
        raise BadSetting(
            f"{scene.name}: forces other than contacts never end; say until when to watch, until=…"
        )
    record = Record(state=start_of(scene))
    scale = _scales(scene, record.state)
    # What touches is to be resolved as finely as at the start, however far it has come by then.
    touching = bool(scene.contacts)
    begun_with = energy(scene, 0.0, record.state) if keeps_energy(scene) else None
    h = _first_step(scene, record.state)
    fastest = max(scale[len(scale) // 2 :])
    for _ in range(MOST_STEPS):
        left = math.inf if scene.until is None else scene.until - record.time
        if left <= 1e-15 * max(record.time, h) or (scene.until is None and _over(scene, record.state)):
            _guard(scene, begun_with, record, tolerance)
            return record
        law = law_of_motion(scene, record.state)
        first = law(record.time, record.state)
        leg = Leg(law, record.time, record.state, first, min(h, left))
        after, slopes = step(DOP853, law, leg.time, leg.before, leg.h, first)
        size = doubt(DOP853, slopes, leg.h, [tolerance * s for s in scale])
        record.evaluations += len(DOP853.rows)
        if not size <= 1.0:
            h = leg.h * (max(0.2, 0.9 * size**-0.125) if size < math.inf else 0.2)
            continue
        if _grazes(scene, leg, after):
            h = 0.5 * leg.h
            continue
        part, event = _first_event(events, leg, after, record)
        if event is not None:
            leg = Leg(law, leg.time, leg.before, first, part * leg.h)
            after, slopes = step(DOP853, law, leg.time, leg.before, leg.h, first)
            record.evaluations += len(DOP853.rows) - 1
            # What the whole step said of its error is not what its part says: a contact's force is least smooth where it ends.
            if not doubt(DOP853, slopes, leg.h, [tolerance * s for s in scale]) <= 1.0:
                h = 0.5 * leg.h
                continue
        _keep_apart(scene, leg.before, after)
        if leg.h > 0.0:
            record.legs.append(leg)
        record.time, record.state = leg.time + leg.h, after
        scale = scale if touching else _grown(scale, after)
        if event is not None and event.turn is not None and _turn(scene, event, record, fastest):
            return record
        h = (
            leg.h * (min(5.0, 0.9 * size**-0.125) if size > 0.0 else 5.0)
            if event is None
            else max(leg.h, 0.1 * h)
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


def _grazes(scene: Scene, leg: Leg, after: Sequence[float]) -> bool:
    """Whether two bodies may touch and part inside a step; judged by straight lines, so it errs on shorter steps."""
    if not scene.contacts:
        return False
    for a, b in pairs(scene):
        (depth, growing), left = overlap(scene, leg.before, a, b), overlap(scene, after, a, b)[0]
        if depth == 0.0 and growing > 0.0 > left:  # the whole contact would be leapt over
            return True
        if (
            depth < 0.0
            and left < 0.0
            and (_will_meet(scene, leg.before, a, b, leg.h) or _will_meet(scene, after, a, b, -leg.h))
        ):
            return True
    return False


def _keep_apart(scene: Scene, before: Sequence[float], after: Sequence[float]) -> None:
    """Raises BadSetting when two bodies that touch are so soft that their centres all but meet, or have met within a step."""
    if not scene.contacts:
        return
    for a, b in pairs(scene):
        depth = overlap(scene, after, a, b)[0]
        if depth > 0.0:
            (was, _), (now, _) = seen_from(scene, before, a, b), seen_from(scene, after, a, b)
            reach = scene.bodies[a].radius + scene.bodies[b].radius
            met = sum(x * y for x, y in zip(was, now, strict=True)) <= 0.0
            hold_apart(reach if met else depth, reach)


def _first_event(
    events: list[Event], leg: Leg, after: list[float], record: Record
) -> tuple[float, Event | None]:
    """The part of the step at which the first event happens, by false position, and which it is.

    A step ends just beyond an event, so that the next one begins under the new law; but just before a wall, on the right side.
    """
    best, which = 1.0, None
    for event in events:
        old, new = event.value(leg.before), event.value(after)
        wall = event.turn is not None
        if (not (old >= 0.0 > new)) if wall else (old == 0.0 or old * new >= 0.0):
            continue
        left, right, f, g, side = 0.0, 1.0, old, new, 0
        while right - left > 1e-14:
            middle = left + (right - left) * f / (f - g) if f != g else left
            middle = middle if left < middle < right else 0.5 * (left + right)
            value = event.value(leg.part_way(middle))
            record.evaluations += len(DOP853.rows) - 1
            if value * new <= 0.0:
                left, f, g, side = middle, value, g * (0.5 if side > 0 else 1.0), 1
            else:
                right, g, f, side = middle, value, f * (0.5 if side < 0 else 1.0), -1
        if (left if wall else right) < best:
            best, which = (left if wall else right), event
    return best, which


def _turn(scene: Scene, event: Event, record: Record, fastest: float) -> bool:
    """Give the body its new velocity; true when that is as good as none."""
    new = event.turn(record.state) if event.turn else []
    start = scene.axes * (len(scene.bodies) + event.body)
    old = velocity(scene, record.state, event.body)
    changed = math.dist(new, old)
    away = sum(v * (v - u) for u, v in zip(old, new, strict=True)) / changed if changed else 0.0
    record.came_to_rest = away < REST * fastest
    if record.came_to_rest and away > 0.0:
        record.dropped = away / fastest
        new = [v - away * (v - u) / changed for u, v in zip(old, new, strict=True)]
    record.state = [*record.state[:start], *new, *record.state[start + scene.axes :]]
    return record.came_to_rest


def _guard(scene: Scene, before: float | None, record: Record, tolerance: float) -> None:
    if before is None:
        return
    after = energy(scene, record.time, record.state)
    size = max(abs(before), kinetic(scene, record.time, record.state), 1e-300)
    allowed = 1e4 * tolerance + 1e-15 * record.evaluations
    if abs(after - before) > allowed * size:
        changed = (after - before) / size
        raise GuardFailed(
            f"{scene.name}: the energy changed by {changed:.1e} of itself; {allowed:.1e} is allowed."
        )
