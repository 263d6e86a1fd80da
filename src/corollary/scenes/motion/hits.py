"""Hits at one moment, settled together: Moreau's rule with Newton's restitution, body by body."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from corollary.scenes.constraint import State
from corollary.scenes.motion.complementarity import settled
from corollary.scenes.motion.multipliers import Item, Status, answer
from corollary.scenes.motion.reversal import accelerations, gained
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.motion.system import Array, Mode, System
from corollary.scenes.run import GuardFailed

MOST_HITS = 3_000
"""So many hits at one moment are followed: in turn they bring bodies to rest against each other, or let them go."""
SEEN = 1e-7
"""Velocities that are so large a part of the fastest apart are not the same."""


def settle_hits(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Change the velocities in a state where what is `near` is hit, faster than is `slow` (m/s); how many hits there are.

    What a hit drives against something that was opening is hit there next, and so on: two strings that jerk in turn, ever sooner, end
    by holding their three bodies together. Raises GuardFailed where no impulses of rigid bodies are consistent, or hits do not end.
    """
    hits = _hit(system, time, y, near, slow)
    # What is left of hits in turn stays: it is to be no more than rounding is.
    while hits and (more := _hit(system, time, y, near, 1e-2 * slow)):
        hits += more
        if hits > MOST_HITS:
            raise GuardFailed(
                f"at {time:.6g} s what holds bodies hits them in turn more than {MOST_HITS} times."
            )
    return hits


def hangs_on_order(system: System, time: float, y: State, near: Sequence[int], sizes: Sizes) -> bool:
    """Whether what is hit at this very moment would leave otherwise, were one of its hits the first, or did nothing else hold it then."""
    always = [i for i in near if system.constraints[i].two_sided]
    if len(near) - len(always) < 2:
        return False
    hit = [i for i in near if i not in always and system.rate(time, y, system.constraints[i]) < -sizes.speed]
    ends: list[Array] = []
    for first in [near, *([*always, i] for i in hit)]:
        end = list(y)
        try:
            _hit(system, time, end, first, sizes.speed)
            settle_hits(system, time, end, near, sizes.speed)
        except GuardFailed:
            continue
        ends.append(speeds(system, end))
    return any(math.dist(ends[0], end) > SEEN * sizes.fast for end in ends)


def speeds(system: System, y: State) -> Array:
    """All that moves in a state, in m/s: velocities by components, and how fast rims turn."""
    found, scene = system.velocity(y), system.scene
    radii = [body.radius for body in scene.bodies] if scene.spins else []
    return np.array(found) * ([1.0] * system.count + radii)


