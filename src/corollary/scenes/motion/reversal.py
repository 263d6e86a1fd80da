"""A slip that is too slow to be seen: whether it has just begun or comes to its end, and what is left of it, or of what it does to others."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import mul

import numpy as np

from corollary.scenes.constraint import State
from corollary.scenes.motion.multipliers import normal_force
from corollary.scenes.motion.system import Array, Mode, System

# What slows down by such a part of what friction could make it do, it does: by less, rounding does.
SLOWER = 1e-12
# Such a part of what is too slow to be seen is rounding.
ROUNDED = 0.01
# A slip has begun when it is twenty times as fast as it creeps; so far off its way until then it may be five times as much in the end.
BEGUN = 100.0
# So far (in radians) steps miss the direction of what creeps, whatever their tolerance: it turns faster than they see.
SWAYS = 1e-3


def unseen(system: System, time: float, y: State, k: int, speed: float) -> bool:
    """Whether a slip of one component is not faster than a speed (m/s)."""
    return abs(system.slip(time, y, k)[0]) <= speed


def slid(system: System, time: float, y: State, before: Mode | None, speed: float) -> set[int]:
    """The rubs of one component that slip in a mode, but for those that have just begun to: no faster than `speed` (m/s), and not slower and slower.

    What is tied to one that stops does so with it, though rounding leaves it a speed.
    """
    if before is None:
        return set()
    active = [k for k, status in enumerate(before.rubbed) if status != "off"]
    ways = {k: s[0] for k in active if isinstance(s := before.rubbed[k], tuple) and len(s) == 1}
    hardly = {k for k in ways if unseen(system, time, y, k, speed)}
    if not hardly:
        return set(ways)
    items, forces, _ = system.held(time, y, y, before)
    inverse, first = system.inverse(time), len(items) - len(active)
    found = set(ways) - hardly
    for at, k in enumerate(active, first):
        if k in hardly:
            item, slower = items[at], -ways[k] * float(forces.left[at][0])
            brake = item.kinetic * normal_force(items, forces, at) * item.yields(inverse)
            if slower > SLOWER * float(abs(item.bias[0]) + abs(brake)):
                found.add(k)
    return found


def just_begun(
    system: System, time: float, y: State, before: Mode | None, k: int, speed: float
) -> tuple[float, ...] | None:
    """The way in which a rub has just begun to slip in a mode, no faster than `speed` (m/s), though rounding may have it slip back: it goes on so."""
    begun = before.rubbed[k] if before is not None else "stick"
    if not isinstance(begun, tuple):
        return None
    slip = system.slip(time, y, k)
    along = sum(map(mul, slip, begun))
    return begun if math.hypot(*slip) <= speed and along > -ROUNDED * speed else None


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
        was, will = (float(gained(system, time, y, each, k) @ along) for each in (before, mode))
        if was > will > 0.0:
            yield k, (back * (1.0 - will / was) * along).tolist()


def turned(before: Mode | None, mode: Mode) -> float:
    """How far off (m/s) a slip of two components may be that became too slow to have a direction, and goes on in another; or that went on as
    it began until it was seen, and then another way."""
    if before is None:
        return 0.0
    off, none = 0.0, (0.0,) * len(mode.rubbed)
    creeps = zip(before.creeps or none, mode.creeps or none, before.rubbed, mode.rubbed, strict=True)
    for crept, creep, way, now in creeps:
        # What creeps already has begun at rest, where it is pushed.
        if creep and not crept and isinstance(way, tuple):
            off = max(off, 2.0 * creep)
        elif crept and not creep and isinstance(way, tuple) and isinstance(now, tuple):
            off = max(off, BEGUN * crept * math.dist(way, now))
    return off


def swayed(system: System, time: float, y: State, before: Mode, lasted: float) -> float:
    """How far off (m/s) slips of two components may be that crept in a mode for so long (s).

    The slower a slip, the more of its direction a step may miss, and of friction along the way by the square of that.
    """
    brakes = [
        rub.kinetic * rub.normal(time, y) * float((np.square(rub.rows(time, y)) @ system.inverse(time)).max())
        for creep, way, rub in zip(before.creeps, before.rubbed, system.rubs, strict=True)
        if creep and isinstance(way, tuple) and rub.normal is not None
    ]
    return 0.5 * SWAYS**2 * max(brakes, default=0.0) * lasted


def not_yet(
    system: System, time: float, y: State, before: Mode, stopped: State, mode: Mode, stops: Sequence[int]
) -> list[float]:
    """What bodies still gain (m/s, by components of the velocity) until rubs come to rest that are taken for it while they hardly slip in `y`.

    Bodies that are tied to them feel what slips until then; in `stopped` and its mode they no longer do. What sticks gains nothing.
    """
    lasts = 0.0
    for k in stops:
        slip = np.array(system.slip(time, y, k))
        speed = float(np.linalg.norm(slip))
        slows = -float(slip @ gained(system, time, y, before, k)) / speed if speed else 0.0
        lasts = max(lasts, speed / slows) if slows > 0.0 else lasts
    was, now = (accelerations(system, time, *each) for each in ((y, before), (stopped, mode)))
    axes = system.scene.axes
    gains = lasts * (was - now)
    for rub in (system.rubs[k] for k, status in enumerate(mode.rubbed) if status == "stick"):
        for body in rub.bodies:
            gains[axes * body : axes * body + axes] = 0.0
    return gains.tolist()


def accelerations(system: System, time: float, y: State, mode: Mode) -> Array:
    """Of each component of the velocity in a mode (m/s^2)."""
    _, found, gained = system.held(time, y, y, mode)
    return np.asarray(gained) + system.inverse(time) * found.total


def gained(system: System, time: float, y: State, mode: Mode, k: int) -> Array:
    """How fast a slip changes in a mode (m/s^2)."""
    acceleration = accelerations(system, time, y, mode)
    return np.array(system.rubs[k].rows(time, y)) @ acceleration + np.array(system.rubs[k].drift(time, y))
