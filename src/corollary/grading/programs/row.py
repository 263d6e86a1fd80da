"""Students' programs for a row of balls: what they are called with, and how what they return is judged."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.bound import NAMED, Bound, measured
from corollary.grading.programs.called import STEPS, Called, Draw, Given, Inputs, halved, miscounted
from corollary.grading.programs.convergence import Family, Standard, judged
from corollary.grading.programs.row_bugs import USUAL, wrong_cradle
from corollary.scenes.catalogue import run
from corollary.scenes.integrate.fixed_step import EULER_CROMER, march


def contact_time(m: float, k: float, q: float, v: float) -> float:
    """How long two equal balls of mass m touch that push each other with k overlap^q and meet at the relative speed v."""
    mu = m / 2
    deepest = (mu * (q + 1) * v**2 / (2 * k)) ** (1 / (q + 1))
    return 2 * math.sqrt(math.pi) * math.gamma(1 + 1 / (q + 1)) / math.gamma(0.5 + 1 / (q + 1)) * deepest / v


def cradle_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """Two, three and four balls, two laws of contact, masses and speeds of the grader's own."""
    cases = []
    for balls, q in ((2, 1.0), (3, 1.0), (3, 1.5), (4, 1.5)):
        m, v0 = round(draw(0.05, 0.4), 3), round(draw(0.4, 2.5), 2)
        k = round(draw(4e3, 4e4) if q == 1 else draw(1e6, 1e7), 0)
        cases.append({"N": balls, "m": m, "k": k, "q": q, "v0": v0, "dt": contact_time(m, k, q, v0) / STEPS})
    return halved(cases)


def judge_cradle(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against the reference first; then by what is kept, and by what the usual wrong programs return for the same numbers."""
    return judged(CRADLE, called)


def _misfit(called: Called) -> str:
    balls = called.inputs["N"]
    return miscounted(called, balls, f"the {balls} velocities of {balls} balls")


def _standard(inputs: Inputs) -> Standard:
    balls, m, k, q, v0 = (inputs[name] for name in ("N", "m", "k", "q", "v0"))
    truth = run("cradle", {"N": balls, "m": m, "k": k, "q": q, "v0": v0}, tolerance=1e-9).observed[
        "velocities"
    ]
    assert isinstance(truth, tuple)
    return Standard(
        lambda found: (math.dist(found, truth) / v0,), bounds(balls, q), contact_time(m, k, q, v0)
    )


@lru_cache(maxsize=64)
def bounds(balls: int, q: float) -> tuple[Bound, ...]:
    """Measured once for each row: with v0 as the unit of speed, mass, stiffness and speed set only the unit of time."""
    played = run("cradle", {"N": balls, "m": 1.0, "k": 1.0, "q": q, "v0": 1.0}, tolerance=1e-9).observed
    truth, lasts, contact = played["velocities"], played["duration"], contact_time(1.0, 1.0, q, 1.0)
    assert isinstance(truth, tuple)
    assert isinstance(lasts, float)

    def errors(steps: float) -> tuple[float, ...]:
        dt = contact / steps
        path = march(
            EULER_CROMER,
            _pushed(q),
            [0.0] * balls,
            [1.0] + [0.0] * (balls - 1),
            dt,
            math.ceil(1.2 * lasts / dt),
        )
        return (math.dist(path.velocities[-1], truth),)

    return measured(2, errors)


def _pushed(q: float):
    """Accelerations in a row of balls of mass and stiffness 1; places are counted from where the balls just touch."""

    def acceleration(x: Sequence[float], v: Sequence[float]) -> list[float]:
        forces = [0.0, *(max(left - right, 0.0) ** q for left, right in pairwise(x)), 0.0]
        return [behind - ahead for behind, ahead in pairwise(forces)]

    return acceleration


def _wrong(called: Called) -> Fault:
    one, returned = called.inputs, called.returned
    balls, v0 = one["N"], one["v0"]
    case = f"For N = {balls} and q = {one['q']:g}"

    def near(others: Sequence[float] | None) -> bool:
        return others is not None and math.dist(returned, others) <= NAMED * v0

    for scheme, sentence in USUAL.items():
        if near(wrong_cradle(scheme, balls, one["m"], one["k"], one["q"], v0, one["dt"])):
            return Fault(f"{case}: {sentence}", known=True)
    if near([v0] + [0.0] * (balls - 1)):
        return Fault(
            f"{case} nothing has happened: the first ball still has v0 and the others are at rest. Step until no two balls touch any more."
        )
    if not math.isclose(sum(returned), v0, rel_tol=1e-6):
        return Fault(
            f"{case} the total momentum is not kept. What one ball does to its neighbour, the neighbour does to it, the other way.",
            known=True,
        )
    if sum(v * v for v in returned) > v0 * v0 * (1 + NAMED):
        return Fault(
            f"{case} the kinetic energy has grown. Check the sign of the force (it must push the balls apart), that the position is "
            f"stepped with the new velocity, and that the step is small enough.",
            known=True,
        )
    return Fault(
        f"{case} momentum is kept, but the velocities are not those of this contact. Check the force law, and that all contacts have ended."
    )


CRADLE = Family(_misfit, _standard, _wrong)


def judge_contact(given: Given, called: Sequence[Called]) -> Fault | None:
    """Whether the pair (k, q) a student found leaves the middle of three touching balls nearly at rest."""
    (one,) = called
    if sentence := miscounted(one, 2, "the pair (k, q)"):
        return Fault(sentence)
    k, q = one.returned
    if not (k > 0 and 1 <= q <= 10):
        return Fault("k must be positive, and q between 1 and 10.")
    velocities = run(
        "cradle", {"N": 3, "m": given["m"], "k": k, "q": q, "v0": given["v0"]}, tolerance=1e-6
    ).observed["velocities"]
    assert isinstance(velocities, tuple)
    left = abs(velocities[1]) / given["v0"]
    if left < 0.02:
        return None
    return Fault(
        f"With your k and q the middle ball keeps {left:.0%} of v0; the goal is less than 2 %. Which of the two matters?"
    )
