"""Forces of somebody's own: kicks shorter than a step, which its stages do not feel, and functions without a value, where no step gets on."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from corollary.scenes.body import State
from corollary.scenes.motion.path import POINTS, Array, Stretch, coefficients
from corollary.scenes.run import BadSetting, GuardFailed, NoForce
from corollary.scenes.scene import Force, Scene
from corollary.scenes.validation import failing

LOOKS = 4000
"""So often each such force is looked at between a scene's start and end: what acts for longer than two looks are apart is seen."""
UNSEEN = 100.0
"""What a step has not seen is to change no speed by more than so many times what the step may be off by."""
BENT = 1.0 / LOOKS
"""A stage inside a kick bends a step's polynomial to where the kick is not: its slopes then differ from its speeds by more than such a part."""
GLANCES = 400
"""So often they are looked at to know beforehand how strong they are."""
AHEAD = 1e-6
"""How far on it is asked for a value, as a part of the time that has passed: from some roundings of it on, ever farther."""


def _own(scene: Scene) -> list[Force]:
    """Those of functions, and of classes that somebody else wrote."""
    return [force for force in scene.forces if force.may_be_brief]


def pushed(scene: Scene, start: State) -> float:
    """What such forces would do to bodies that stay where they start: the mean (m/s^2, of absolute values) from begin to end."""
    forces = _own(scene)
    if not forces or scene.until is None:
        return 0.0
    times = [(i + 0.5) * scene.until / GLANCES for i in range(GLANCES)]
    felt = [each for t in times if (each := _strengths(scene, forces, t, start)) is not None]
    return max((math.fsum(each) / GLANCES for each in zip(*felt, strict=True)), default=0.0)


def _strengths(scene: Scene, forces: list[Force], time: float, start: State) -> list[float] | None:
    """What they would do then (m/s^2), none where that is not defined: bodies will have gone elsewhere."""
    felt = _accelerations(scene, forces, time, start, start)
    return [abs(a) for a in felt] if all(map(math.isfinite, felt)) else None


def _accelerations(scene: Scene, forces: list[Force], time: float, state: State, since: State) -> list[float]:
    """What the forces do (m/s^2, by components); not a number where one of them has no value."""
    try:
        return [a for force in forces for a in force.accelerations(scene, time, state, since)]
    except (OverflowError, ZeroDivisionError, NoForce):
        return [math.nan]
    except ValueError as error:
        if isinstance(error, BadSetting):
            raise
        return [math.nan]


def overlooked(scene: Scene, stretch: Stretch, fast: float, tolerance: float, may_be_bent: bool) -> bool:
    """Whether such a force does on a step what the step does not know of; speeds are about `fast` (m/s), `tolerance` is a step's.

    What it is at many moments is compared with the series through those at which events are looked for. Where it has no value a shorter
    step is to end before, or to find that there is no way on.
    """
    forces = [force for force in _own(scene) if not force.is_smooth]
    looks = math.ceil(LOOKS * stretch.lasts / (scene.until or math.inf)) if forces else 0
    if looks < 2:
        return False
    if may_be_bent and stretch.bent(scene.axes * len(scene.bodies)) > BENT * fast:
        return True
    parts = (np.arange(looks) + 0.5) / looks
    known, there = _felt(scene, forces, stretch, POINTS), _felt(scene, forces, stretch, parts)
    if known is None or there is None:
        return True
    between = np.polynomial.chebyshev.chebval(2.0 * parts - 1.0, coefficients(known.T).T).T
    unseen = float(np.abs(there - between).mean(axis=0).max(initial=0.0))
    rounding = 1e-14 * float(np.abs(there).max(initial=0.0))
    return unseen > UNSEEN * tolerance * fast / stretch.lasts + rounding


def _felt(scene: Scene, forces: list[Force], stretch: Stretch, parts: Array) -> Array | None:
    """What the forces do (m/s^2, by components) after several parts of a step, a row each; none where that is not finite.

    Nor are the states themselves where the stages between those of a step have met no value.
    """
    times, since, states = stretch.begin + parts * stretch.lasts, stretch.since, stretch.states(parts)
    if not np.isfinite(states).all():
        return None
    rows = [
        _accelerations(scene, forces, time, state, since)
        for time, state in zip(times.tolist(), states, strict=True)
    ]
    return np.array(rows) if all(math.isfinite(a) for row in rows for a in row) else None


def refuse_failing(scene: Scene, time: float, state: State) -> None:
    """Raises GuardFailed where such a force gives nan, or has no value, at a moment or just after it."""
    for when, y in _from_there(scene, time, state):
        for force in _own(scene):
            try:
                given = list(force.accelerations(scene, when, y, y))
            except NoForce as error:
                raise GuardFailed(str(error)) from error
            except (ArithmeticError, ValueError) as error:
                if isinstance(error, GuardFailed):
                    raise
                raise GuardFailed(failing(f"{scene.name}: {type(force).__name__}", when, error)) from error
            if any(map(math.isnan, given)):
                raise GuardFailed(
                    f"{scene.name}: {type(force).__name__} gives nan at {when:.6g} s, which is not a number; correct it, or end the run earlier (until=…)."
                )


def _from_there(scene: Scene, time: float, state: State) -> Iterator[tuple[float, State]]:
    """Moments (s) from one on, and the states there if bodies went on straight."""
    count = scene.axes * len(scene.bodies)
    ahead, end = 0.0, time if scene.until is None else scene.until
    while ahead <= AHEAD * max(time, 1e-3 * end):
        yield (
            time + ahead,
            [*(x + ahead * v for x, v in zip(state[:count], state[count:], strict=False)), *state[count:]],
        )
        ahead = 2.0 * ahead or 2.0 * math.ulp(time or end)
