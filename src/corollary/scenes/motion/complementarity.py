"""Which contacts press and which surfaces stick: the first combination that obeys complementarity and Coulomb's law.

The same conditions decide accelerations (multipliers are forces) and hits (they are impulses): J. J. Moreau, in Nonsmooth Mechanics
and Applications (1988); D. E. Stewart, SIAM Rev. 42 (2000) 3.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from corollary.scenes.motion.multipliers import Answer, Array, Item, Status, answer, normal_force
from corollary.scenes.run import GuardFailed

# A multiplier or an acceleration so small against the others is zero.
NOISE = 1e-10
MOST_COMBINATIONS = 3000


def settled(items: Sequence[Item], inverse: Array, where: str) -> tuple[Status, ...]:
    """The first combination of statuses that is consistent: what presses and what sticks is tried first.

    Surfaces that face each other could squeeze a body, and hold it against any force, though nothing has pressed them together: such a
    combination is taken only where no other moves bodies otherwise. So is one in which something slips that does not move, but could
    hold. Raises GuardFailed when there is none, or when there are too many to try.
    """
    if math.prod(len(item.may) for item in items) > MOST_COMBINATIONS:
        names = ", ".join(item.name for item in items)
        raise GuardFailed(f"{where}: too many things rest on each other at once ({names}).")
    squeezed: tuple[tuple[Status, ...], Array] | None = None
    idle: tuple[Status, ...] | None = None
    for statuses in combinations(items):
        found = answer(items, statuses, inverse)
        if not consistent(items, statuses, found, inverse):
            continue
        if _idle(items, statuses, found):
            idle = idle or statuses
            continue
        if squeezed is None:
            if not may_squeeze(items, statuses, inverse):
                return statuses
            squeezed = statuses, moved(items, found, inverse)
        elif differ(squeezed[1], moved(items, found, inverse)) and not may_squeeze(items, statuses, inverse):
            return statuses
    if squeezed is not None:
        return squeezed[0]
    if idle is not None:
        return idle
    names = ", ".join(item.name for item in items)
    raise GuardFailed(
        f"{where}: no forces of rigid bodies obey Coulomb's law here ({names}); give the contact a stiffness instead."
    )


def _idle(items: Sequence[Item], statuses: Sequence[Status], found: Answer) -> bool:
    """Whether something is said to begin to slip that stays where it is, held by what else holds."""
    fast = max((float(np.abs(item.bias).max()) for item in items), default=0.0)
    return any(
        isinstance(status, tuple) and "stick" in item.may and float(np.abs(w).max()) <= NOISE * fast
        for item, status, w in zip(items, statuses, found.left, strict=True)
    )


def moved(items: Sequence[Item], found: Answer, inverse: Array) -> Array:
    """What an answer changes along all rows (m/s^2, or m/s): what is the same along them is the same motion, in units that do not hang on sizes."""
    change = inverse * found.total
    return np.concatenate([item.rows @ change for item in items])


def differ(one: Array, other: Array, share: float = 1e-6) -> bool:
    """Whether what two answers change is not the same but for a share of its size."""
    return float(np.abs(one - other).max()) > share * float(max(np.abs(one).max(), np.abs(other).max()))


def may_squeeze(items: Sequence[Item], statuses: Sequence[Status], inverse: Array) -> bool:
    """Whether what presses, with the friction that it allows, can be in balance with nothing else: as two walls that face each other can."""
    pressing = [i for i, status in enumerate(statuses) if status == "on"]
    rubbing = [i for i, item in enumerate(items) if item.pressed >= 0 and statuses[i] != "off"]
    if sum(not items[i].two_sided for i in pressing) < 2:
        return False
    rows = np.vstack([items[i].rows for i in (*pressing, *rubbing)])[:, inverse > 0.0]
    if np.linalg.matrix_rank(rows / (np.linalg.norm(rows, axis=1, keepdims=True) + 1e-300), 1e-9) == len(
        rows
    ):
        return False
    from scipy.optimize import linprog  # here, since few scenes come so far

    # Friction is bounded by what presses it, and where it slips, not only may begin to, it is given by that.
    columns = len(rows)
    first = {i: n for n, i in enumerate(pressing)}
    equal, above, at = [*rows.T], list[Array](), len(pressing)
    for i in rubbing:
        item, status = items[i], statuses[i]
        parts = range(at, at + len(item.rows))
        at += len(item.rows)
        for n, part in enumerate(parts):
            bound = np.zeros(columns)
            bound[part] = 1.0
            if isinstance(status, tuple) and "stick" not in item.may:
                bound[first[item.pressed]] = item.kinetic * status[n]
                equal.append(bound)
            else:
                for sign in (1.0, -1.0):
                    above.append(sign * bound)
                    above[-1][first[item.pressed]] = -item.static
    ends = [
        (None, None) if n >= len(pressing) or items[pressing[n]].two_sided else (0.0, 1.0)
        for n in range(columns)
    ]
    wanted = [-1.0 if end[0] == 0.0 else 0.0 for end in ends]
    found = linprog(
        wanted,
        A_ub=np.array(above) if above else None,
        b_ub=np.zeros(len(above)) if above else None,
        A_eq=np.array(equal),
        b_eq=np.zeros(len(equal)),
        bounds=ends,
    )
    return bool(found.status == 0 and -found.fun > 1e-6)


def combinations(items: Sequence[Item]) -> Iterator[tuple[Status, ...]]:
    """All that items may do together: what presses and what sticks first."""
    for statuses in product(*(item.may for item in items)):
        # What nothing presses does not rub.
        if all(
            (status == "off") == (statuses[item.pressed] == "off")
            for item, status in zip(items, statuses, strict=True)
            if item.rub and item.pressed >= 0
        ):
            yield statuses


def consistent(items: Sequence[Item], statuses: Sequence[Status], found: Answer, inverse: Array) -> bool:
    """Whether what was found for a combination obeys complementarity and Coulomb's law."""
    fast = max((float(np.abs(item.bias).max()) for item in items), default=0.0)
    strong = max((float(np.abs(z).max(initial=0.0)) for z in found.multipliers), default=0.0)
    strong = max(strong, *(item.given * item.static for item in items if item.rub), 0.0)
    # Along rows: how fast something turns is no speed.
    change = np.abs(inverse * found.total)
    fast = max(fast, *(float((np.abs(item.rows) @ change).max()) for item in items), 0.0)
    # What is left of a curve at a speed that was taken for none, or of frictions that cancel, is nothing to what friction can hold.
    holds = (item.given * item.static * item.yields(inverse) for item in items if item.rub)
    fast = max(fast, 1e-8 * max(holds, default=0.0))
    for i, (item, status) in enumerate(zip(items, statuses, strict=True)):
        z, w = found.multipliers[i], found.left[i]
        if item.rub:
            press = normal_force(items, found, i)
            if status == "stick":
                if (
                    np.abs(w).max() > 1e-6 * fast
                    or float(np.linalg.norm(z)) > item.static * press + NOISE * strong
                ):
                    return False
            elif isinstance(status, tuple) and "stick" in item.may and np.asarray(status) @ w < -NOISE * fast:
                return False
        elif item.two_sided:
            continue
        elif status == "on":
            if z[0] < -NOISE * strong or abs(w[0]) > 1e-6 * fast:
                return False
        elif len(item.may) > 1 and w[0] < -NOISE * fast:
            return False
    return True
