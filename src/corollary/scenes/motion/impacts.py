"""Hits at one moment, settled together by Moreau's rule with Newton's restitution, and bounces too low to be followed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from corollary.scenes.motion.contact_forces import SLIPS, Item, Status, answer, settled
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.motion.system import Mode, System
from corollary.scenes.run import GuardFailed

MOST_HITS = 100
"""So many hits at one moment are followed: a rough wall may throw a body against the one beside it."""


def settle_hits(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Change the velocities in a state where what is `near` is hit, faster than is `slow` (m/s); how many hits there are.

    Raises GuardFailed where no impulses of rigid bodies are consistent, or hits do not end.
    """
    hits = _hit(system, time, y, near, slow)
    while hits and (more := _hit(system, time, y, near, slow)):
        hits += more
        if hits > MOST_HITS:
            raise GuardFailed(
                f"at {time:.6g} s bodies hit what holds them more than {MOST_HITS} times at once."
            )
    return hits


def _hit(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Settle what is hit at once; how much that is."""
    inverse, hits = system.inverse(time), 0
    rates = {i: system.rate(time, y, system.constraints[i]) for i in near}
    closing = {i for i in near if rates[i] < -slow and not system.constraints[i].two_sided}
    if not closing:
        return 0
    pressed = [i for i in near if system.constraints[i].two_sided or rates[i] <= slow]
    for group, _ in system.clusters(time, y, pressed, []):
        if closing.isdisjoint(group):
            continue
        hits += len(closing.intersection(group))
        items: list[Item] = []
        for i in group:
            c, rate = system.constraints[i], rates[i]
            bias = rate * (1.0 + c.gives_back(time)) if rate < 0.0 and not c.two_sided else rate
            may: tuple[Status, ...] = ("on",) if c.two_sided else ("on", "off")
            items.append(Item(c.name, np.array(c.row(time, y)), bias, may, two_sided=c.two_sided))
        for k, rub in enumerate(system.rubs):
            if system.pressed[k] in group:
                row, slip, at = np.array(rub.row), system.slip(y, k), group.index(system.pressed[k])
                rubs = Item(rub.name, row, slip, ("stick", "forward", "back", "off"), rub=True, pressed=at)
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
    acceleration = system.accelerations(time, y, mode)
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

    Returns how far off (m/s) velocities may be. They are right in the end where a slip outlasts the bounces; what it slips meanwhile is then
    spread over the time that is watched.
    """
    inverse, off = system.inverse(time), 0.0
    for i, (rate, lasts) in slow.items():
        c = system.constraints[i]
        row = np.array(c.row(time, y))
        spread = lasts / (1.0 - c.restitution) / (system.scene.until or np.inf)
        rubs = [rub for k, rub in enumerate(system.rubs) if system.pressed[k] == i]
        off = max([off, *(2.0 * rate * rub.static * spread for rub in rubs)])
        for k, rub in enumerate(system.rubs):
            if system.pressed[k] != i or mode.rubbed[k] not in SLIPS:
                continue
            way, along = SLIPS[mode.rubbed[k]], np.array(rub.row)
            change = rub.kinetic * rate / float(row * inverse @ row) * inverse * way * along
            for j, v in enumerate(change.tolist(), start=system.count):
                y[j] += v
            faster = float(along @ system.accelerations(time, y, mode))
            if way * (system.slip(y, k) + lasts * faster) <= 0.0:
                off = max(off, 2.0 * rate * rub.kinetic)
    return off
