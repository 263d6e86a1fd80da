"""Which contacts press and which surfaces stick: the first combination that obeys complementarity and Coulomb's law.

The same conditions decide accelerations (multipliers are forces) and hits (they are impulses): J. J. Moreau, in Nonsmooth Mechanics
and Applications (1988); D. E. Stewart, SIAM Rev. 42 (2000) 3.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.run import GuardFailed

Array = NDArray[np.float64]
Status = Literal["off", "on", "stick"] | tuple[float, ...]
"""A constraint is off or on; a rub is off, sticks, or slips in a direction."""

# A multiplier or an acceleration so small against the others is zero.
NOISE = 1e-10
MOST_COMBINATIONS = 3000
# The determinant of equations, each scaled to its size, and the singular value, of which only rounding is left.
DEPENDENT, RANK = 1e-11, 1e-12


@dataclass(slots=True)
class Item:
    """Something that may hold: `bias` is the acceleration (or velocity) along its rows if nothing held.

    `pressed` is the item that presses a rub, by its place in the list, or `given` its normal force.
    """

    name: str
    rows: Array
    bias: Array
    may: tuple[Status, ...]
    rub: bool = False
    two_sided: bool = False
    pressed: int = -1
    given: float = 0.0
    kinetic: float = 0.0
    static: float = 0.0


@dataclass(slots=True)
class Answer:
    """For each item its multipliers and what is left along its rows; `total` is the generalized force (or impulse) of all."""

    multipliers: list[Array]
    left: list[Array]
    total: Array


def answer(items: Sequence[Item], statuses: Sequence[Status], inverse: Array) -> Answer:
    """The multipliers when each item has its status. `inverse` holds the inverse masses."""
    size = len(inverse)
    extra = np.zeros(size)
    rows: list[Array] = []
    columns: list[Array] = []
    biases: list[float] = []
    owners: list[int] = []
    sliding: dict[int, Array] = {}
    for item, status in zip(items, statuses, strict=True):
        if isinstance(status, tuple):
            force = -item.kinetic * (np.asarray(status) @ item.rows)
            if item.pressed < 0:
                extra += item.given * force
            else:
                sliding[item.pressed] = sliding.get(item.pressed, 0.0) + force
    for i, (item, status) in enumerate(zip(items, statuses, strict=True)):
        if status in ("on", "stick"):
            for row, bias in zip(item.rows, item.bias, strict=True):
                rows.append(row)
                columns.append(row + sliding[i] if i in sliding else row)
                biases.append(float(bias))
                owners.append(i)
    total, solved = extra, np.zeros(0)
    if rows:
        across, along = np.array(rows) * inverse, np.array(columns)
        if len(rows) == 1 and (resists := float(across[0] @ along[0])) > 0.0:
            solved = np.array([-(biases[0] + float(across[0] @ extra)) / resists])
            total = extra + along[0] * solved[0]
        else:
            matrix, wanted = across @ along.T, -(np.array(biases) + across @ extra)
            rubs = np.array([items[owner].rub for owner in owners])
            found = _solved(matrix, wanted) if not rubs.any() or _independent(matrix) else None
            solved = _shared(items, owners, rubs, matrix, wanted) if found is None else found
            total = extra + along.T @ solved
    multipliers: list[Array] = [np.zeros(len(item.rows)) for item in items]
    filled = [0] * len(items)
    for owner, z in zip(owners, solved, strict=True):
        multipliers[owner][filled[owner]] = z
        filled[owner] += 1
    left = [item.bias + item.rows @ (inverse * total) for item in items]
    return Answer(multipliers, left, total)


def _independent(matrix: Array) -> bool:
    """Whether no two of what holds could hold the same."""
    size = np.sqrt(np.abs(matrix.diagonal()))
    return bool(size.all()) and abs(float(np.linalg.det(matrix / size / size[:, None]))) > DEPENDENT


def _solved(matrix: Array, wanted: Array) -> Array | None:
    """The one solution of the equations; none where there is not just one."""
    try:
        solved = np.linalg.solve(matrix, wanted)
    except np.linalg.LinAlgError:
        return None
    size = np.abs(wanted)
    right = np.abs(matrix @ solved - wanted) <= 1e-6 * size + 1e-9 * size.max()
    return np.asarray(solved, dtype=np.float64) if right.all() else None


def _shared(
    items: Sequence[Item], owners: Sequence[int], rubs: NDArray[np.bool_], matrix: Array, wanted: Array
) -> Array:
    """The multipliers where several could hold the same: what is rigid does, and friction only what is left.

    Surfaces take of that in proportion to what each can hold. So whatever they can hold together they do, as far as they hold the same
    motion: blocks in a row on a string, a body on two tables, one on a table and at a wall.
    """
    rigid, rubbed = matrix[:, ~rubs], matrix[:, rubs]
    ways, sizes, _ = np.linalg.svd(rigid, full_matrices=False)
    ways = ways[:, sizes > RANK * sizes.max(initial=0.0)]
    holders = [owner for owner, rub in zip(owners, rubs, strict=True) if rub]
    most = {i: items[i].static * (items[i].given if items[i].pressed < 0 else 1.0) for i in holders}
    solved = np.zeros(len(owners))
    for _ in range(2):
        strongest = max(most.values(), default=0.0) or 1.0
        shares = np.sqrt([max(most[i], 0.0) / strongest for i in holders])
        # What is left when the rigid have held all they can.
        held, pull = (x - ways @ (ways.T @ x) for x in (rubbed * shares, wanted))
        solved[rubs] = shares * np.linalg.lstsq(held, pull, rcond=RANK)[0]
        solved[~rubs] = np.linalg.lstsq(rigid, wanted - rubbed @ solved[rubs], rcond=RANK)[0]
        pressed = {i: items[i].pressed for i in holders if items[i].pressed >= 0}
        if not pressed:
            break
        presses = {owner: float(z) for owner, z in zip(owners, solved, strict=True)}
        most |= {i: items[i].static * presses.get(by, 0.0) for i, by in pressed.items()}
    return solved


def normal_force(items: Sequence[Item], found: Answer, i: int) -> float:
    """What presses a rub."""
    item = items[i]
    return item.given if item.pressed < 0 else float(found.multipliers[item.pressed][0])


def settled(items: Sequence[Item], inverse: Array, where: str) -> tuple[Status, ...]:
    """The first combination of statuses that is consistent: what presses and what sticks is tried first.

    Surfaces that face each other could squeeze a body, and hold it against any force, though nothing has pressed them together: such a
    combination is taken only where no other moves bodies otherwise. Raises GuardFailed when there is none, or when there are too many
    to try.
    """
    if math.prod(len(item.may) for item in items) > MOST_COMBINATIONS:
        names = ", ".join(item.name for item in items)
        raise GuardFailed(f"{where}: too many things rest on each other at once ({names}).")
    squeezed: tuple[tuple[Status, ...], Array] | None = None
    for statuses in _combinations(items):
        found = answer(items, statuses, inverse)
        if not _consistent(items, statuses, found, inverse):
            continue
        if squeezed is None:
            if not _may_squeeze(items, statuses, inverse):
                return statuses
            squeezed = statuses, inverse * found.total
        elif _differ(squeezed[1], inverse * found.total) and not _may_squeeze(items, statuses, inverse):
            return statuses
    if squeezed is not None:
        return squeezed[0]
    names = ", ".join(item.name for item in items)
    raise GuardFailed(
        f"{where}: no forces of rigid bodies obey Coulomb's law here ({names}); give the contact a stiffness instead."
    )


def _differ(one: Array, other: Array) -> bool:
    return float(np.abs(one - other).max()) > 1e-6 * float(max(np.abs(one).max(), np.abs(other).max()))


def _may_squeeze(items: Sequence[Item], statuses: Sequence[Status], inverse: Array) -> bool:
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


def redirected(items: Sequence[Item], inverse: Array) -> list[Item]:
    """The same, but slips of two components that may begin do so the way the bodies would go if nothing rubbed."""
    alone = answer(items, ["off" if item.rub else item.may[0] for item in items], inverse)
    found: list[Item] = []
    for item, way in zip(items, alone.left, strict=True):
        size = float(np.linalg.norm(way))
        if item.rub and len(way) == 2 and item.may[0] == "stick" and size:
            off: tuple[Status, ...] = ("off",) if "off" in item.may else ()
            item = replace(item, may=("stick", tuple((way / size).tolist()), *off))
        found.append(item)
    return found


def _combinations(items: Sequence[Item]) -> Iterator[tuple[Status, ...]]:
    for statuses in product(*(item.may for item in items)):
        # What nothing presses does not rub.
        if all(
            (status == "off") == (statuses[item.pressed] == "off")
            for item, status in zip(items, statuses, strict=True)
            if item.rub and item.pressed >= 0
        ):
            yield statuses


def _consistent(items: Sequence[Item], statuses: Sequence[Status], found: Answer, inverse: Array) -> bool:
    fast = max((float(np.abs(item.bias).max()) for item in items), default=0.0)
    strong = max((float(np.abs(z).max(initial=0.0)) for z in found.multipliers), default=0.0)
    strong = max(strong, *(item.given * item.static for item in items if item.rub), 0.0)
    fast = max(fast, float(np.abs(inverse * found.total).max(initial=0.0)))
    # What is left of a curve at a speed that was taken for none, or of frictions that cancel, is nothing to what friction can hold.
    holds = (
        item.given * item.static * float(np.abs(item.rows * inverse).max()) for item in items if item.rub
    )
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
