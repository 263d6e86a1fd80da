"""A small ball on top of a large one, dropped together: the floor turns the lower one round, it throws the upper (12.5.2)."""

from __future__ import annotations

import math
from dataclasses import replace

from falls_and_swings import fallen, flight

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one
from corollary.scenes.film import NAIL, Film, film
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import Weight
from corollary.scenes.line_collision import collide
from corollary.scenes.row import RowOfBodies, RowResult
from corollary.scenes.run import (
    FINER,
    BadSetting,
    GuardFailed,
    Observed,
    Run,
    components,
)
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("mA", "mass of the lower ball", "kg", 0.6, above=0.0),
    Setting("mB", "mass of the upper ball", "kg", 0.06, above=0.0),
    Setting("h0", "drop height", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("k", "contact constant of floor and balls", "N/m^q", 1e12, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.5, least=1.0, most=10.0),
    Setting("gap", "gap between the balls as they fall", "m", 0.001, least=0.0),
    Setting(
        "weighed",
        "1: their weight acts during the contacts, too; 0: it does not",
        "1",
        0.0,
        least=0.0,
        most=1.0,
        whole=True,
    ),
)
# A share of the speed: far below what weight does, and where it does nothing.
AS_FINE, NO_WEIGHT = 2e-8, 1e-10
MOST_FLIGHTS = 1000.0  # of the lower ball before the upper one comes: more take too long
SURELY = 1.001  # far more than runs are off, and overlaps add to ways
# In roundings of the gap: overlaps that are less of it leave the upper ball's arrival open.
LEAST_OVERLAP = 1e5

FALLS_BACK = (
    "super_ball: with its weight the lower ball falls back to the floor before all touches are over, on an edge. "
    "Change a mass a little, or make the gap smaller."
)


def play(settings: Settings, tolerance: float, *, in_steps: bool = False) -> Run:
    """Velocities (lower, upper; up positive) after the last opening, and the height to which the upper ball then rises.

    With a gap the lower ball leaves the floor before they meet, as the example supposes; without one all three touch at once and
    the answer is another. Weight during the contacts is left out, unless they are `weighed`; `heights` is counted from the balls'
    places when the lower one meets the floor. `in_steps` follows the fall, every contact and the rise.
    """
    ma, mb, h0, g, k, q, gap = numbers(settings, "mA", "mB", "h0", "g", "k", "q", "gap")
    speed = fallen(h0, 0.0, g) if in_steps else math.sqrt(2.0 * g * h0)
    line = RowOfBodies((math.inf, ma, mb), (0.0, -speed, -speed), (0.0, gap), (Contact(k, q), Contact(k, q)))
    found = collide(line, tolerance)
    if one(settings, "weighed"):
        return _weighed(line, found.result, g, gap, tolerance, in_steps=in_steps)[0]
    _, lower, upper = found.result.velocities
    observed: dict[str, Observed] = {
        "velocities": (lower, upper),
        "heights": tuple(_risen(v, h0, g, in_steps) for v in (lower, upper)),
        "duration": found.result.duration,
        "peak_force": max(found.result.forces),
    }
    # Weight takes g times the time of contact from every speed.
    neglected = g * found.result.duration / speed
    errors = dict.fromkeys(observed, found.errors["velocities"] + neglected)
    errors["duration"] = found.errors["duration"] + neglected
    errors["peak_force"] = found.errors["forces"] + 2.0 * neglected
    run = found.observed(observed, {"velocities": speed, "heights": h0}, errors)
    # A slow ball makes more of weight, but not of next to none.
    return run if neglected < NO_WEIGHT else _beside_weight(run, line, found.result, g, gap)


def _risen(velocity: float, h0: float, g: float, in_steps: bool) -> float:
    """The height (m) reached with a velocity (m/s); none by a ball that goes down."""
    if velocity <= 0.0 or not in_steps:
        return max(velocity, 0.0) ** 2 / (2.0 * g)
    return h0 * flight(velocity / math.sqrt(g * h0))[0]


def _beside_weight(run: Run, line: RowOfBodies, free: RowResult, g: float, gap: float) -> Run:
    """With what leaving the weight out is found to do added to the errors, where a slow ball between two touches makes it more.

    Raises GuardFailed where weight makes another story of it.
    """
    try:
        weighed, touches = _weighed(line, free, g, gap, AS_FINE)
    except BadSetting:  # so soft that nothing is left of the example
        return run
    if touches > free.openings:
        raise GuardFailed(
            f"super_ball: without weight bodies touch {free.openings} times, with it {touches} times. Set weighed=1, or change a mass a little."
        )
    measured = dict(run.measured)
    for name, with_weight in weighed.measured.items():
        without = measured[name]
        rows = (without.value, with_weight.value, without.error, with_weight.error)
        wider = tuple(e + abs(a - b) + f for a, b, e, f in zip(*map(components, rows), strict=True))
        measured[name] = replace(without, error=wider if isinstance(without.value, tuple) else wider[0])
    return replace(run, measured=measured, evaluations=run.evaluations + weighed.evaluations)


