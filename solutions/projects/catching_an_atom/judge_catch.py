"""Students' programs for an atom that meets another one in the well and sticks to it: how they are called and judged."""

from __future__ import annotations

import math
from collections.abc import Sequence

from judge_orbit import (
    FORWARD_EULER,
    Pull,
    State,
    Walk,
    forward_euler,
    half_a_swing,
    misfit,
    moved,
    named,
    place_standard,
    pull_of,
    start_of,
    stepped,
)

from corollary.programs import (
    STEPS,
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
)

_ = catalogue(__file__)


def catch_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """A comes from outside and meets B at r = b, once along a radius, twice obliquely; `t1` is a whole number of steps."""
    cases: list[Inputs] = []
    for aside in (0.0, 0.3, 0.6):
        m, k, b = round(draw(0.5, 4.0), 2), round(draw(40, 300)), round(draw(0.8, 1.6), 2)
        d = round(draw(0.35, 0.6) * b, 3)
        omega = math.sqrt(k / m)
        x, y, vx, vy = (round(each, 4) for each in (b + 1.6 * d, aside * b, -draw(0.5, 0.9) * omega * d, 0.0))
        case = {"m": m, "k": k, "b": b, "d": d, "x": x, "y": y, "vx": vx, "vy": vy}
        pull = pull_of(case)
        t1 = _arrival(pull, (x, y, vx, vy))
        dt = t1 / round(t1 / half_a_swing(pull) * STEPS)
        cases.append(case | {"t1": t1, "T": t1 + dt * round(5.0 / omega / dt), "dt": dt})
    return halved(cases)


def judge_catch(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """The place of both atoms at the time T, when A has met B at rest at the time t1."""
    return judged(CATCH, called)


def _standard(inputs: Inputs) -> Standard:
    pull, left = pull_of(inputs), inputs["T"] - inputs["t1"]
    x, y, u, w = moved(pull, start_of(inputs), inputs["t1"])
    truth = moved(pull, (x, y, u / 2, w / 2), left)
    return place_standard(pull, truth, lambda dt: ended(inputs, dt))


def ended(
    inputs: Inputs, dt: float, *, keeps: float = 0.5, stiffer: float = 1.0, walk: Walk = stepped
) -> State:
    """Where a method leads: at t1 the velocity keeps this share, and the pull on what moves on changes by this factor."""
    pull, t1, left = pull_of(inputs), inputs["t1"], inputs["T"] - inputs["t1"]
    x, y, u, w = walk(pull, start_of(inputs), t1, round(t1 / dt))
    return walk(
        Pull(stiffer * pull.stiffness, pull.b, pull.edge),
        (x, y, keeps * u, keeps * w),
        left,
        round(left / dt),
    )


def _wrong(called: Called) -> Fault:
    inputs, dt = called.inputs, called.inputs["dt"]
    usual = {
        _("the velocity is not changed by the collision. B was at rest: momentum is shared by both."): ended(
            inputs, dt, keeps=1.0
        ),
        _("you kept the kinetic energy. The atoms stick: momentum is kept, kinetic energy is not."): ended(
            inputs, dt, keeps=0.5**0.5
        ),
        _("the mass has doubled, but not the force. The molecule pulls on A and on B."): ended(
            inputs, dt, stiffer=0.5
        ),
        _("the force has doubled, but not the mass. The pair has the mass of two atoms."): ended(
            inputs, dt, stiffer=2.0
        ),
        _(FORWARD_EULER): ended(inputs, dt, walk=forward_euler),
    }
    return named(called, usual)


CATCH = Family(misfit, _standard, _wrong)


def _arrival(pull: Pull, start: State) -> float:
    """When an atom from outside first reaches r = b, by halving."""
    x, y, u, _ = start
    low = (x - math.sqrt(pull.edge**2 - y**2)) / -u
    high = low + 2 * math.pi / math.sqrt(pull.stiffness)
    grid = [low + (high - low) * i / 200 for i in range(201)]
    first = next(time for time in grid if math.hypot(*moved(pull, start, time)[:2]) < pull.b)
    low, high = first - (high - low) / 200, first
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if math.hypot(*moved(pull, start, middle)[:2]) < pull.b else (middle, high)
    return high
