"""What is observed of a motion that was integrated, looked up between its steps."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from typing import assert_never

from corollary.scenes.conserved import impulses, momentum
from corollary.scenes.integrate.contact_span import contact_span
from corollary.scenes.integrate.equations_of_motion import energy, kinetic, masses_at
from corollary.scenes.integrate.motion import Trajectory, integrate
from corollary.scenes.run import BadSetting, GuardFailed, Observable, Observed, Outcome, Run
from corollary.scenes.scene import Scene, overlap, pairs, place, start_of, velocity

Value = Callable[[Sequence[float]], float]
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


def measured(
    scene: Scene, observe: Collection[Observable], tolerance: float, why: str, times: Sequence[float] = ()
) -> Run:
    """Integrate twice, a finer run after a coarser; the difference is the error of the coarser. `times` (s) are a trajectory's."""
    allowed = max(tolerance / 30.0, 1e-14)
    coarse, fine = integrate(scene, max(tolerance, 1e-13)), integrate(scene, allowed)
    observe = [o for o in Observable if o in observe]  # a set's order is another in every process
    rough = {o.value: _look(scene, coarse, o, times) for o in observe}
    observed = {o.value: _look(scene, fine, o, times) for o in observe}
    # Two runs that took nearly the same steps agree better than either is right: some steps' allowed error is the least that is stated.
    errors = {
        name: max(_apart(rough[name], observed[name]), fine.dropped, 3.0 * allowed) for name in observed
    }
    span = contact_span(scene, fine) if Observable.DURATION in observe else None
    if span is not None:
        duration = Observable.DURATION.value
        errors[duration] = max(
            errors[duration], min(span.error_estimate / span.lasts, 1.0) if span.lasts else 1.0
        )
    spent = coarse.evaluations + fine.evaluations
    return Run(observed, errors, "integration", why, spent, _outcome(scene, fine))


def _outcome(scene: Scene, path: Trajectory) -> Outcome:
    if path.came_to_rest:
        return "sticks"
    if scene.until is not None:
        return "escaped" if _beyond_every_edge(scene, path.state) else "bound"
    return "released" if contact_span(scene, path) else "missed"


def _beyond_every_edge(scene: Scene, state: Sequence[float]) -> bool:
    """Whether forces of the scene have edges, and its bodies are beyond them on their way out."""
    edges = [force.edge for force in scene.forces if math.isfinite(force.edge)]
    places = [(place(scene, state, i), velocity(scene, state, i)) for i in range(len(scene.bodies))]
    outward = all(sum(a * b for a, b in zip(x, v, strict=True)) > 0.0 for x, v in places)
    return bool(edges) and outward and all(math.hypot(*x) >= edge for x, _ in places for edge in edges)


def _apart(a: Observed, b: Observed) -> float:
    rough, fine = (x if isinstance(x, tuple) else (x,) for x in (a, b))
    size = max((abs(x) for x in fine), default=1.0) or 1.0
    if len(rough) != len(fine):
        return math.inf
    return max((abs(x - y) / size for x, y in zip(rough, fine, strict=True) if x != y), default=2e-15)


