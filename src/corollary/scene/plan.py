"""The least model that answers: conservation, quadrature, exact pieces, or integration, and why.

Ready-made scenes call their model directly; a scene of an author's own comes through here.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from itertools import pairwise

from corollary.scene.collision import CLOSED, Collided, collide
from corollary.scene.force.contact import Contact
from corollary.scene.force.weight import Weight
from corollary.scene.line import Line, reduced_mass
from corollary.scene.measure import measured
from corollary.scene.observe import Observable
from corollary.scene.ready.scenery import Played
from corollary.scene.run import BadSetting, Model, Observed, Run
from corollary.scene.scene import Scene


@dataclass(frozen=True, slots=True)
class Plan:
    """`why` is one line; `play` does what was planned."""

    model: Model
    why: str
    play: Callable[[], Played]


def plan(scene: Scene, observe: Collection[Observable], tolerance: float = 1e-10) -> Plan:
    """Choose the least model that gives everything asked for. Raises BadSetting when no model does."""
    if not observe:
        names = ", ".join(o.value for o in Observable)
        raise BadSetting(f"{scene.name}: nothing is to be observed; name at least one of {names}.")
    line = as_line(scene)
    if line is not None and set(observe) <= ON_A_LINE:
        if len(line.masses) == 2 and set(observe) <= BEFORE_AND_AFTER and line.weight == 0.0 and line.contacts[0].eta == 0.0:
            why = "only velocities before and after one undamped collision are asked: momentum and energy give them"
            return Plan("conservation", why, lambda: _conserved(line, observe))
        found = collide(line, tolerance)
        return Plan(found.model, found.why, lambda: _collided(line, found, observe))
    why = "no integral of the motion gives what is asked: Newton's second law, step by step"
    return Plan("integration", why, lambda: measured(scene, observe, tolerance, why))


def play(scene: Scene, observe: Collection[Observable], tolerance: float = 1e-10) -> Run:
    """Play a scene with the least model that answers. Raises BadSetting and GuardFailed as the models do."""
    begin = time.perf_counter()
    done = plan(scene, observe, tolerance).play()
    seconds = time.perf_counter() - begin
    return Run(scene.name, {}, done.observed, done.errors, done.model, done.why, done.evaluations, seconds, done.outcome)


BEFORE_AND_AFTER = {Observable.VELOCITIES, Observable.ENERGY_RATIO}
ON_A_LINE = BEFORE_AND_AFTER | {Observable.DURATION, Observable.LARGEST_OVERLAP, Observable.PEAK_FORCE}


def as_line(scene: Scene) -> Line | None:
    """The scene as bodies in a row that touch their neighbours, if it is one; weight needs a floor below."""
    if scene.axes != 1 or scene.until is not None or not scene.has_only(Contact, Weight) or len(scene.bodies) < 2:
        return None
    contacts = [force for force in scene.forces if isinstance(force, Contact)]
    weight = math.fsum(force.g for force in scene.forces if isinstance(force, Weight))
    row = sorted(scene.bodies, key=lambda body: body.place)
    walls = [i for i, body in enumerate(row) if math.isinf(body.mass)]
    if len(contacts) != 1 or row != list(scene.bodies) or len(walls) > 1 or (weight and walls != [0]):
        return None
    return Line(
        masses=tuple(body.mass for body in row),
        velocities=tuple(body.velocity[0] for body in row),
        gaps=tuple(b.place[0] - a.place[0] - a.radius - b.radius for a, b in pairwise(row)),
        contacts=tuple(contacts) * (len(row) - 1),
        weight=weight,
    )


def _kinetic(line: Line, velocities: tuple[float, ...]) -> float:
    return sum(0.5 * m * v * v for m, v in zip(line.masses, velocities, strict=True) if not math.isinf(m))


def _conserved(line: Line, observe: Collection[Observable]) -> Played:
    (a, b), (u, v) = line.masses, line.velocities
    mass, meet = reduced_mass(a, b), u > v
    after = (u - 2.0 * mass / a * (u - v), v + 2.0 * mass / b * (u - v)) if meet else (u, v)
    before = _kinetic(line, line.velocities)
    known: dict[Observable, Observed] = {
        Observable.VELOCITIES: after,
        Observable.ENERGY_RATIO: _kinetic(line, after) / before if before else 1.0,
    }
    observed = {o.value: known[o] for o in observe}
    why = "momentum and energy before and after"
    return Played(observed, dict.fromkeys(observed, CLOSED), "conservation", why, 0, "released" if meet else "missed")


def _collided(line: Line, found: Collided, observe: Collection[Observable]) -> Played:
    passage = found.passage
    before = _kinetic(line, line.velocities)
    known: dict[Observable, tuple[Observed, str]] = {
        Observable.VELOCITIES: (passage.velocities, "velocities"),
        Observable.DURATION: (passage.duration, "duration"),
        Observable.LARGEST_OVERLAP: (max(passage.overlaps), "overlaps"),
        Observable.PEAK_FORCE: (max(passage.forces), "forces"),
        Observable.ENERGY_RATIO: (_kinetic(line, passage.velocities) / before if before else math.inf, "velocities"),
    }
    observed = {o.value: known[o][0] for o in observe}
    errors = {o.value: found.errors.get(known[o][1], 0.0) for o in observe}
    return Played(observed, errors, found.model, found.why, found.spent, passage.outcome)
