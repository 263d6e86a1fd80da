"""Hits at one moment, settled together: Moreau's rule with Newton's restitution, body by body."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from corollary.scenes.motion.complementarity import settled
from corollary.scenes.motion.multipliers import Item, Status, answer
from corollary.scenes.motion.system import System


def settle_hits(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Change the velocities in a state where what is `near` is hit, faster than is `slow` (m/s); how many hits there are.

    Raises GuardFailed where no impulses of rigid bodies are consistent.
    """
    inverse, hits = system.inverse(time), 0
    for group, _ in system.clusters(time, y, near, []):
        rates = {i: system.rate(time, y, system.constraints[i]) for i in group}
        hit = [i for i in group if rates[i] < -slow and not system.constraints[i].two_sided]
        if not hit:
            continue
        hits += len(hit)
        # What opens already is not pressed, but must not be driven in either.
        items: list[Item] = []
        for i in group:
            c, rate = system.constraints[i], rates[i]
            row = np.array([c.row(time, y)])
            bias = rate * (1.0 + c.restitution) if rate < 0.0 and not c.two_sided else rate
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