def _weighed(
    line: RowOfBodies, free: RowResult, g: float, gap: float, tolerance: float, *, in_steps: bool = False
) -> tuple[Run, int]:
    """The same with weight, followed until all touches are over, and how many there are; `free` is what comes of it without.

    Energy gives each height: it does not change as the balls fly on, nor when the floor turns the lower one round again.
    """
    lift, speed = max(free.overlaps), -line.velocities[1]
    if 2.0 * g * lift >= speed**2:
        raise BadSetting(
            "super_ball: the balls are so soft that they sink in as deep as they fell; raise k, or drop them from higher."
        )
    flights = 0.5 * math.sqrt(1.0 + 2.0 * g * gap / speed**2)
    if flights > MOST_FLIGHTS:
        raise GuardFailed(
            f"super_ball: the lower ball bounces some {flights:.0f} times before the upper one comes. Make the gap smaller."
        )
    _refuse_far(line.masses[2] / line.masses[1], 2.0 * g * gap / speed**2, lift / gap if gap else math.inf)
    heavy = replace(line, weight=g)
    try:
        found = collide(heavy, tolerance / FINER)
    except GuardFailed:  # where powers of overlaps are rough no steps keep the energy so well
        found = collide(heavy, tolerance)
    result = found.result
    left = result.velocities[1:]
    places = result.left[0], result.left[0] + result.left[1] - gap
    heights = tuple(y + _risen(abs(v), speed**2 / g, g, in_steps) for y, v in zip(places, left, strict=True))
    observed: dict[str, Observed] = {"velocities": left, "heights": heights, "duration": result.duration}
    fast = max(speed, *map(abs, left))
    highest = fast**2 / (2.0 * g)  # at their greatest speed thrown straight up
    error = found.errors["velocities"]
    away = (error + found.errors["duration"]) * fast * result.duration
    errors = {
        "velocities": error,
        "heights": 2.0 * error + away / highest,
        "duration": found.errors["duration"],
    }
    return found.observed(observed, {"velocities": fast, "heights": highest}, errors), result.openings


def _refuse_far(ratio: float, far: float, overlap: float) -> None:
    """Raises GuardFailed where nothing need be followed to know it: `ratio` is that of the upper mass to the lower, `far` the gap in h0.

    In units of the time and speed of the fall from h0: the lower ball, which rises no higher than it fell, is not met before sqrt(far) - 1.
    With all the energy there is it leaves the last touch with sqrt(1 + ratio (1 + far)) at most, and is back after twice that. BadSetting
    where the largest `overlap`, as a part of the gap, leaves it open when they meet: then weight is left out.
    """
    if math.sqrt(far) - 1.0 > SURELY * 2.0 * math.sqrt(1.0 + ratio * (1.0 + far)):
        if overlap < LEAST_OVERLAP * 2.0**-52:
            raise BadSetting(
                "super_ball: such hard balls so far apart leave open when they meet; make the gap smaller."
            )
        raise GuardFailed(FALLS_BACK)


def second_way(settings: Settings, tolerance: float) -> Run:
    return play(settings, tolerance, in_steps=True)


def filmed(settings: Settings) -> Film:
    a, b, h0, g, k, q = numbers(settings, "mA", "mB", "h0", "g", "k", "q")
    big, small, apart = 0.06 * h0, 0.03 * h0, 1e-3 * h0
    bodies = (
        Body(a, (big + h0,), (0.0,), big, "A"),
        Body(b, (2.0 * big + small + h0 + apart,), (0.0,), small, "B"),
        Body(math.inf, (0.0,), (0.0,), name=NAIL),
    )
    forces = Contact(k, q, chosen=((0, 2), (0, 1))), Weight(g)
    fall = math.sqrt(2.0 * h0 / g)
    rise = (3.0 * a - b) / (a + b)
    ground = ((-2.0 * h0, 0.0), (2.0 * h0, 0.0))
    until = fall * (1.0 + max(1.0, 0.8 * rise))
    return film(bodies, [(forces, until)], upright=True, lines=(ground,))


SCENE = SceneDefinition(
    "a small ball on a large one, dropped together", SETTINGS, play, second_way=second_way, film=filmed
)
