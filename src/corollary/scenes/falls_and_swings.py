"""Falls, flights and swings by Newton's second law, step by step until something happens: no energy, no time of flight is known."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from corollary.scenes.collision import SAFE
from corollary.scenes.definition import Settings, numbers
from corollary.scenes.run import STEPS, GuardFailed, Observed, Outcome, Run, by_relative_errors, two_runs

Slope = Callable[[float, Sequence[float]], Sequence[float]]

LEAST_RELATIVE = 2.3e-14
"""scipy's own least; what is small is known absolutely."""
EXACT = 1e-14
"""What rounding leaves, relative to the largest number of it, where the force is constant: steps of order eight are exact."""
LAST_STEPS = 10.0
"""So many times what a step may be off is what two runs have in common."""
LONG_STEPS = 1e-8
"""From here on steps are so long that two runs tell little of their error; they cost little less, too."""
MOST_FLIGHTS = 300
"""As many are followed to know when a ball rests."""
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


def _free(_: float, state: Sequence[float]) -> list[float]:
    """Place and velocity of a body of which the weight is all that acts."""
    return [state[1], -1.0]


def fallen(height: float, velocity: float, g: float) -> float:
    """The speed (m/s) with which a body arrives that starts `height` (m) above, with a velocity (m/s, up positive); off by EXACT."""
    if g == 0.0 or (height == 0.0 and velocity <= 0.0):
        return abs(velocity)
    # Units in which place, speed and weight are at most one.
    time = abs(velocity) / g + math.sqrt(height / g)
    speed, way = g * time, g * time * time

    _, state = until(_free, (height / way, velocity / speed), lambda y: y[0], 1e-13)
    return -state[1] * speed


def flight(velocity: float) -> tuple[float, float, float]:
    """Of a body thrown up from the floor with a velocity (> 0): its greatest height, the time until it is back, and its speed then.

    All in units in which the weight of a mass of one is one; off by EXACT of one.
    """

    up, (top, still) = until(_free, (0.0, velocity), lambda y: y[1], 1e-13)
    if top <= 0.0:
        return 0.0, up, 0.0
    down, (_, back) = until(_free, (top, still), lambda y: y[0], 1e-13)
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


def bouncing_ball(settings: Settings, tolerance: float) -> Run:
    """Flight after flight; when it rests is known where the flights that still count are few enough."""
    h0, r, n, g = numbers(settings, "h0", "r", "n", "g")
    count = round(n)
    # In units of the height and of the weight.
    down, (_, arrives) = until(_free, (1.0, 0.0), lambda y: y[0], 1e-13)
    tops, lasts = list[float](), list[float]()
    velocity, rebound = -arrives, 0.0
    # So many bounces until nothing is left that counts.
    all_of_them = math.log(EXACT * (1.0 - r)) / math.log(r) if 0.0 < r < 1.0 else 0.0
    few = r < 1.0 and all_of_them <= max(count, MOST_FLIGHTS)
    for _ in range(max(count, math.ceil(all_of_them) if few else 0)):
        velocity *= r
        top, flown, back = flight(velocity) if velocity > 0.0 else (0.0, 0.0, 0.0)
        rebound = velocity if len(tops) < count else rebound
        tops.append(top)
        lasts.append(flown)
        velocity = back
    time = math.sqrt(h0 / g)
    observed: dict[str, Observed] = {
        "heights": tuple(h0 * top for top in tops[:count]),
        "rebound_speed": g * time * rebound,
        "duration": time * (down + math.fsum(lasts[: count - 1])),
    }
    if few:
        observed["rests_after"] = time * (down + math.fsum(lasts))
    error = EXACT * (len(lasts) + 1.0)
    outcome: Outcome = "sticks" if r == 0.0 else "released"
    scales = {"heights": h0, "rebound_speed": g * time}
    return by_relative_errors(
        observed, dict.fromkeys(observed, error), "integration", STEPS, 0, outcome, scales
    )


def pendulum_block(settings: Settings, tolerance: float) -> Run:
    """Down along the arc, a hit during which the rope swings on, and up to where the sphere turns."""
    m, block, length, g, k = numbers(settings, "m", "M", "L", "g", "k")
    allowed = two_runs(tolerance, LONG_STEPS)
    stiff = k / m * length * math.sqrt(length) / g
    rough, right = (_hit(m / block, stiff, each) for each in allowed)
    off = SAFE * max(abs(a - b) for a, b in zip(rough, right, strict=True)) + LAST_STEPS * allowed[1] + EXACT
    before, sphere, pushed, top, span = right
    fast = math.sqrt(g * length)
    observed: dict[str, Observed] = {
        "speed_before": fast * before,
        "velocities": (fast * sphere, fast * pushed),
        "height": 2.0 * length * math.sin(0.5 * top) ** 2,
        "duration": span * _softness(m / block, stiff, before) / before * math.sqrt(length / g),
    }
    # The height goes with the square of the angle, and a duration that is short in the units of the swing is known as well.
    errors = dict.fromkeys(observed, off) | {"height": (abs(math.sin(top)) + off) * off}
    scales = {"speed_before": fast, "velocities": fast, "height": length}
    return by_relative_errors(observed, errors, "integration", STEPS, 0, "released", scales)


def _softness(share: float, stiff: float, speed: float) -> float:
    """About how far the contact gives, as a part of the rope: the unit in which the hit is followed."""
    return (speed * speed / (1.0 + share) / stiff) ** 0.4


def _hit(share: float, stiff: float, tolerance: float) -> tuple[float, float, float, float, float]:
    """Of a sphere let go level that meets a block 1/`share` as heavy: speed before, velocities after, angle of the turn, time of touch.

    In units of the rope, the sphere and its weight; the time in those of the contact. The push goes level, along the table.
    """
    _, before = swung(-0.5 * math.pi, 0.0, tolerance, turns=False)
    deep = _softness(share, stiff, before)
    slow, hard = deep / before**2, stiff * deep**2.5 / before**2

    def slope(_: float, state: Sequence[float]) -> list[float]:
        overlap, angle, along, pushed = state
        c, push = math.cos(deep * angle), hard * max(overlap, 0.0) ** 1.5
        return [along * c - pushed, along, -slow * math.sin(deep * angle) - push * c, share * push]

    span, (_, angle, along, pushed) = until(slope, (0.0, 0.0, 1.0, 0.0), lambda y: y[0], tolerance)
    top, _ = swung(deep * angle, before * along, tolerance)
    return before, before * along, before * pushed, top, span
