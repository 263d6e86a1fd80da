"""Whether it is a function of somebody's own that has no value where no step gets on."""

from __future__ import annotations

import math
from collections.abc import Iterator

from corollary.scenes.constraint import State
from corollary.scenes.refused import failing
from corollary.scenes.run import GuardFailed, NoForce
from corollary.scenes.scene import Scene

AHEAD = 1e-6
"""How far on it is asked, as a part of the time that has passed: from some roundings of it on, ever farther."""


def refuse_failing(scene: Scene, time: float, state: State) -> None:
    """Raises GuardFailed where one gives nan, or has no value, at a moment or just after it."""
    for when, y in _from_there(scene, time, state):
        for force in (force for force in scene.forces if force.may_be_brief):
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
                    f"{scene.name}: {type(force).__name__} gives nan at {when:.6g} s, which is no number; mend it, or watch for a shorter time."
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
