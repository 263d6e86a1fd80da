"""The least model that answers: conservation, quadrature, exact pieces, or integration, and why.

Ready-made scenes call their model directly; a scene of an author's own comes through here.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

from corollary.scenes.closed_forms import in_a_plane, in_a_well, round_a_centre
from corollary.scenes.collision import ROUNDING
from corollary.scenes.conserved import conserved, parts_undamped
from corollary.scenes.integrate.motion import never_touch
from corollary.scenes.measure import measured
from corollary.scenes.on_a_line import on_a_line
from corollary.scenes.run import BadSetting, Model, Observable, Observed, Outcome, Run
from corollary.scenes.scene import Scene

# Of a trajectory for which no times are asked.
POINTS = 101


@dataclass(frozen=True, slots=True)
class Plan:
    """`why` is one line; `play` does what was planned."""

    model: Model
    why: str
    play: Callable[[], Run]


def plan(
    scene: Scene, observe: Collection[Observable], tolerance: float = 1e-10, times: Sequence[float] = ()
) -> Plan:
    """Choose the least model that gives everything asked for; `times` (s) are those of a trajectory.

    Raises BadSetting when no model does.
    """
    if not observe:
        names = ", ".join(o.value for o in Observable)
        raise BadSetting(f"{scene.name}: nothing is to be observed; name at least one of {names}.")
    times = _times(scene, observe, times)
    known = conserved(scene, observe)
    left = [o for o in observe if o not in known]
    if not left and (scene.until is not None or parts_undamped(scene)):
        why = "all that is asked is conserved: the start says it"
        return Plan("conservation", why, lambda: _at_the_start(scene, known, why))
    for special_case in (on_a_line, in_a_plane, in_a_well, round_a_centre):
        found = special_case(scene, observe, tolerance)
        if found is not None:
            return Plan(found.model, found.why, lambda found=found: found)
    why = "no integral of the motion gives what is asked: Newton's second law, step by step"
    return Plan("integration", why, lambda: measured(scene, observe, tolerance, why, times))


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
    if not times:
        if math.isinf(end):
            raise BadSetting(
                f"{scene.name}: say at which times the trajectory is asked for, times=…, or until when to watch, until=…."
            )
        return tuple(end * i / (POINTS - 1) for i in range(POINTS))
    if not all(0.0 <= t <= end and math.isfinite(t) for t in times):
        raise BadSetting(
            f"{scene.name}: times of a trajectory lie between 0 and {end:g} s; choose others, or a later until=…."
        )
    return tuple(times)


def _at_the_start(scene: Scene, known: dict[Observable, Observed], why: str) -> Run:
    observed = {o.value: value for o, value in known.items()}
    outcome: Outcome = (
        "bound" if scene.until is not None else ("missed" if never_touch(scene) else "released")
    )
    return Run(observed, dict.fromkeys(observed, ROUNDING), "conservation", why, 0, outcome)