def _look(scene: Scene, path: Trajectory, what: Observable, times: Sequence[float]) -> Observed:
    match what:
        case Observable.VELOCITIES:
            return tuple(v for i in range(len(scene.bodies)) for v in velocity(scene, path.state, i))
        case Observable.ENERGY_RATIO:
            before = kinetic(scene, 0.0, start_of(scene))
            return kinetic(scene, path.time, path.state) / before if before else math.inf
        case Observable.LARGEST_OVERLAP:
            return max(
                [
                    0.0,
                    *(
                        _largest(path, lambda y, a=a, b=b: overlap(scene, y, a, b)[0])
                        for a, b in pairs(scene)
                    ),
                ]
            )
        case Observable.PEAK_FORCE:
            return _peak_force(scene, path)
        case Observable.DURATION:
            span = contact_span(scene, path)
            return span.lasts if span else 0.0
        case Observable.TURNING_POINTS:
            turns = _turns(scene, path)
            return (
                tuple(sorted({min(turns, key=lambda t: t[1])[1], max(turns, key=lambda t: t[1])[1]}))
                if turns
                else ()
            )
        case Observable.PERIOD:
            inner = [time for time, _, inward in _turns(scene, path) if inward]
            if len(inner) < 2:
                raise BadSetting(
                    f"{scene.name}: the distance did not return twice before until = {scene.until} s."
                )
            return (inner[-1] - inner[0]) / (len(inner) - 1)
        case Observable.IMPULSE:
            if masses_at(scene, 1.0) != masses_at(scene, 0.0):
                raise BadSetting(
                    f"{scene.name}: the impulse on a body whose mass changes is not its change of momentum; ask for velocities."
                )
            return impulses(scene, start_of(scene), path.state)
        case Observable.MOMENTUM:
            return momentum(scene, path.time, path.state)
        case Observable.ENERGY:
            return energy(scene, path.time, path.state)
        case Observable.TRAJECTORY:
            return tuple(
                x for time in times for x in _state_at(scene, path, time)[: scene.axes * len(scene.bodies)]
            )
        case _:
            assert_never(what)


def _state_at(scene: Scene, path: Trajectory, time: float) -> Sequence[float]:
    """The state at any time from the start on; after the end of a motion that no time ends, bodies go on straight."""
    if time <= path.time:
        return path.at(time) if path.steps else path.state
    half = scene.axes * len(scene.bodies)
    places, velocities = path.state[:half], path.state[half:]
    if path.came_to_rest and any(velocities):
        raise GuardFailed(
            f"{scene.name}: a body came to rest at {path.time:.6g} s while others moved; ask for earlier times only."
        )
    return [*(x + v * (time - path.time) for x, v in zip(places, velocities, strict=True)), *velocities]


def _peak_force(scene: Scene, path: Trajectory) -> float:
    values: list[Value] = [
        lambda y, f=f, a=a, b=b: math.hypot(*f.between(scene, y, a, b))
        for f in scene.contacts
        for a, b in pairs(scene)
    ]
    return max((_largest(path, value) for value in values), default=0.0)


def _largest(path: Trajectory, value: Value) -> float:
    """The largest value at any moment: the best step's neighbourhood, narrowed by golden sections."""
    samples = [value(step.before) for step in path.steps] + [value(path.state)]
    best = max(range(len(samples)), key=samples.__getitem__)
    top = samples[best]
    for step in path.steps[max(best - 1, 0) : best + 1]:
        left, right = 0.0, 1.0
        while right - left > 1e-8:
            a, b = right - GOLDEN * (right - left), left + GOLDEN * (right - left)
            left, right = (left, b) if value(step.part_way(a)) > value(step.part_way(b)) else (a, right)
        top = max(top, value(step.part_way(0.5 * (left + right))))
    return top


def _turns(scene: Scene, path: Trajectory) -> list[tuple[float, float, bool]]:
    """Times and distances from the origin at which the first body turns, and whether it had come inward."""

    def along(y: Sequence[float]) -> float:
        return sum(a * b for a, b in zip(place(scene, y, 0), velocity(scene, y, 0), strict=True))

    found: list[tuple[float, float, bool]] = []
    last = 0.0
    for step in path.steps:
        before, after = along(step.before), along(step.after)
        if last * before < 0.0:  # turned in no time, by a wall or the hard core
            found.append((step.x, math.hypot(*place(scene, step.before, 0)), last < 0.0))
        last = after
        if before * after >= 0.0 and not (before == 0.0 and not found and step is path.steps[0]):
            continue
        left, right = 0.0, 1.0
        if before == 0.0:
            right = 0.0
        while right - left > 1e-15:
            middle = 0.5 * (left + right)
            left, right = (middle, right) if along(step.part_way(middle)) * before > 0.0 else (left, middle)
        r = math.hypot(*place(scene, step.part_way(right), 0))
        found.append((step.x + right * step.h, r, before < 0.0 or (before == 0.0 and after > 0.0)))
    return found
