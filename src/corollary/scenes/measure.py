"""Observables of a motion that was followed in time, with errors from runs of other tolerances and other data."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from corollary.scenes.body import starts_across
from corollary.scenes.forces.contact import Contact
from corollary.scenes.motion.conserved import (
    conserved,
    energy_lost,
    energy_off,
    hottest,
    keeps_energy,
    kinetic,
)
from corollary.scenes.motion.equations_of_motion import System
from corollary.scenes.motion.follow import follow
from corollary.scenes.motion.observe import contact_span, flat, look, near, outcome, state_at, unequal
from corollary.scenes.motion.path import Trajectory
from corollary.scenes.progress import part
from corollary.scenes.run import (
    COARSEST,
    FINER,
    ILL,
    BadSetting,
    GuardFailed,
    Measurement,
    Observable,
    Observed,
    Run,
    components,
)
from corollary.scenes.scene import Body, ForceBetween, Scene, overlap, pairs, place, start_of, velocity

CHANGED = 1e-7
"""The relative change of the data with which the condition is found."""


def perturbed(scene: Scene) -> Scene:
    """The same with masses, velocities and spins changed by about CHANGED of themselves, each in its own way.

    What nothing touches starts from another place, too, by CHANGED of the size of the scene: neither the fall of a ball from rest nor
    the way of one that flies along an axis would feel any of the others. What starts from rest stays at rest, and
    a first body that starts across the way to the origin starts across it: its distance turns there.
    """

    def share(i: int) -> float:
        return CHANGED * math.cos(1.0 + 2.4 * i)

    long = max(abs(x) for body in scene.bodies for x in (*body.place, body.radius))
    touched = _touched(scene, 4.0 * CHANGED * long)
    bodies: list[Body] = []
    for i, body in enumerate(scene.bodies):
        if math.isinf(body.mass):
            turned = 0.0 if math.isinf(body.resists_spin) else share(3 * i + 2)
            bodies.append(replace(body, spin=body.spin * (1.0 + turned)))
            continue
        place = body.place
        if i not in touched:
            place = tuple(x + share(3 * i + j) * long for j, x in enumerate(place))
        velocity = tuple(v * (1.0 + share(3 * i + j)) for j, v in enumerate(body.velocity))
        if i == 0 and any(body.place) and starts_across(body):
            along = sum(x * v for x, v in zip(place, velocity, strict=True)) / math.fsum(x * x for x in place)
            velocity = tuple(v - along * x for x, v in zip(place, velocity, strict=True))
        bodies.append(
            replace(
                body,
                place=place,
                velocity=velocity,
                spin=body.spin * (1.0 + share(3 * i + 2)),
                mass=body.mass * (1.0 + share(i + 7)),
            )
        )
    return replace(scene, bodies=tuple(bodies))


def _touched(scene: Scene, within: float) -> set[int]:
    """The bodies that others, walls, strings or rods touch or hold at the start, or come as near (m) to."""
    start = start_of(scene)
    found: set[int] = set()
    for constraint in System(scene).constraints:
        if constraint.two_sided or constraint.gap(0.0, start) <= within:
            found.update(constraint.bodies)
    for a, b in pairs(scene):
        if overlap(scene, start, a, b)[0] >= -within:
            found.update((a, b))
    return found


BY_BODY = {Observable.VELOCITIES, Observable.TRAJECTORY, Observable.IMPULSE}
HANDED_ON = 0.3
"""Such a part of a body's error is another's, too, that it pulls at."""


def shares(
    scene: Scene,
    rough: Trajectory,
    right: Trajectory,
    what: Observable,
    times: Sequence[float],
    sizes: dict[Observable, float],
) -> list[float]:
    """How far two runs are apart as a whole, body by body, in the unit of each number that is observed.

    The error of a single component may pass through zero between two tolerances; that of a body's place and velocity together does
    not. For what is not a number of each body: the largest, in units of the sizes of the scene. What fades for ever is given up at
    other moments by both, and compared at the earlier one; what flies apart at the later one.
    """
    long, fast, axes = sizes[Observable.TRAJECTORY], sizes[Observable.VELOCITIES], scene.axes
    ends = None
    if scene.until is None:
        ends = (min if rough.settled and right.settled else max)(rough.time, right.time)

    def spread(time: float | None) -> list[float]:
        first, second = (p.state if time is None else state_at(scene, p, time) for p in (rough, right))
        # At a hit velocities jump, and places do not.
        jumps = time is not None and rough.hits_before(time) != right.hits_before(time)
        own = [
            max(
                math.dist(place(scene, first, i), place(scene, second, i)) / long,
                0.0 if jumps else math.dist(velocity(scene, first, i), velocity(scene, second, i)) / fast,
            )
            for i in range(len(scene.bodies))
        ]
        return _handed_on(scene, own)

    match what:
        case Observable.VELOCITIES:
            return [each * fast for each in spread(ends) for _ in range(axes)]
        case Observable.TRAJECTORY:
            return [each * long for time in times for each in spread(time) for _ in range(axes)]
        case Observable.IMPULSE:
            loose = [(b.mass, s) for b, s in zip(scene.bodies, spread(ends), strict=True)]
            return [m * s * fast for m, s in loose if not math.isinf(m) for _ in range(axes)]
        case _:
            return [max(spread(ends))]


def _handed_on(scene: Scene, own: Sequence[float]) -> list[float]:
    """With what those are off that a body is tied to: they pull it along, as far as their masses can; by chance two runs may agree about it."""
    found, masses = list(own), [body.mass for body in scene.bodies]
    for a, b in (force.ends for force in scene.forces if isinstance(force, ForceBetween)):
        for i, j in ((a, b), (b, a)):
            if not math.isinf(masses[j]):
                found[i] = max(found[i], HANDED_ON * min(1.0, masses[j] / masses[i]) * own[j])
    return found


def apart_by(a: Observed, b: Observed) -> tuple[float, ...]:
    """How far two values are apart, component by component; infinitely where they have not as many."""
    first, second = components(a), components(b)
    if len(first) != len(second):
        return (math.inf,) * len(second)
    return tuple(abs(x - y) if x != y else 0.0 for x, y in zip(first, second, strict=True))


SAFETY = 1.5
"""What the difference of the two is multiplied with: it is the coarser run's error, the finer's is a tenth of it or less."""
FEWER = 0.65
"""Of the steps allowed the coarser run may take such a part: the finer, of order eight, takes 20^(1/8) times more, and is not to be begun in vain."""
FINEST, TIGHTER = 2e-14, 1e-2
GENTLE, STEEP = 3.0, 1e-8
"""Contacts of a higher power set in so steeply that coarse steps pass over it, in both runs alike: this is the coarsest tolerance then."""
BY_TOUCH = 10.0
"""So many times what a step may be off is what a slight touch, or the root that a parting ends in, has cost in 10 000 draws."""
HIT = 1e-12
"""Hits of the coarser run give back less by such a part, some thousand roundings: flights from one to the next are followed exactly by any steps, and two
runs would round them alike, however much what follows makes of it."""
ROUNDED = 2.0
"""So many roundings of a place show in an overlap, whose force hands them on."""
BOUNCED = 0.2
"""Such a part of what steps may be off are two of the bounces that are left out."""


@lru_cache(maxsize=8)
def _paths(scene: Scene, tolerance: float) -> tuple[float, Trajectory, Trajectory, Trajectory | None]:
    """The tolerance that is fine enough, a coarser run, a finer one, and a coarser one of slightly other data; none if that cannot be followed."""
    steep = any(isinstance(force, Contact) and force.q > GENTLE for force in scene.contacts)
    finer = min(tolerance, STEEP if steep else COARSEST)
    try:
        if finer == tolerance:
            return tolerance, *_followed(scene, tolerance)
    except GuardFailed as error:
        finer = tolerance * TIGHTER
        if not error.finer or finer < FINER * FINEST:
            raise
    return _paths(scene, finer)  # under the tolerance that it gives back


def _followed(scene: Scene, tolerance: float) -> tuple[Trajectory, Trajectory, Trajectory | None]:
    fine = max(tolerance / FINER, FINEST)
    with part(0.0, 0.25):
        rough = follow(scene, max(tolerance, FINER * FINEST), share=FEWER, less=HIT)
    with part(0.25, 0.7):
        right = follow(scene, fine)
    try:
        with part(0.7, 1.0):
            other = follow(perturbed(scene), max(tolerance, FINER * FINEST), share=FEWER, less=CHANGED)
    except (BadSetting, GuardFailed):
        other = None
    return rough, right, other


@np.errstate(all="ignore")  # what leaves the range of a computer is found in the values
def measured(
    scene: Scene, observe: Collection[Observable], tolerance: float, why: str, times: Sequence[float] = ()
) -> Run:
    """Follow the scene and look up what is asked; `times` (s) are a trajectory's.

    The same paths serve whatever is asked. Errors are estimates: the difference of two runs, what rounding becomes under the
    condition found by a third, and what is known of moments that are met slowly. Raises BadSetting for what a scene does not have,
    GuardFailed as `follow` does.
    """
    tolerance, rough, right, other = _paths(scene, tolerance)
    grazes = min(rough.grazes, right.grazes)
    hot = hottest(scene, right)
    sizes = _natural(scene, right, hot)
    found: dict[str, Measurement] = {}
    warnings: list[str] = []
    if right.rests:
        times_over = "once" if len(right.rests) == 1 else f"{len(right.rests)} times"
        warnings.append(
            f"bounces without end (Zeno), {times_over}: the last of them are over at {right.rests[-1]:.6g} s"
        )
    # Where motion fades, each step forgets the errors of those before, and two runs say nothing of each other's: what is off in the end is
    # as much as a step is allowed to be, in the mean square of all components, absolutely and relatively.
    # A slight touch is over within a few steps, and the step that ends where bodies part hides a root from its estimate: both may be off
    # by more than they are allowed to be, in both runs alike.
    fine = max(tolerance / FINER, FINEST)
    touches = sum(h.what.startswith("touch") for h in right.happenings)
    step_off = fine * max(
        2.0 * math.sqrt(len(right.state)) if right.fades else 0.2, BY_TOUCH * math.sqrt(touches)
    )
    # What the places and velocities are off that an energy is made of, as a part of theirs: by steps, and by rounding.
    rounded = 2.3e-16 * (4.0 + math.sqrt(len(right.stretches))) + 1e-14 * len(right.happenings)
    lost = energy_lost(scene, right, hot)
    for what in [o for o in Observable if o in observe]:  # a set's order is another in every process
        value = look(scene, right, what, times)
        if not all(map(math.isfinite, components(value))):  # no double holds it
            unknown: Observed = (math.inf,) * len(value) if isinstance(value, tuple) else math.inf
            found[what.value] = Measurement(value, unknown, "estimate", "integration", why, math.inf)
            continue
        if what is Observable.ENERGY and keeps_energy(scene):
            found[what.value] = conserved(scene, right, why)
            continue
        size = max([sizes.get(what, 0.0), *map(abs, components(value))])
        # What runs are apart is a part of what moved, and not of what forces could do.
        span = max(hot, *map(abs, components(value))) if what is Observable.ENERGY else size
        apart = apart_by(look(scene, rough, what, times), value)
        share = shares(scene, rough, right, what, times, sizes)
        condition = None
        if other is not None and size:
            try:
                condition = (
                    max(apart_by(look(scene, other, what, times), value), default=0.0) / size / CHANGED
                )
            except BadSetting:  # with the data changed a little there is none
                condition = math.inf
            if not math.isfinite(condition):  # or another number of them: more than this is not known
                condition = 1.0 / CHANGED
        rounding = 2.3e-16 * (4.0 + math.sqrt(len(right.stretches)) + 4.0 * (condition or 1.0)) * size
        # Each touch is met within some roundings of a place.
        rounding += 1e-14 * len(right.happenings) * max(condition or 1.0, 1.0) * size
        # And squeezes bodies as rounding of their places lets it.
        if contact_span(right):
            rounding += ROUNDED * math.ulp(right.long) / right.shallow * max(condition or 1.0, 1.0) * size
        # Places keep what velocities forget: that of several steps.
        several = 3.0 if right.fades and what is Observable.TRAJECTORY else 1.0
        least = several * step_off * span + rounding + _extra(scene, right, what)
        least += energy_off(scene, right, what, step_off, rounded, sizes)
        least += lost * size if what in BY_BODY else 0.0
        errors = tuple(
            SAFETY * each
            + least
            + (2.0 * size if grazes < math.inf else 0.0)  # a touch that errors decide leaves nothing certain
            + (share[i] if len(share) == len(apart) and what in BY_BODY else 0.3 * max(share) * span)
            for i, each in enumerate(apart)
        )
        if what in (Observable.VELOCITIES, Observable.TRAJECTORY):
            # No force moves what has no end of mass: but for rounding it is where it goes by itself.
            heavy = [math.isinf(body.mass) for body in scene.bodies for _ in range(scene.axes)]
            errors = tuple(min(e, 1e-12 * size) if heavy[i % len(heavy)] else e for i, e in enumerate(errors))
        error: Observed = errors if isinstance(value, tuple) else errors[0]
        size = size or _unmet(right, what)
        found[what.value] = Measurement(value, error, "estimate", "integration", why, size, condition)
    if grazes < math.inf:
        warnings.append(
            f"a touch grazes at about {grazes:.6g} s: whether it happens is within the error, and nothing is certain: move a body a little"
        )
    worst = max((m.condition or 0.0 for m in found.values()), default=0.0)
    if worst > ILL:
        warnings.append(
            f"a small change of the data comes out {worst:.0e} times larger or more (chaos, or an edge): "
            f"at most {max(16.0 - math.log10(worst), 0.0):.0f} digits can be had"
        )
    spent = sum(path.evaluations for path in (rough, right, other) if path)
    return Run(found, spent, outcome(scene, right), tuple(warnings))


def _natural(scene: Scene, path: Trajectory, hot: float) -> dict[Observable, float]:
    """Sizes of what can come out as zero: the largest there was on the way; `hot` is that of kinetic energy (J)."""
    states = [stretch.after for stretch in path.stretches] + [start_of(scene)]
    count = scene.axes * len(scene.bodies)
    fast = max(path.fast, *(abs(v) for y in states for v in y[count : 2 * count]))
    long = max(path.long, *(abs(x) for y in states for x in y[:count]))
    heavy = max((b.mass for b in scene.bodies if not math.isinf(b.mass)), default=0.0)
    light = min((b.mass for b in scene.bodies if not math.isinf(b.mass)), default=0.0)
    return {
        Observable.VELOCITIES: fast,
        Observable.TRAJECTORY: long,
        # What goes through the origin turns nowhere but there: rounding of its places remains.
        Observable.TURNING_POINTS: long,
        Observable.SPINS: max(
            [abs(b.spin) for b in scene.bodies]
            + [fast / b.radius for b in scene.bodies if b.radius > 0.0 and not math.isinf(b.mass)]
        )
        if scene.spins
        else 0.0,
        Observable.IMPULSE: heavy * fast,
        Observable.MOMENTUM: heavy * fast,
        # Near rest, what its forces could make of a body: they hold it, and rounding of its place remains.
        Observable.ENERGY: max(hot, 0.5 * light * path.fast**2),
        Observable.ENERGY_RATIO: hot / (kinetic(scene, 0.0, start_of(scene)) or 1.0),
    }


def _unmet(path: Trajectory, what: Observable) -> float:
    """What a contact would have been like that did not come about, to compare its error with; zero for everything else."""
    if what is Observable.LARGEST_OVERLAP:
        return path.deep
    return path.deep / path.fast if what is Observable.DURATION else 0.0


def _extra(scene: Scene, path: Trajectory, what: Observable) -> float:
    """What is known beside the difference of runs: touches met slowly, bounces still going on at the end."""
    if what is Observable.DURATION:
        span = contact_span(path)
        return span.slack if span else 400.0 * math.ulp(path.long) / path.fast  # even where they close slowly
    if what is Observable.LARGEST_OVERLAP:  # spheres that begin one rounding apart may touch
        return 4.0 * ROUNDED * math.ulp(path.long)
    if what is Observable.TURNING_POINTS and path.stretches and flat(scene, path):
        return near(scene, path)
    if what is Observable.PERIOD:
        return unequal(scene, path)
    if what is Observable.VELOCITIES:
        return path.dropped
    if what is Observable.SPINS:
        turns = (b.mass * b.radius / b.resists_spin for b in scene.bodies if math.isfinite(b.resists_spin))
        return path.dropped * max([1.0, *filter(math.isfinite, turns)])
    if what is Observable.TRAJECTORY:
        return BOUNCED * len(path.rests) * path.allowed
    if what in (Observable.IMPULSE, Observable.MOMENTUM):
        return path.dropped * max((b.mass for b in scene.bodies if not math.isinf(b.mass)), default=0.0)
    return 0.0
