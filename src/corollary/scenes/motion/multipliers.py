"""The forces (or impulses) of what holds and rubs, once it is said what does."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.motion.shares import Array, evenly

Status = Literal["off", "on", "stick"] | tuple[float, ...]
"""A constraint is off or on; a rub is off, sticks, or slips in a direction."""

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

    def yields(self, inverse: Array) -> float:
        """How much a force (or impulse) of one along a row changes what is along it (per kg)."""
        return float((np.square(self.rows) @ inverse).max())


@dataclass(slots=True)
class Answer:
    """For each item its multipliers and what is left along its rows; `total` is the generalized force (or impulse) of all."""

    multipliers: list[Array]
    left: list[Array]
    total: Array


def answer(items: Sequence[Item], statuses: Sequence[Status], inverse: Array, fair: bool = True) -> Answer:
    """The multipliers when each item has its status. `inverse` holds the inverse masses.

    What could be shared in several ways is shared so that all hold as long as they can; if it need not be `fair`, some way is taken: their
    `total` is the same.
    """
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
            solved = _shared(items, owners, rubs, matrix, wanted, fair) if found is None else found
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
    items: Sequence[Item],
    owners: Sequence[int],
    rubs: NDArray[np.bool_],
    matrix: Array,
    wanted: Array,
    fair: bool,
) -> Array:
    """The multipliers where several could hold the same: what is rigid does, and friction only what is left.

    Surfaces take of that in proportion to what each can hold. So whatever they can hold together they do, as far as they hold the same
    motion: blocks in a row on a string, a body on two tables, one on a table and at a wall. In a plane, where they hold in several
    directions, see `evenly`.
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
        held, pull = (_left(x, ways) for x in (rubbed * shares, wanted))
        solved[rubs] = shares * np.linalg.lstsq(held, pull, rcond=RANK)[0]
        solved[~rubs] = np.linalg.lstsq(rigid, wanted - rubbed @ solved[rubs], rcond=RANK)[0]
        pressed = {i: items[i].pressed for i in holders if items[i].pressed >= 0}
        if not pressed:
            break
        presses = {owner: float(z) for owner, z in zip(owners, solved, strict=True)}
        most |= {i: items[i].static * presses.get(by, 0.0) for i, by in pressed.items()}
    in_plane = any(len(items[i].rows) == 2 for i in holders) and len(set(holders)) > 1
    if not (fair and in_plane) or min(most.values()) <= 0.0 or any(items[i].pressed >= 0 for i in holders):
        return solved
    _, sizes, ways = np.linalg.svd(matrix)
    free = ways[sizes <= RANK * sizes.max()].T
    own = {i: [n for n, owner in enumerate(owners) if owner == i] for i in holders}
    return evenly(solved, free, [(own[i], most[i]) for i in own]) if free.size else solved


def _left(columns: Array, ways: Array) -> Array:
    """What is left of columns across all ways; rounding is nothing."""
    left = columns - ways @ (ways.T @ columns)
    left[np.abs(left) <= RANK * np.abs(columns).max(initial=0.0)] = 0.0
    return left


def normal_force(items: Sequence[Item], found: Answer, i: int) -> float:
    """What presses a rub."""
    item = items[i]
    return item.given if item.pressed < 0 else float(found.multipliers[item.pressed][0])


def most_held(items: Sequence[Item], found: Answer, i: int) -> float:
    """The most that a rub can hold before it slips."""
    return items[i].static * normal_force(items, found, i)
