"""What has to be settled together: constraints and rubs that share movable bodies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from corollary.scenes.motion.system import Array, System


def clusters(
    system: System, time: float, y: Sequence[float], constraints: Sequence[int], rubs: Sequence[int]
) -> Iterator[tuple[list[int], list[int]]]:
    """Constraints and rubs, by number, in groups; each group has no movable body in common with another."""
    movable = system.inverse(time) > 0.0
    nodes = [(i, -1) for i in constraints] + [(-1, k) for k in rubs]
    moved: list[Array] = []
    for i, k in nodes:
        rows = [system.constraints[i].row(time, y)] if k < 0 else system.rubs[k].rows(time, y)
        moved.append((np.abs(np.array(rows)).sum(axis=0) > 0.0) & movable)
    # A velocity row across a wall reaches the body's other components, too: what it shares is the body.
    bodies = [frozenset(_body(system, j) for j in np.flatnonzero(each).tolist()) for each in moved]
    left = list(range(len(nodes)))
    while left:
        group = [left.pop(0)]
        reached = set(bodies[group[0]])
        while more := [j for j in left if reached & bodies[j]]:
            group += more
            left = [j for j in left if j not in more]
            reached.update(*(bodies[j] for j in more))
        yield (
            [nodes[j][0] for j in group if nodes[j][1] < 0],
            [nodes[j][1] for j in group if nodes[j][1] >= 0],
        )


def _body(system: System, component: int) -> int:
    """The body to which a component of the generalized velocity belongs."""
    return component // system.scene.axes if component < system.count else component - system.count
