"""Falls, flights and swings by Newton's second law, step by step until something happens: no energy, no time of flight is known."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from corollary.scenes.run import GuardFailed

Slope = Callable[[float, Sequence[float]], Sequence[float]]

LEAST_RELATIVE = 2.3e-14
"""scipy's own least; what is small is known absolutely."""
EXACT = 1e-14
"""What rounding leaves, relative to the largest number of it, where the force is constant: steps of order eight are exact."""
LONGEST = 1e4
"""In natural units: what has not happened until then does not happen."""


def until(
    slope: Slope,
    start: Sequence[float],
    event: Callable[[Sequence[float]], float],
    tolerance: float,
    direction: float = -1.0,
) -> tuple[float, list[float]]:
    """Time and state (natural units) when `event` of the state passes zero, falling (-1), rising (1) or either way (0).

    `tolerance` is the error allowed to a single step. Raises GuardFailed when it does not come about.
    """
    from scipy.integrate import solve_ivp  # here, since most scenes never need it

    def met(_: float, state: Sequence[float]) -> float:
        return event(state)

    met.terminal, met.direction = True, direction  # pyright: ignore[reportFunctionMemberAccess]
    solved = solve_ivp(
        slope,
        (0.0, LONGEST),
        list(start),
        "DOP853",
        events=met,
        rtol=LEAST_RELATIVE,
        atol=max(tolerance, 1e-15),
        first_step=1e-3,
    )
    if solved.status != 1:
        raise GuardFailed("The motion was not followed to its end. Choose milder settings.")
    return float(solved.t[-1]), solved.y[:, -1].tolist()


def free_fall(_: float, state: Sequence[float]) -> list[float]:
    """Place and velocity of a body of which the weight is all that acts."""
    return [state[1], -1.0]


def fallen(height: float, velocity: float, g: float) -> float:
    """The speed (m/s) with which a body arrives that starts `height` (m) above, with a velocity (m/s, up positive); off by EXACT."""
    if g == 0.0 or (height == 0.0 and velocity <= 0.0):
        return abs(velocity)
    # Units in which place, speed and weight are at most one.
    time = abs(velocity) / g + math.sqrt(height / g)
    speed, way = g * time, g * time * time

    _, state = until(free_fall, (height / way, velocity / speed), lambda y: y[0], 1e-13)
    return -state[1] * speed


def flight(velocity: float) -> tuple[float, float, float]:
    """Of a body thrown up from the floor with a velocity (> 0): its greatest height, the time until it is back, and its speed then.

    All in units in which the weight of a mass of one is one; off by EXACT of one.
    """

    up, (top, still) = until(free_fall, (0.0, velocity), lambda y: y[1], 1e-13)
    if top <= 0.0:
        return 0.0, up, 0.0
    down, (_, back) = until(free_fall, (top, still), lambda y: y[0], 1e-13)
    return top, up + down, -back


def swung(angle: float, turning: float, tolerance: float, *, turns: bool = True) -> tuple[float, float]:
    """Angle (rad) and rate of a pendulum, in units of sqrt(g/L), where it turns round, or where it first hangs down.

    Along the arc weight pulls with sin(angle). Raises GuardFailed for one that does not get there.
    """
    if turns and turning == 0.0:
        return angle, 0.0
    size = max(abs(angle), abs(turning))

    def slope(_: float, state: Sequence[float]) -> list[float]:
        return [state[1], -math.sin(size * state[0]) / size]

    start = angle / size, turning / size
    _, state = until(slope, start, lambda y: y[1] if turns else y[0], tolerance, 0.0)
    return size * state[0], size * state[1]
