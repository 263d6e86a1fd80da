"""Reaction and friction forces of what holds, and which contacts press or stick, by complementarity and Coulomb's law.

The same conditions decide accelerations (multipliers are forces) and hits (they are impulses): J. J. Moreau, in Nonsmooth Mechanics
and Applications (1988); D. E. Stewart, SIAM Rev. 42 (2000) 3.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.run import GuardFailed

Array = NDArray[np.float64]
Status = Literal["off", "on", "stick", "forward", "back"]
"""A constraint is off or on; a rub is off, sticks, or slips forward or back along its row."""
SLIPS: dict[Status, float] = {"forward": 1.0, "back": -1.0}

# The determinant of equations, each scaled to its size, and the singular value, of which only rounding is left.
DEPENDENT, RANK = 1e-11, 1e-12
# A multiplier or an acceleration so small against the others is zero.
NOISE = 1e-10
MOST_COMBINATIONS = 3000


@dataclass(slots=True)
class Item:
    """Something that may hold: `bias` is the acceleration (or velocity) along its row if nothing held.

    `pressed` is the item that presses a rub, by its place in the list, or `given` its normal force.
    """

    name: str
    row: Array
    bias: float
    may: tuple[Status, ...]
    rub: bool = False
    two_sided: bool = False
    pressed: int = -1
    given: float = 0.0
    kinetic: float = 0.0
    static: float = 0.0

    def yields(self, inverse: Array) -> float:
        """How much a force (or impulse) of one along the row changes what is along it (per kg)."""
        return float(np.square(self.row) @ inverse)


@dataclass(slots=True)
class Answer:
    """For each item its multiplier and what is left along its row; `total` is the generalized force (or impulse) of all."""

    multipliers: list[float]
    left: list[float]
    total: Array


def answer(items: Sequence[Item], statuses: Sequence[Status], inverse: Array) -> Answer:
    """The multipliers when each item has its status. `inverse` holds the inverse masses."""
    total, sliding = np.zeros(len(inverse)), dict[int, Array]()
    for item, status in zip(items, statuses, strict=True):
        if status in SLIPS:
            force = -item.kinetic * SLIPS[status] * item.row
            if item.pressed < 0:
                total = total + item.given * force
            else:
                sliding[item.pressed] = force
    multipliers = [0.0] * len(items)
    active = [i for i, status in enumerate(statuses) if status in ("on", "stick")]
    if active:
        rows = np.array([items[i].row for i in active])
        columns = np.array([items[i].row + sliding[i] if i in sliding else items[i].row for i in active])
        across = rows * inverse
        wanted = -(np.array([items[i].bias for i in active]) + across @ total)
        solved = _solved(across @ columns.T, wanted, np.array([items[i].rub for i in active]))
        total = total + columns.T @ solved
        for i, z in zip(active, solved.tolist(), strict=True):
            multipliers[i] = z
    change = inverse * total
    return Answer(multipliers, [item.bias + float(item.row @ change) for item in items], total)


def _solved(matrix: Array, wanted: Array, rubs: NDArray[np.bool_]) -> Array:
    """The multipliers; where several could hold the same, what is rigid does, and friction only what is left."""
    size = np.sqrt(np.abs(matrix.diagonal()))
    if size.all() and abs(float(np.linalg.det(matrix / size / size[:, None]))) > DEPENDENT:
        return np.asarray(np.linalg.solve(matrix, wanted), dtype=np.float64)
    found, holds = np.zeros(len(wanted)), np.ones(len(wanted), dtype=bool)
    if rubs.any() and np.linalg.matrix_rank(matrix[:, ~rubs], RANK) == np.linalg.matrix_rank(matrix, RANK):
        holds = ~rubs
    found[holds] = np.linalg.lstsq(matrix[:, holds], wanted, rcond=RANK)[0]
    return found


def most_held(items: Sequence[Item], found: Answer, i: int) -> float:
    """The most (N) that a rub can hold before it slips."""
    return items[i].static * _normal_force(items, found, i)


def _normal_force(items: Sequence[Item], found: Answer, i: int) -> float:
    item = items[i]
    return item.given if item.pressed < 0 else found.multipliers[item.pressed]


def settled(items: Sequence[Item], inverse: Array, where: str) -> tuple[Status, ...]:
    """The first combination of statuses that is consistent: what presses and what sticks is tried first.

    Raises GuardFailed when there is none, or when there are too many to try.
    """
    names = ", ".join(item.name for item in items)
    if math.prod(len(item.may) for item in items) > MOST_COMBINATIONS:
        raise GuardFailed(f"{where}: too many things rest on each other at once ({names}).")
    for statuses in _combinations(items):
        if _consistent(items, statuses, answer(items, statuses, inverse), inverse):
            return statuses
    raise GuardFailed(
        f"{where}: no forces of rigid bodies obey Coulomb's law here ({names}); give the contact a stiffness instead."
    )


def _combinations(items: Sequence[Item]) -> Iterator[tuple[Status, ...]]:
    """All that items may do together; what nothing presses does not rub."""
    for statuses in product(*(item.may for item in items)):
        if all(
            (status == "off") == (statuses[item.pressed] == "off")
            for item, status in zip(items, statuses, strict=True)
            if item.rub and item.pressed >= 0
        ):
            yield statuses


def _consistent(items: Sequence[Item], statuses: Sequence[Status], found: Answer, inverse: Array) -> bool:
    """Whether what was found for a combination obeys complementarity and Coulomb's law."""
    # Along rows: how fast something turns is no speed.
    change = np.abs(inverse * found.total)
    fast = max(max(abs(item.bias), float(np.abs(item.row) @ change)) for item in items)
    strong = max(
        max(abs(z), item.given * item.static) for item, z in zip(items, found.multipliers, strict=True)
    )
    # What is left of frictions that cancel is nothing to what friction can hold.
    fast = max(fast, 1e-8 * max(item.given * item.static * item.yields(inverse) for item in items))
    for i, (item, status) in enumerate(zip(items, statuses, strict=True)):
        z, w = found.multipliers[i], found.left[i]
        if status == "stick":
            if abs(w) > 1e-6 * fast or abs(z) > most_held(items, found, i) + NOISE * strong:
                return False
        elif status in SLIPS:
            if "stick" in item.may and SLIPS[status] * w < -NOISE * fast:
                return False
        elif item.rub or item.two_sided:
            continue
        elif status == "on":
            if z < -NOISE * strong or abs(w) > 1e-6 * fast:
                return False
        elif len(item.may) > 1 and w < -NOISE * fast:
            return False
    return True
