"""A slip in a plane that stops and goes back at once: what is left of its speed when it is seen to stop."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from corollary.scenes.constraint import State
from corollary.scenes.motion.system import Array, Mode, System


def left_over(
    system: System, time: float, y: State, before: Mode, mode: Mode
) -> Iterator[tuple[int, list[float]]]:
    """Each rub that still slips a little against the way it will go in `mode`, and how much faster (m/s, by components) than it may.

    Friction pushes the other way from now on, so it would stop later than it does. What slows it down by a before and by b from now on is
    to leave it b/a of its speed: then it stops when it would have.
    """
    for k, (creep, way) in enumerate(zip(mode.creeps, mode.rubbed, strict=False)):
        if not creep or not isinstance(way, tuple):
            continue
        slip, along = np.array(system.slip(time, y, k)), np.array(way)
        back = float(slip @ along)
        if back >= 0.0:
            continue
        was, will = (float(_gained(system, time, y, each, k) @ along) for each in (before, mode))
        if was > will > 0.0:
            yield k, (back * (1.0 - will / was) * along).tolist()


def _gained(system: System, time: float, y: State, mode: Mode, k: int) -> Array:
    """How fast a slip changes in a mode (m/s^2)."""
    _, found, gained = system.held(time, y, y, mode)
    acceleration = np.asarray(gained) + system.inverse(time) * found.total
    return np.array(system.rubs[k].rows(time, y)) @ acceleration + np.array(system.rubs[k].drift(time, y))
