"""A ball on the floor: what students' programs are called with, how they are judged, and the usual bugs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from corollary.programs import (
    EULER_CROMER,
    N_,
    NAMED,
    STEPS,
    Bound,
    Called,
    Draw,
    Family,
    Fault,
    Given,
    Inputs,
    Remark,
    Standard,
    catalogue,
    halved,
    judged,
    march,
    measured,
    miscounted,
    run,
)

_ = catalogue(__file__)

Scheme = Literal["euler", "weightless", "linear", "floor"]

USUAL: dict[Scheme, str] = {
    "euler": N_(
        "This is forward Euler: the position is stepped with the old velocity, and energy grows. "
        "Step the velocity first, then the position with the new velocity."
    ),
    "weightless": N_("Gravity is missing: the net force is N - m g, also while the ball is above the floor."),
    "linear": N_(
        "The floor pushes here like a spring, in proportion to R - y. Its force goes with the power 3/2."
    ),
    "floor": N_(
        "Velocity and time are right, but the force is that of the floor; the net force is smaller by the weight."
    ),
}
ARGUMENTS = ("m", "k", "R", "y0", "v0", "g")
COUNTED = 2.5  # steps: a contact counted in steps may be one longer or shorter at each end


@dataclass(frozen=True, slots=True)
class Rebound:
    """Velocity with which the ball leaves the floor, the largest net force, and how long they touched."""

    velocity: float
    force: float
    duration: float

    def errors(self, other: Sequence[float]) -> tuple[float, ...]:
        """How far three numbers are from these, each relative to its own."""
        own = (self.velocity, self.force, self.duration)
        return tuple(abs(one / true - 1) for one, true in zip(other, own, strict=True))


def bounce_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """A hard quick contact, a long fall before it, and a soft contact in which the weight counts."""
    cases: list[Inputs] = []
    for stiffness, mass, speed, fall in (
        ((5e5, 2e6), (0.05, 0.2), (1.5, 4.0), (0.001, 0.01)),
        ((5e5, 2e6), (0.05, 0.2), (0.8, 1.5), (0.05, 0.15)),
        ((2e4, 5e4), (0.3, 0.6), (0.3, 0.6), (0.001, 0.003)),
    ):
        R = round(draw(0.015, 0.04), 3)
        numbers = {
            "m": round(draw(*mass), 3),
            "k": round(draw(*stiffness), -2),
            "R": R,
            "y0": round(R + draw(*fall), 4),
            "v0": round(-draw(*speed), 2),
            "g": 9.8,
        }
        cases.append(numbers | {"dt": reference(*(numbers[name] for name in ARGUMENTS)).duration / STEPS})
    return halved(cases)


@lru_cache(maxsize=256)
def reference(m: float, k: float, R: float, y0: float, v0: float, g: float) -> Rebound:
    """What a program must find, from the energy integral."""
    seen = run(
        "ball_on_floor", {"m": m, "k": k, "q": 1.5, "R": R, "y0": y0, "v0": v0, "g": g}, tolerance=1e-12
    ).observed
    speed, force, duration = seen["rebound_speed"], seen["peak_force"], seen["duration"]
    assert isinstance(speed, float)
    assert isinstance(force, float)
    assert isinstance(duration, float)
    return Rebound(speed, force - m * g, duration)


def judge_bounce(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against the reference first; then by what the usual wrong programs return for the same numbers."""
    return judged(BOUNCE, called)


def _misfit(called: Called) -> str:
    return miscounted(
        called, 3, _("three: the velocity v, the largest net force F, and the time of contact T")
    )


def _numbers(inputs: Inputs) -> tuple[float, ...]:
    return tuple(inputs[name] for name in ARGUMENTS)


def _standard(inputs: Inputs) -> Standard:
    truth = reference(*_numbers(inputs))
    return Standard(truth.errors, bounds(*_numbers(inputs)), truth.duration)


def bounds(*numbers: float) -> tuple[Bound, ...]:
    """First order: the weight acts all the way, and the force is looked at in steps."""
    truth = reference(*numbers)

    m, k, R, y0, v0, g = numbers
    until = (math.sqrt(v0**2 + 2 * g * (y0 - R)) + v0) / g + 1.2 * truth.duration

    def net(x: Sequence[float], v: Sequence[float]) -> list[float]:
        return [k * max(R - x[0], 0.0) ** 1.5 / m - g]

    def errors(steps: float) -> tuple[float, ...]:
        dt = truth.duration / steps
        path = march(EULER_CROMER, net, [y0], [v0], dt, math.ceil(until / dt))
        heights = [y for (y,) in path.places]
        below = [i for i, y in enumerate(heights) if y < R]
        force = m * max(net([heights[i]], ())[0] for i in below)
        return truth.errors((path.velocities[below[-1] + 1][0], force, truth.duration))[:2]

    return (*measured(1, errors), Bound(1, COUNTED))


def _wrong(called: Called) -> Fault:
    numbers, returned = _numbers(called.inputs), called.returned
    truth = reference(*numbers)
    nearest, sentence = min((_distance(called, scheme), sentence) for scheme, sentence in USUAL.items())
    if nearest <= 1:
        return Fault(_(sentence), known=True)
    v = returned[0]
    if math.isclose(v, numbers[4], rel_tol=1e-9):
        return Fault(
            _(
                "The velocity is still the one at the start: step until the ball has touched the floor and left it again."
            )
        )
    if v < 0 and abs(v + truth.velocity) <= NAMED * truth.velocity:
        return Fault(
            _("The velocity is negative, as on the way down: step until the ball has left the floor again."),
            known=True,
        )
    allowed = _standard(called.inputs).allowed(called)
    off = [error / most for error, most in zip(truth.errors(returned), allowed, strict=True)]
    return Fault(_(OFF[off.index(max(off))]))


OFF = (
    N_(
        "The ball leaves the floor with a wrong velocity. No energy is lost here: check force and order of steps."
    ),
    N_("The largest net force is wrong: it is the largest value of N - m g in the contact."),
    N_("The time of contact is wrong: count only the time in which the ball is below y = R."),
)


def _distance(called: Called, scheme: Scheme) -> float:
    """How far the call is from a usual wrong program, in parts of what names it; inf when that one never ends."""
    step = called.inputs["dt"]
    wrong = wrong_bounce(scheme, *_numbers(called.inputs), step)
    if wrong is None:
        return math.inf
    nearness = (NAMED, NAMED, COUNTED * step / wrong[2])
    return max(
        error / near for error, near in zip(Rebound(*wrong).errors(called.returned), nearness, strict=True)
    )


BOUNCE = Family(_misfit, _standard, _wrong)


@lru_cache(maxsize=256)
def wrong_bounce(
    scheme: Scheme, m: float, k: float, R: float, y0: float, v0: float, g: float, dt: float
) -> tuple[float, float, float] | None:
    """Velocity, largest force and time of contact of a wrong program, or None when it never ends.

    A loop of its own: a long fall takes 100 000 of these steps, and a general method is ten times as slow.
    """
    y, v, largest, below = y0, v0, 0.0, 0
    pull = 0.0 if scheme == "weightless" else m * g
    for _ in range(200_000):
        overlap = R - y
        if overlap > 0:
            below += 1
        elif below:
            return v, largest, below * dt
        push = k * overlap ** (1.0 if scheme == "linear" else 1.5) if overlap > 0 else 0.0
        largest = max(largest, push - (0.0 if scheme == "floor" else pull))
        a = (push - pull) / m
        y, v = y + (v if scheme == "euler" else v + a * dt) * dt, v + a * dt
    return None
