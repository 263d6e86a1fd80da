"""A row of balls: what students' programs are called with, how they are judged, and the usual bugs."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import islice, pairwise
from typing import Literal

from corollary.programs import (
    EULER,
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
    contact_time,
    halved,
    in_convention,
    judged,
    march,
    measured,
    miscounted,
    run,
    states,
)

_ = catalogue(__file__)

Scheme = Literal["euler", "one-sided"]
MOST_STEPS = 20_000  # two hundred contacts: the balls have parted, or the program lets them fly

USUAL: dict[Scheme, str] = {
    "euler": N_(
        "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first, then the position with the new velocity."
    ),
    "one-sided": N_(
        "each ball feels only one of its neighbours. What a ball does to its neighbour, the neighbour does to it: half of the pair forces is missing."
    ),
}


def cradle_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """Two, three and four balls, two laws of contact, masses and speeds of the grader's own."""
    cases: list[Inputs] = []
    for balls, q in ((2, 1.0), (3, 1.0), (3, 1.5), (4, 1.5)):
        m, v0 = round(draw(0.05, 0.4), 3), round(draw(0.4, 2.5), 2)
        k = round(draw(4e3, 4e4) if q == 1 else draw(1e6, 1e7), 0)
        cases.append(
            {"N": balls, "m": m, "k": k, "q": q, "v0": v0, "dt": contact_time(m / 2, k, q, v0) / STEPS}
        )
    return halved(cases)


def judge_cradle(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against the reference first; then by what is kept, and by what the usual wrong programs return for the same numbers."""
    return judged(CRADLE, called)


def _misfit(called: Called) -> str:
    balls = called.inputs["N"]
    return miscounted(called, balls, _("the {balls} velocities of {balls} balls", balls=balls))


def _standard(inputs: Inputs) -> Standard:
    balls, m, k, q, v0 = (inputs[name] for name in ("N", "m", "k", "q", "v0"))
    truth = run("cradle", {"N": balls, "m": m, "k": k, "q": q, "v0": v0}, tolerance=1e-9).observed[
        "velocities"
    ]
    assert isinstance(truth, tuple)
    return Standard(
        lambda found: (math.dist(found, truth) / v0,), bounds(balls, q), contact_time(m / 2, k, q, v0)
    )


@lru_cache(maxsize=64)
def bounds(balls: int, q: float) -> tuple[Bound, ...]:
    """Measured once for each row: with v0 as the unit of speed, mass, stiffness and speed set only the unit of time."""
    played = run("cradle", {"N": balls, "m": 1.0, "k": 1.0, "q": q, "v0": 1.0}, tolerance=1e-9).observed
    truth, lasts, contact = played["velocities"], played["duration"], contact_time(0.5, 1.0, q, 1.0)
    assert isinstance(truth, tuple)
    assert isinstance(lasts, float)

    def errors(steps: float) -> tuple[float, ...]:
        dt = contact / steps
        path = march(
            EULER_CROMER,
            pushed(q),
            [0.0] * balls,
            [1.0] + [0.0] * (balls - 1),
            dt,
            math.ceil(1.2 * lasts / dt),
        )
        return (math.dist(path.velocities[-1], truth),)

    return measured(2, errors)


def pushed(
    q: float, stiffness: float = 1.0, *, both: bool = True
) -> Callable[[Sequence[float], Sequence[float]], list[float]]:
    """Accelerations in a row of equal balls (`stiffness` is k/m); places are counted from where the balls just touch.

    Not `both`: each ball is pushed by the one behind it only.
    """

    def acceleration(x: Sequence[float], v: Sequence[float]) -> list[float]:
        forces = [0.0, *(stiffness * max(left - right, 0.0) ** q for left, right in pairwise(x)), 0.0]
        return [behind - (ahead if both else 0.0) for behind, ahead in pairwise(forces)]

    return acceleration


def _wrong(called: Called) -> Fault:
    one, returned = called.inputs, called.returned
    balls, v0 = one["N"], one["v0"]
    case = _("For N = {balls} and q = {power}", balls=balls, power=in_convention(f"{one['q']:g}"))

    def near(others: Sequence[float] | None) -> bool:
        return others is not None and math.dist(returned, others) <= NAMED * v0

    for scheme, sentence in USUAL.items():
        if near(wrong_cradle(scheme, balls, one["k"] / one["m"], one["q"], v0, one["dt"])):
            return Fault(f"{case}: {_(sentence)}", known=True)
    if near([v0] + [0.0] * (balls - 1)):
        return Fault(
            _(
                "{case} nothing has happened: the first ball still has v0 and the others are at rest. Step until no two balls touch any more.",
                case=case,
            )
        )
    if not math.isclose(sum(returned), v0, rel_tol=1e-6):
        return Fault(
            _(
                "{case} the total momentum is not kept. What one ball does to its neighbour, the neighbour does to it, the other way.",
                case=case,
            ),
            known=True,
        )
    if sum(v * v for v in returned) > v0 * v0 * (1 + NAMED):
        return Fault(
            _(
                "{case} the kinetic energy has grown. Check the sign of the force (it must push the balls apart), that the "
                "position is stepped with the new velocity, and that the step is small enough.",
                case=case,
            ),
            known=True,
        )
    return Fault(
        _(
            "{case} momentum is kept, but the velocities are not those of this contact. Check the force law, and that all contacts have ended.",
            case=case,
        )
    )


CRADLE = Family(_misfit, _standard, _wrong)


def judge_contact(given: Given, called: Sequence[Called]) -> Fault | None:
    """Whether the pair (k, q) a student found leaves the middle of three touching balls nearly at rest."""
    (one,) = called
    if sentence := miscounted(one, 2, _("the pair (k, q)")):
        return Fault(sentence)
    k, q = one.returned
    if not (k > 0 and 1 <= q <= 10):
        return Fault(_("k must be positive, and q between 1 and 10."))
    velocities = run(
        "cradle", {"N": 3, "m": given["m"], "k": k, "q": q, "v0": given["v0"]}, tolerance=1e-6
    ).observed["velocities"]
    assert isinstance(velocities, tuple)
    left = abs(velocities[1]) / given["v0"]
    if left < 0.02:
        return None
    return Fault(
        _(
            "With your k and q the middle ball keeps {left} of v0; the goal is less than 2 %. Which of the two matters?",
            left=f"{left:.0%}",
        )
    )


@lru_cache(maxsize=256)
def wrong_cradle(
    scheme: Scheme, balls: int, stiffness: float, q: float, v0: float, dt: float
) -> tuple[float, ...] | None:
    """The velocities that a wrong program ends with (`stiffness` is k/m), or None when it never ends."""
    method = EULER if scheme == "euler" else EULER_CROMER
    acceleration = pushed(q, stiffness, both=scheme != "one-sided")
    touched = False
    path = states(method, acceleration, [0.0] * balls, [v0] + [0.0] * (balls - 1), dt)
    try:
        for x, v in islice(path, MOST_STEPS):
            touching = any(left > right for left, right in pairwise(x))
            if touched and not touching:
                return tuple(v)
            touched = touched or touching
            if not max(map(abs, v)) <= 1e6 * v0:
                return None
    except OverflowError:  # a power beyond the doubles
        return None
    return None
