"""The least model that answers: conservation, quadrature, exact pieces, or integration, and why."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import pairwise
from numbers import Real

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import Weight
from corollary.scenes.integrate.single_contact import collided
from corollary.scenes.line_collision import Collided, collide
from corollary.scenes.models.certain import found
from corollary.scenes.models.pair import Pair, refuse_too_soft
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.motion.conserved import (
    energy,
    energy_terms,
    keeps_energy,
    kinetic,
    momentum_at_start,
    never_meets,
    refuse_rest,
    rounding_of_energy,
)
from corollary.scenes.progress import with_bar
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import (
    DEARER,
    ROUNDING,
    STEPS,
    BadSetting,
    GuardFailed,
    Measurement,
    Model,
    Observable,
    Observed,
    Outcome,
    Run,
    by_relative_errors,
    components,
)
from corollary.scenes.scene import Conserves, Scene, overlap, pairs, start_of
from corollary.scenes.validation import OWN_FAILS, refuse_tolerance, short_text

OF_BODIES_ALONE = {Observable.IMPULSE, Observable.MOMENTUM, Observable.ENERGY}
BEFORE_AND_AFTER = {Observable.VELOCITIES, Observable.ENERGY_RATIO} | OF_BODIES_ALONE
ALONE_ON_A_LINE = BEFORE_AND_AFTER | {Observable.DURATION, Observable.LARGEST_OVERLAP, Observable.PEAK_FORCE}
ON_A_LINE = ALONE_ON_A_LINE - OF_BODIES_ALONE


def on_a_line(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """Bodies in a row that touch their neighbours, perhaps on a floor."""
    line = as_line(scene)
    if line is None or not set(observe) <= (ALONE_ON_A_LINE if line.weight == 0.0 else ON_A_LINE):
        return None
    contact = line.contacts[0]
    touching = len(line.masses) == 2 and line.gaps[0] >= 0.0 and line.weight == 0.0
    if touching and (contact.eta == 0.0 or contact.q == 1.0):
        (a, b), (u, v) = line.masses, line.velocities
        run = found(lambda: collision((a, b), (u, v), contact))
        depth = run.observed["largest_overlap"]
        _refuse_too_soft(scene, components(depth))
        if run.outcome == "sticks":
            endless = Measurement(math.inf, 0.0, "bound", run.model, run.why, math.inf)
            run = replace(run, measured=run.measured | {Observable.DURATION.value: endless})
        return run.only(o.value for o in observe)
    result = collide(line, tolerance)
    _refuse_too_soft(scene, result.result.overlaps)
    return _collided(line, result, observe)


def _refuse_too_soft(scene: Scene, overlaps: Sequence[float]) -> None:
    """Raises BadSetting when neighbours are so soft that they pass through each other; points without a radius keep their order."""
    for deep, (a, b) in zip(overlaps, pairwise(scene.bodies), strict=True):
        if a.radius + b.radius > 0.0:
            refuse_too_soft(deep, a.radius + b.radius)


def as_line(scene: Scene) -> RowOfBodies | None:
    """The scene as bodies in a row that touch their neighbours, if it is one; weight needs a floor below."""
    if (
        scene.axes != 1
        or scene.until is not None
        or not all(isinstance(force, (Contact, Weight)) for force in scene.forces)
        or len(scene.bodies) < 2
    ):
        return None
    contacts = [force for force in scene.forces if isinstance(force, Contact)]
    if any(contact.chosen is not None for contact in contacts) or scene.passes:
        return None
    weight = math.fsum(force.g for force in scene.forces if isinstance(force, Weight))
    row = sorted(scene.bodies, key=lambda body: body.place)
    walls = [i for i, body in enumerate(row) if math.isinf(body.mass)]
    if len(contacts) != 1 or row != list(scene.bodies) or len(walls) > 1 or (weight and walls != [0]):
        return None
    if (
        contacts[0].eta > 0.0 and len(row) > 2
    ):  # whether several damped contacts stay together the loop of composed scenes tells
        return None
    return RowOfBodies(
        masses=tuple(body.mass for body in row),
        velocities=tuple(body.velocity[0] for body in row),
        gaps=tuple(b.place[0] - a.place[0] - a.radius - b.radius for a, b in pairwise(row)),
        contacts=tuple(contacts) * (len(row) - 1),
        weight=weight,
    )


def _collided(line: RowOfBodies, found: Collided, observe: Collection[Observable]) -> Run:
    result = found.result
    loose = [
        (m, u, v)
        for m, u, v in zip(line.masses, line.velocities, result.velocities, strict=True)
        if not math.isinf(m)
    ]
    before, after = sum(0.5 * m * u * u for m, u, _ in loose), sum(0.5 * m * v * v for m, _, v in loose)
    known: dict[Observable, Observed] = {
        Observable.VELOCITIES: result.velocities,
        Observable.DURATION: result.duration,
        Observable.LARGEST_OVERLAP: max(result.overlaps),
        Observable.PEAK_FORCE: max(result.forces),
        Observable.ENERGY_RATIO: after / before if before else math.inf,
        Observable.IMPULSE: tuple(m * (v - u) for m, u, v in loose),
        Observable.MOMENTUM: (math.fsum(m * v for m, _, v in loose),),
        Observable.ENERGY: after,
    }
    # Rounding and steps are a share of what came in, not of what is left of it.
    fast = max(map(abs, line.velocities))
    thrown = max(m for m, _, _ in loose) * fast
    scales = {
        "velocities": fast,
        "impulse": thrown,
        "momentum": thrown,
        "energy": before,
        "energy_ratio": 1.0,
    }
    return found.observed({o.value: known[o] for o in observe}, scales)


def in_a_plane(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """Two spheres that nothing else acts on: quadrature without damping, else the contact followed in its own time."""
    if (
        scene.axes != 2
        or scene.until is not None
        or len(scene.bodies) != 2
        or not set(observe) <= ALONE_ON_A_LINE
    ):
        return None
    a, b = scene.bodies
    reach = a.radius + b.radius
    match scene.forces:
        case (Contact() as contact,) if (
            reach > 0.0
            and contact.chosen is None
            and not (a.spin or b.spin or scene.passes)
            and not math.isinf(a.mass)
            and not math.isinf(b.mass)
            and a.place != b.place
        ):
            pass
        case _:
            return None
    (ax, ay), (bx, by), (ua, va), (ub, vb) = a.place, b.place, a.velocity, b.velocity
    pair = Pair(a.mass, b.mass, (bx - ax, by - ay), ((ua, va), (ub, vb)), reach, contact)
    run = collided(pair, tolerance)
    of_each = replace(run, measured=run.measured | {"impulse": run.measured["impulses"]})
    return of_each.only(o.value for o in observe)


# Of a trajectory for which no times are asked.
POINTS = 101


@dataclass(frozen=True, slots=True)
class Plan:
    """`models` says for each observable which model gives it; `model` and `why` are those of the dearest. `play` does what was planned."""

    model: Model
    why: str
    play: Callable[[], Run]
    models: Mapping[str, Model]


def plan(
    scene: Scene, observe: Collection[Observable], tolerance: float = 1e-10, times: Sequence[float] = ()
) -> Plan:
    """Choose for everything asked for the least model that gives it; `times` (s) are those of a trajectory.

    One observable that needs more does not make the others dearer. Raises BadSetting for a question that is none, a tolerance that
    cannot be held, and when no model gives one of the observables; a value that no double holds is left out, and a warning says so.
    """
    _refuse_question(scene, observe, tolerance, times)
    times = _times(scene, observe, times)
    wanted = [o for o in Observable if o in observe]  # a set's order is another in every process
    with _within_range(scene):
        cheap = _cheap(scene, wanted, tolerance)
    left = [o for o in wanted if o.value not in {name for run in cheap for name in run.measured}]
    why = f"no integral of the motion gives what is asked: {STEPS}"
    models: dict[str, Model] = {name: each.model for run in cheap for name, each in run.measured.items()}
    models |= {o.value: "integration" for o in left}

    def follow() -> Run:
        runs = cheap
        if left:
            from corollary.scenes.measure import measured  # here, since it brings scipy

            with _within_range(scene):
                runs = [*cheap, measured(scene, left, tolerance, why, times)]
        return _within_doubles(scene, _together(runs, [o.value for o in wanted]))

    if left:
        return Plan("integration", why, follow, models)
    found = _together(cheap, list(models))
    return Plan(found.model, found.why, follow, models)


def _cheap(scene: Scene, wanted: Sequence[Observable], tolerance: float) -> list[Run]:
    """What is conserved, and what closed forms and collisions on a line or of a pair give: all at once where they can, else one by one."""
    known = _conserved(scene, wanted)
    if scene.until is None and not _parts_undamped(scene):
        known = {}
    if len(known) == len(wanted):
        return [_at_the_start(scene, known)]
    for special_case in (on_a_line, in_a_plane):
        found = special_case(scene, wanted, tolerance)
        if found is not None:
            return [found]
    left = [o for o in wanted if o not in known]
    runs = [_at_the_start(scene, known)] if known else []
    for special_case in (on_a_line, in_a_plane):
        singly = (
            [o for o in left if special_case(scene, [o], tolerance) is not None] if len(wanted) > 1 else []
        )
        found = special_case(scene, singly, tolerance) if singly else None
        if found is not None:
            runs.append(found)
            left = [o for o in left if o not in singly]
    return runs


def _conserved(scene: Scene, wanted: Sequence[Observable]) -> dict[Observable, Observed]:
    """What the start already says, so that no motion has to be followed for it; infinite where a computer cannot tell it."""
    known: dict[Observable, Observed] = {}
    for what in wanted:
        try:
            value = _known_at_the_start(scene, what)
        except (OverflowError, ZeroDivisionError):
            value = math.inf
        if value is not None:
            known[what] = value
    return known


def _known_at_the_start(scene: Scene, what: Observable) -> Observed | None:
    start = start_of(scene)
    match what:
        case Observable.MOMENTUM if Conserves.MOMENTUM in scene.conserves:
            walls = any(math.isinf(body.mass) for body in scene.bodies)
            return None if walls else momentum_at_start(scene)
        case Observable.ENERGY if keeps_energy(scene) and not any(f.may_be_brief for f in scene.forces):
            return energy(scene, 0.0, start)
        case Observable.ENERGY_RATIO if _parts_undamped(scene) and kinetic(scene, 0.0, start) > 0.0:
            return 1.0
        case _:
            return None


def _parts_undamped(scene: Scene) -> bool:
    """Whether the scene is undamped contacts that begin at a touch: all they take up they have given back when the bodies part."""
    if scene.until is not None or not scene.forces or not scene.walls_at_rest:
        return False
    if scene.contacts != scene.forces or Conserves.ENERGY not in scene.conserves:
        return False
    return all(overlap(scene, start_of(scene), a, b)[0] <= 0.0 for a, b in pairs(scene))


def _together(runs: Sequence[Run], names: Sequence[str]) -> Run:
    """Several runs as one; how the scene ended says the dearest of them, the first if there are several."""
    measured = {name: each for run in runs for name, each in run.measured.items()}
    warnings = tuple(dict.fromkeys(warning for run in runs for warning in run.warnings))
    dearest = max(runs, key=lambda run: DEARER.index(run.model))
    return Run(
        {name: measured[name] for name in names},
        sum(run.evaluations for run in runs),
        dearest.outcome,
        warnings,
    )


def play(
    scene: Scene, observe: Collection[Observable], tolerance: float = 1e-10, times: Sequence[float] = ()
) -> Run:
    """Play a scene with the least model that answers; a bar is shown to who waits at a terminal. Raises BadSetting and GuardFailed as the models do."""
    begin = time.perf_counter()
    with with_bar(f"scene {scene.name}"):
        found = plan(scene, observe, tolerance, times).play()
    return replace(found, scene=scene.name, seconds=time.perf_counter() - begin)


def followed(scene: Scene, observe: Collection[str], tolerance: float) -> Run:
    """A scene of an author's own by Newton's second law alone, until the time at which it ends; a trajectory is where bodies are then.

    Raises BadSetting for what cannot be observed, for a scene without an end of which that is asked, and as the integration does.
    """
    from corollary.scenes.measure import measured  # here, since it brings scipy

    known = {each.value: each for each in Observable}
    if strange := sorted(set(observe) - known.keys()):
        raise BadSetting(
            f"it does not observe {', '.join(strange)}; a composed scene observes {', '.join(known)}"
        )
    if scene.until is None and "trajectory" in observe:
        raise BadSetting("a trajectory is looked up where the scene ends: say until=…")
    times = (scene.until,) if scene.until is not None else ()
    with _within_range(scene):
        found = measured(scene, {known[name] for name in observe}, tolerance, STEPS, times)
    return _within_doubles(scene, found.only(name for name in known if name in observe))


def _times(scene: Scene, observe: Collection[Observable], times: Sequence[float]) -> tuple[float, ...]:
    """When a trajectory is looked up. Raises BadSetting when that cannot be."""
    if Observable.TRAJECTORY not in observe:
        return ()
    end = math.inf if scene.until is None else scene.until
    if not len(times):  # an array has no truth
        if math.isinf(end):
            raise BadSetting(
                f"{scene.name}: say at which times the trajectory is asked for, times=…, or until when to watch, until=…."
            )
        return tuple(end * i / (POINTS - 1) for i in range(POINTS))
    if not all(0.0 <= t <= end and math.isfinite(t) for t in times):
        lie = "are not negative" if math.isinf(end) else f"lie between 0 and {end:g} s"
        later = "" if math.isinf(end) else ", or a later until=…"
        raise BadSetting(f"{scene.name}: times of a trajectory {lie} and finite; choose others{later}.")
    return tuple(map(float, times))


def _at_the_start(scene: Scene, known: dict[Observable, Observed]) -> Run:
    observed = {o.value: value for o, value in known.items()}
    outcome: Outcome = (
        "bound"
        if scene.until is not None
        else ("missed" if never_meets(scene, start_of(scene)) else "released")
    )
    why = "all that is asked is conserved: the start says it"
    run = by_relative_errors(observed, dict.fromkeys(observed, ROUNDING), "conservation", why, 0, outcome)
    return replace(run, measured=run.measured | _energy_of_terms(scene, run))


def _energy_of_terms(scene: Scene, run: Run) -> dict[str, Measurement]:
    """The energy of the start with an error that is a part of its terms, which may cancel; nothing where it is not asked, or infinite."""
    found, start = run.measured.get(Observable.ENERGY.value), start_of(scene)
    if found is None or found.value == math.inf:
        return {}
    off, size = rounding_of_energy(scene, start), energy_terms(scene, 0.0, start)
    return {Observable.ENERGY.value: replace(found, error=off, size=size)}


def _refuse_question(
    scene: Scene, observe: Collection[Observable], tolerance: float, times: Sequence[float]
) -> None:
    """Raises BadSetting where what is asked of a scene is no question."""
    if not _are(observe, Observable):
        names = ", ".join(f"Observable.{o.name}" for o in Observable)
        raise BadSetting(f"{scene.name}: what is to be observed is a set of these: {names}.")
    if not observe:
        names = ", ".join(o.value for o in Observable)
        raise BadSetting(f"{scene.name}: nothing is to be observed; name at least one of {names}.")
    refuse_tolerance(scene.name, tolerance)
    if not _are(times, Real) or any(isinstance(t, bool) for t in times):
        raise BadSetting(
            f"{scene.name}: times = {short_text(times)} must be a tuple of times in s, (1.0,) with its comma for a single one."
        )
    if Observable.ENERGY_RATIO in observe:
        refuse_rest(scene)


def _are(given: object, kind: type) -> bool:
    return isinstance(given, Collection) and all(isinstance(each, kind) for each in given)  # pyright: ignore[reportUnknownVariableType]


@contextmanager
def _within_range(scene: Scene) -> Generator[None]:
    """Raises BadSetting where numbers leave the range of a computer, GuardFailed where a function of somebody's own fails on the way."""
    try:
        yield
    except (BadSetting, GuardFailed):
        raise
    except OWN_FAILS as error:
        if isinstance(error, (OverflowError, ZeroDivisionError, ValueError)):
            raise BadSetting(
                f"{scene.name}: with these numbers the range of a computer is left; choose milder ones."
            ) from error
        if not any(force.may_be_brief for force in scene.forces):  # a fault of this package's own
            raise
        raise GuardFailed(
            f"{scene.name}: a function of your own fails during the run ({type(error).__name__}: {error}); correct it."
        ) from error


def _within_doubles(scene: Scene, run: Run) -> Run:
    """In floats of Python's own, without the values that no double holds, and with a warning for each. Raises BadSetting when none is left.

    The duration of a contact that never ends may be all that was asked: then a warning is all there is.
    """
    run = replace(run, measured={name: _in_floats(each) for name, each in run.measured.items()})
    lost = [
        name for name, each in run.measured.items() if not all(map(math.isfinite, components(each.value)))
    ]
    lasts = [Observable.DURATION.value] if run.outcome == "sticks" else []
    if lost and len(lost) == len(run.measured) and lost != lasts:
        raise BadSetting(
            f"{scene.name}: {', '.join(lost)}: with these numbers the range of a computer is left; choose milder ones."
        )
    return run.without(lost)


def _in_floats(each: Measurement) -> Measurement:
    value, error = (
        tuple(map(float, given)) if isinstance(given, tuple) else float(given)
        for given in (each.value, each.error)
    )
    return replace(each, value=value, error=error, size=float(each.size))