def _hit(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Settle what is hit at once; how much that is."""
    inverse, hits = system.inverse(time), 0
    rates = {i: system.rate(time, y, system.constraints[i]) for i in near}
    if not any(rates[i] < -slow and not system.constraints[i].two_sided for i in near):
        return 0
    pressed = [i for i in near if system.constraints[i].two_sided or rates[i] <= slow]
    for group, _ in system.clusters(time, y, pressed, []):
        hit = [i for i in group if rates[i] < -slow and not system.constraints[i].two_sided]
        if not hit:
            continue
        hits += len(hit)
        items: list[Item] = []
        for i in group:
            c, rate = system.constraints[i], rates[i]
            row = np.array([c.row(time, y)])
            bias = rate * (1.0 + c.gives_back(time)) if rate < 0.0 and not c.two_sided else rate
            may: tuple[Status, ...] = ("on",) if c.two_sided else ("on", "off")
            items.append(Item(c.name, row, np.array([bias]), may, two_sided=c.two_sided))
        for k, rub in enumerate(system.rubs):
            if system.pressed[k] in group:
                rows = np.array(rub.rows(time, y))
                slip = np.array(system.slip(time, y, k))
                ways: tuple[Status, ...] = ("stick", (1.0,), (-1.0,), "off")
                rubs = Item(rub.name, rows, slip, ways, rub=True, pressed=group.index(system.pressed[k]))
                rubs.kinetic = rubs.static = rub.kinetic
                items.append(rubs)
        statuses = settled(items, inverse, f"at {time:.6g} s")
        change = inverse * answer(items, statuses, inverse).total
        for j, v in enumerate(change.tolist(), start=system.count):
            y[j] += v
    return hits


def small_bounces(
    system: System, time: float, y: list[float], near: Sequence[int], mode: Mode, sizes: Sizes
) -> dict[int, tuple[float, float]]:
    """Of what is `near` the constraints that open so slowly under what presses them that their bounces are lower than is looked at: they rest.

    Bounce after bounce, each lower by the square of the restitution, ends after a finite time: that is not waited for. Each with how fast
    (m/s) it opens and how long (s) its bounces would have taken.
    """
    opening = {
        i: rate
        for i in near
        if not (c := system.constraints[i]).two_sided
        and mode.held[i] == "off"
        and (rate := system.rate(time, y, c)) > sizes.speed
        and c.restitution < 1.0
    }
    if not opening:
        return {}
    # Where bodies have got to places are not known as finely as where they began.
    low = max(sizes.bounce, 64.0 * last_digit(y[: system.count]))
    acceleration = accelerations(system, time, y, mode)
    slow: dict[int, tuple[float, float]] = {}
    for i, rate in opening.items():
        c = system.constraints[i]
        pulled = float(np.array(c.row(time, y)) @ acceleration) + c.drift(time, y)
        if pulled < 0.0 and rate * rate < -2.0 * pulled * low:
            slow[i] = rate, -2.0 * rate / pulled / (1.0 - c.restitution)
    return slow


def rub_less(
    system: System, time: float, y: list[float], mode: Mode, slow: Mapping[int, tuple[float, float]]
) -> float:
    """Give slips what friction does not take of them in `small_bounces` that are left out: these press by the speed of the first less than rest does.

    Returns how far off (m/s) velocities may be. They are right in the end where a slip outlasts the bounces, or what slipped in them sticks,
    of a body that nothing else holds; what it slips meanwhile is then spread over the time that is watched.
    """
    inverse, off = system.inverse(time), 0.0
    most = max((rub.kinetic for rub in system.rubs), default=0.0)
    held = max((rub.static for rub in system.rubs), default=0.0)
    for i, (rate, lasts) in slow.items():
        c, sure = system.constraints[i], _alone(system, mode, i)
        for k, way in enumerate(mode.rubbed):
            if system.pressed[k] != i or not isinstance(way, tuple):
                continue
            row, along = np.array(c.row(time, y)), np.array(way) @ np.array(system.rubs[k].rows(time, y))
            change = system.rubs[k].kinetic * rate / float(row * inverse @ row) * inverse * along
            for j, v in enumerate(change.tolist(), start=system.count):
                y[j] += v
            slip, faster = system.slip(time, y, k), gained(system, time, y, mode, k)
            sure = sure and float(np.array(way) @ (slip + lasts * faster)) > 0.0
        spread = lasts / (1.0 - c.restitution) / (system.scene.until or math.inf)
        off = max(off, 2.0 * rate * (held * spread if sure else most))
    return off


def _alone(system: System, mode: Mode, i: int) -> bool:
    """Whether what a constraint holds is held or rubbed by nothing else."""
    bodies = set(system.constraints[i].bodies)
    held = (
        c.bodies
        for j, (c, s) in enumerate(zip(system.constraints, mode.held, strict=True))
        if s == "on" and j != i
    )
    rubbed = (
        rub.bodies
        for k, (rub, s) in enumerate(zip(system.rubs, mode.rubbed, strict=True))
        if s != "off" and system.pressed[k] != i
    )
    return bodies.isdisjoint(body for each in (*held, *rubbed) for body in each)
