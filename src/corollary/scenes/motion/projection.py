"""Places and velocities put back on what holds them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from corollary.scenes.motion.contact_forces import Array
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.motion.system import Mode, System

# So many last digits of places and velocities are what rounding leaves of none.
ROUNDED = 16.0


def held_in(mode: Mode) -> tuple[list[int], list[int]]:
    """The constraints that hold in a mode, and the rubs that stick."""
    return (
        [i for i, s in enumerate(mode.held) if s == "on"],
        [i for i, s in enumerate(mode.rubbed) if s == "stick"],
    )


def project(
    system: System,
    time: float,
    y: list[float],
    constraints: Sequence[int],
    rubs: Sequence[int],
) -> None:
    """Take out of the places and velocities what rounding and steps left against what holds."""
    _put_on(system, time, y, constraints)
    inverse, rows = system.inverse(time), [system.constraints[i].row(time, y) for i in constraints]
    speeds = [system.rate(time, y, system.constraints[i]) for i in constraints]
    rows += [system.rubs[k].row for k in rubs]
    speeds += [system.slip(y, k) for k in rubs]
    if rows:
        matrix = np.array(rows)
        change = inverse * (matrix.T @ _solved(matrix, inverse, speeds))
        for j, v in enumerate(change.tolist(), start=system.count):
            y[j] -= v


def drifted(system: System, time: float, y: list[float], mode: Mode, sizes: Sizes, part: float) -> bool:
    """Whether steps have moved bodies off what holds them by more than such a part of the sizes of the scene, and than rounding does."""
    far = max(part * sizes.place, ROUNDED * last_digit(y[: system.count]))
    fast = max(part * sizes.fast, ROUNDED * last_digit(system.velocity(y)))
    return any(
        abs(c.gap(time, y)) > far or abs(system.rate(time, y, c)) > fast
        for c, status in zip(system.constraints, mode.held, strict=True)
        if status == "on"
    )


def push_out(
    system: System, time: float, y: list[float], near: Sequence[int], held: Sequence[int], rubs: Sequence[int]
) -> None:
    """Places that rounding left a little behind what stops them, of what is `near`, are put upon it; what is `held`, or sticks, stays so."""
    known = system.constraints
    behind = [i for i in near if i not in held and not known[i].two_sided and known[i].gap(time, y) < 0.0]
    if behind:
        _put_on(system, time, y, [*held, *behind])
        project(system, time, y, held, rubs)


def _put_on(system: System, time: float, y: list[float], constraints: Sequence[int]) -> None:
    """Close the gaps of constraints, twice, for they may bend."""
    if not constraints:
        return
    weights = system.inverse(time).copy()
    weights[system.count :] = 0.0
    for _ in range(2):
        gaps = [system.constraints[i].gap(time, y) for i in constraints]
        matrix = np.array([system.constraints[i].row(time, y) for i in constraints])
        moved = weights * (matrix.T @ _solved(matrix, weights, gaps))
        for j, x in enumerate(moved.tolist()[: system.count]):
            y[j] -= x


def _solved(matrix: Array, inverse: Array, right: Sequence[float]) -> Array:
    """Multipliers; each equation in its own unit, for a light body's is not to drown that of a heavy one."""
    across = (matrix * inverse) @ matrix.T
    units = np.sqrt(across.diagonal())
    units[units == 0.0] = 1.0
    scaled = np.linalg.lstsq(across / units / units[:, None], np.array(right) / units, rcond=1e-12)[0]
    return np.asarray(scaled / units, dtype=np.float64)
