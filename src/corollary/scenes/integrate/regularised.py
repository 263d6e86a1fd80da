"""Collisions on a line, each touch followed on its own variable, so that a method of high order keeps its order.

A contact force k overlap^(3/2) has no second derivative where it begins; in w, overlap = w^2, it is a polynomial. So w is the
variable while a contact is young or about to end, which also lets the last step end exactly where the bodies part.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.contact_events import due, first_crossing, grazes, nears_zero
from corollary.scenes.integrate.controller import factor
from corollary.scenes.integrate.extrema import Extrema
from corollary.scenes.integrate.row_problem import LONG, RowProblem, attempt, row_problem
from corollary.scenes.integrate.step import EVALUATIONS, IntegrationStep
from corollary.scenes.integrate.time_variable import (
    TIME,
    TimeVariable,
    landing_variable,
    stride_for,
    suited_variable,
    value_in,
)
from corollary.scenes.models.flight import after_flight, first_touch, inactive
from corollary.scenes.models.sticking import common_velocities, resting_overlaps, stays
from corollary.scenes.row import (
    RowOfBodies,
    RowResult,
    closing_speed,
    closing_speeds,
    energy,
    guard,
    in_si,
    in_units,
    natural_units,
    overlaps,
    velocities,
)
from corollary.scenes.run import GuardFailed, Outcome

# A middle ball 1e-6 as heavy as its neighbours takes 45 000 steps; 1e-7 as heavy would take 150 000, and a step of a long row
# costs as much as twenty of a short one: beyond, a run would take minutes.
MOST_STEPS, MOST_STEPS_OF_A_LONG_ROW = 50_000, 20_000
MOST_TRIALS = 80
FIRST_STRIDE, LEAST_STRIDE = 0.05, 1e-12


@dataclass(slots=True)
class Motion:
    """Where a collision has got to; it changes with every step. `lasted` is about how long the next step may last."""

    state: list[float]
    touching: list[bool]
    variable: TimeVariable = TIME
    landing: bool = False
    stride: float = 0.0
    lasted: float = FIRST_STRIDE
    began: float | None = None
    ended: float = 0.0
    openings: int = 0
    evaluations: int = 0


def collide(line: RowOfBodies, tolerance: float = 1e-13) -> RowResult:
    """Follow the line from its start to the last opening; `tolerance` is the error allowed to a single step, in natural units.

    Raises GuardFailed when momentum or energy is lost, or the end is not reached.
    """
    units = natural_units(line)
    if units is None:
        still = (0.0,) * len(line.gaps)
        return RowResult(line.velocities, 0.0, still, still, "missed", 0)
    return in_si(_follow(row_problem(in_units(line, units), tolerance)), units)


def _follow(problem: RowProblem) -> RowResult:
    line = problem.line
    motion = Motion([0.0, *(-gap for gap in line.gaps), *line.velocities], [gap <= 0.0 for gap in line.gaps])
    extrema = Extrema(line)
    most = MOST_STEPS if len(line.masses) < LONG else MOST_STEPS_OF_A_LONG_ROW
    for _ in range(most):
        _settle(line, motion)
        # Before the sleepers: a contact that its damping holds for ever soon has too little in it to be seen.
        if problem.damped and stays(line, motion.state, motion.touching, problem.tolerance):
            return _result(problem, motion, extrema, "sticks")
        if inactive(line, motion.state, motion.touching, problem.noise):
            _release_faint(line, motion, problem.noise)
            meeting = first_touch(line, motion.state, problem.noise, bounced=motion.began is not None)
            if meeting is None:
                return _result(problem, motion, extrema, "released" if motion.began is not None else "missed")
            motion.state = after_flight(line, motion.state, meeting)
            motion.touching = [j == meeting.contact for j in range(len(line.gaps))]
            motion.variable, motion.landing, motion.lasted = TIME, False, FIRST_STRIDE
        if motion.began is None:
            motion.began = motion.state[0]
        _advance(problem, motion, extrema)
    raise GuardFailed(
        f"The collision did not end within {most} steps. Make the masses less unequal or the balls fewer."
    )


def _settle(line: RowOfBodies, motion: Motion) -> None:
    """Where bodies just touch, the speed says whether the contact begins or has ended."""
    if 0.0 not in motion.state:
        return
    for j, overlap in enumerate(overlaps(line, motion.state)):
        if overlap == 0.0:
            motion.touching[j] = closing_speed(line, motion.state, j) >= 0.0


def _release_faint(line: RowOfBodies, motion: Motion, noise: float) -> None:
    """Contacts with too little left in them to matter end on their own, as if nothing pushed."""
    for j, on in enumerate(motion.touching):
        overlap, opening = motion.state[1 + j], -closing_speed(line, motion.state, j)
        if on and overlap > 0.0:
            motion.openings += 1
            motion.ended = max(
                motion.ended, motion.state[0] + (overlap / opening if opening > noise else 0.0)
            )
            motion.touching[j], motion.state[1 + j] = False, 0.0


def _result(problem: RowProblem, motion: Motion, extrema: Extrema, outcome: Outcome) -> RowResult:
    line, lost = problem.line, 1e3 * problem.tolerance + 1e-15 * motion.evaluations
    guard(
        line,
        energy(line, overlaps(line, motion.state), velocities(line, motion.state)),
        velocities(line, motion.state),
        lost,
    )
    speeds, duration, deepest = (
        tuple(velocities(line, motion.state)),
        motion.ended - (motion.began or 0.0),
        extrema.overlaps,
    )
    if outcome == "sticks":
        speeds, duration = common_velocities(line, motion.state, motion.touching), math.inf
        deepest = [max(pair) for pair in zip(deepest, resting_overlaps(line, motion.touching), strict=True)]
    return RowResult(
        velocities=speeds,
        duration=duration,
        overlaps=tuple(deepest),
        forces=tuple(extrema.forces),
        outcome=outcome,
        evaluations=motion.evaluations + extrema.evaluations,
        openings=motion.openings,
    )


def _advance(problem: RowProblem, motion: Motion, extrema: Extrema) -> None:
    """One accepted step, on the variable that suits it, ending at latest where a contact begins or ends."""
    state, touching = motion.state, motion.touching
    in_time = problem.law(touching, TIME)
    base = in_time(state[0], state[1:])
    if problem.damped:
        extrema.onset(state, touching)
    tried, landing = _accepted(problem, motion, base)
    extrema.look_within(state, tried, touching, base, in_time)
    growth = factor(tried.size)
    motion.variable, motion.landing, motion.stride = (
        tried.variable,
        landing and not tried.lands,
        tried.h * growth,
    )
    lasted = max((tried.after[0] - state[0]) * growth, LEAST_STRIDE)
    motion.lasted = max(lasted, motion.lasted) if tried.lands else lasted
    motion.state = tried.after
    motion.evaluations += 1
    _note_touches(motion, tried.variable.contact if tried.lands else None)


def _accepted(problem: RowProblem, motion: Motion, base: Sequence[float]) -> tuple[IntegrationStep, bool]:
    """The first tried that is exact enough and crosses no beginning or end of a contact; and whether it is on its way to one."""
    state, touching = motion.state, motion.touching
    landing = motion.landing and nears_zero(problem, state, base, motion.variable)
    variable = (
        motion.variable
        if landing
        else suited_variable(problem.powers, state, base, touching, motion.lasted, problem.noise)
    )
    if variable is TIME:
        next_touch = due(problem, state, base, motion.lasted, touching)
        if next_touch is not None:
            variable, landing = landing_variable(problem.powers, next_touch, touching), True
    stride = stride_for(state, base, variable, motion.lasted)
    if variable is motion.variable and motion.stride and abs(motion.stride) < abs(stride):
        stride = motion.stride
    if stride == 0.0:  # too short for this variable to tick
        variable, landing, stride = TIME, False, motion.lasted
    for count in range(MOST_TRIALS):
        tried = attempt(problem, variable, touching, state, base, stride)
        motion.evaluations += EVALUATIONS
        if not tried.size <= 1.0:
            stride = tried.h * factor(tried.size)
            if landing and count > 20:  # the speed turns before the bodies part: there is nowhere to land
                variable, landing = TIME, False
                stride = 0.1 * motion.lasted
            continue
        speeds = closing_speeds(problem.line, tried.after)
        own = tried.variable.contact
        if (
            own is not None and speeds[own] * base[own] < 0.0
        ):  # the overlap turned on the way and no longer grows with time: beyond, time would run back
            stride = 0.2 * tried.h
            continue
        crossing = first_crossing(problem, state, base, tried, speeds, touching)
        if count < 60 and crossing is None and grazes(problem, state, base, tried, speeds, touching):
            stride = 0.5 * tried.h
            continue
        if crossing is None or count > 60:
            return tried, landing
        if base[crossing] != 0.0 and (base[crossing] < 0.0) == touching[crossing]:
            variable, landing = landing_variable(problem.powers, crossing, touching), True
            stride = -value_in(variable, state)
        else:
            stride = 0.5 * tried.h
    raise GuardFailed("No step is small enough to follow the collision. Make the settings less extreme.")


def _note_touches(motion: Motion, landed: int | None) -> None:
    """Say which contacts have opened or closed in the step just taken."""
    state, touching = motion.state, motion.touching
    for j, on in enumerate(touching):
        overlap = state[1 + j]
        if on and (overlap < 0.0 or j == landed):
            touching[j] = False
            motion.openings += 1
            motion.ended = state[0]
        elif not on and (overlap > 0.0 or j == landed):
            touching[j] = True
    if landed is not None:
        motion.variable, motion.stride = TIME, 0.0
