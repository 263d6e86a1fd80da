"""The least model that answers: conservation, quadrature, exact pieces, or integration, and why.

Ready-made scenes call their model directly; a scene of an author's own comes through here.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from corollary.scenes.asked import refuse_question, within_doubles, within_range
from corollary.scenes.closed_forms import in_a_plane, in_a_well, round_a_centre
from corollary.scenes.collision import ROUNDING
from corollary.scenes.conserved import conserved, parts_undamped
from corollary.scenes.motion.energy import never_meets
from corollary.scenes.on_a_line import on_a_line
from corollary.scenes.run import (
    DEARER,
    BadSetting,
    Model,
    Observable,
    Observed,
    Outcome,
    Run,
    by_relative_errors,
)
from corollary.scenes.scene import Scene, start_of

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
    refuse_question(scene, observe, tolerance, times)
    times = _times(scene, observe, times)
    wanted = [o for o in Observable if o in observe]  # a set's order is another in every process
    with within_range(scene):
        cheap = _cheap(scene, wanted, tolerance)
    left = [o for o in wanted if o.value not in {name for run in cheap for name in run.measured}]
    why = "no integral of the motion gives what is asked: Newton's second law, step by step"
    models: dict[str, Model] = {name: each.model for run in cheap for name, each in run.measured.items()}
    models |= {o.value: "integration" for o in left}

    def follow() -> Run:
        runs = cheap
        if left:
            from corollary.scenes.measure import measured  # here, since it brings scipy

            with within_range(scene):
                runs = [*cheap, measured(scene, left, tolerance, why, times)]
        return within_doubles(scene, _together(runs, [o.value for o in wanted]))

    if left:
        return Plan("integration", why, follow, models)
    found = _together(cheap, list(models))
    return Plan(found.model, found.why, follow, models)


def _cheap(scene: Scene, wanted: Sequence[Observable], tolerance: float) -> list[Run]:
    """What is conserved, and what closed forms and collisions on a line or of a pair give: all at once where they can, else one by one."""
    known = _conserved(scene, wanted)
    if scene.until is None and not parts_undamped(scene):
        known = {}
    if len(known) == len(wanted):
        return [_at_the_start(scene, known)]
    for special_case in (on_a_line, in_a_plane, in_a_well, round_a_centre):
        found = special_case(scene, wanted, tolerance)
        if found is not None:
            return [found]
    left = [o for o in wanted if o not in known]
    runs = [_at_the_start(scene, known)] if known else []
    for special_case in (on_a_line, in_a_plane, in_a_well, round_a_centre):
        singly = (
            [o for o in left if special_case(scene, [o], tolerance) is not None] if len(wanted) > 1 else []
        )
        found = special_case(scene, singly, tolerance) if singly else None
        if found is not None:
            runs.append(found)
            left = [o for o in left if o not in singly]
    return runs


def _conserved(scene: Scene, wanted: Sequence[Observable]) -> dict[Observable, Observed]:
    """What the start says; infinite where a computer cannot tell it."""
    known: dict[Observable, Observed] = {}
    for what in wanted:
        try:
            known |= conserved(scene, [what])
        except (OverflowError, ZeroDivisionError):
            known[what] = math.inf
    return known


def _together(runs: Sequence[Run], names: Sequence[str]) -> Run:
    """Runs of several models as one; how the scene ended says the dearest of them."""
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
    """Play a scene with the least model that answers. Raises BadSetting and GuardFailed as the models do."""
    begin = time.perf_counter()
    found = plan(scene, observe, tolerance, times).play()
    return replace(found, scene=scene.name, seconds=time.perf_counter() - begin)


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
        raise BadSetting(
            f"{scene.name}: times of a trajectory lie between 0 and {end:g} s; choose others, or a later until=…."
        )
    return tuple(map(float, times))


def _at_the_start(scene: Scene, known: dict[Observable, Observed]) -> Run:
    observed = {o.value: value for o, value in known.items()}
    outcome: Outcome = (
        "bound"
        if scene.until is not None
        else ("missed" if never_meets(scene, start_of(scene)) else "released")
    )
    why = "all that is asked is conserved: the start says it"
    return by_relative_errors(observed, dict.fromkeys(observed, ROUNDING), "conservation", why, 0, outcome)
