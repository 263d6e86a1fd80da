"""Collisions on a line, each touch followed on its own clock, so that a method of high order keeps its order.

A contact force k overlap^(3/2) has no second derivative where it begins; in w, overlap = w^2, it is a polynomial. So w is the
clock while a contact is young or about to end, which also lets the last step end exactly where the bodies part.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.contact_events import due, first_crossing, grazes, nears_zero
from corollary.scenes.integrate.controller import factor
from corollary.scenes.integrate.extrema import Crests
from corollary.scenes.integrate.row_motion import closing_speed, closing_speeds, overlaps, velocities
from corollary.scenes.integrate.step import EVALUATIONS, Step, attempt
from corollary.scenes.integrate.time_variable import (
    TIME,
    Clock,
    landing_clock,
    reading,
    stride_for,
    suited_clock,
)
from corollary.scenes.integrate.trajectory import LONG, Course, course
from corollary.scenes.models.flight import asleep, first_touch, flown
from corollary.scenes.models.sticking import common_velocities, resting_overlaps, stays
from corollary.scenes.row import Row, RowResult, energy, guard, in_si, in_units, natural_units
from corollary.scenes.run import GuardFailed, Outcome

# A middle ball 1e-6 as heavy as its neighbours takes 45 000 steps; 1e-7 as heavy would take 150 000, and a step of a long row
# costs as much as twenty of a short one: beyond, nobody waits for it.
MOST_STEPS, MOST_STEPS_OF_A_LONG_ROW = 50_000, 20_000
MOST_TRIALS = 80
FIRST_STRIDE, LEAST_STRIDE = 0.05, 1e-12


@dataclass(slots=True)
class Motion:
    """Where a collision has got to; it changes with every step. `lasted` is about how long the next step may last."""

    state: list[float]
    touching: list[bool]
    clock: Clock = TIME
    landing: bool = False
    stride: float = 0.0
    lasted: float = FIRST_STRIDE
    began: float | None = None
    ended: float = 0.0
    openings: int = 0
    evaluations: int = 0


def collide(line: Row, tolerance: float = 1e-13) -> RowResult:
    """Follow the line from its start to the last opening; `tolerance` is the error allowed to a single step, in natural units.

    Raises GuardFailed when momentum or energy is lost, or the end is not reached.
    """
    units = natural_units(line)
    if units is None:
        still = (0.0,) * len(line.gaps)
        return RowResult(line.velocities, 0.0, still, still, "missed", 0)
    return in_si(_follow(course(in_units(line, units), tolerance)), units)


def _follow(way: Course) -> RowResult:
    line = way.line
    motion = Motion([0.0, *(-gap for gap in line.gaps), *line.velocities], [gap <= 0.0 for gap in line.gaps])
    crests = Crests(line)
    most = MOST_STEPS if len(line.masses) < LONG else MOST_STEPS_OF_A_LONG_ROW
    for _ in range(most):
        _settle(line, motion)
        # Before the sleepers: a contact that its damping holds for ever soon has too little in it to be seen.
        if way.damped and stays(line, motion.state, motion.touching, way.tolerance):
            return _arrived(way, motion, crests, "sticks")
        if asleep(line, motion.state, motion.touching, way.noise):
            _let_go(line, motion, way.noise)
            meeting = first_touch(line, motion.state, way.noise, bounced=motion.began is not None)
            if meeting is None:
                return _arrived(way, motion, crests, "released" if motion.began is not None else "missed")
            motion.state = flown(line, motion.state, meeting)
            motion.touching = [j == meeting.contact for j in range(len(line.gaps))]
            motion.clock, motion.landing, motion.lasted = TIME, False, FIRST_STRIDE
        if motion.began is None:
            motion.began = motion.state[0]
        _advance(way, motion, crests)
    raise GuardFailed(
        f"The collision did not end within {most} steps. Make the masses less unequal or the balls fewer."
    )


def _settle(line: Row, motion: Motion) -> None:
    """Where bodies just touch, the speed says whether the contact begins or has ended."""
    if 0.0 not in motion.state:
        return
    for j, overlap in enumerate(overlaps(line, motion.state)):
        if overlap == 0.0:
            motion.touching[j] = closing_speed(line, motion.state, j) >= 0.0


def _let_go(line: Row, motion: Motion, noise: float) -> None:
    """Contacts with too little left in them to matter end on their own, as if nothing pushed."""
    for j, on in enumerate(motion.touching):
        overlap, opening = motion.state[1 + j], -closing_speed(line, motion.state, j)
        if on and overlap > 0.0:
            motion.openings += 1
            motion.ended = max(
                motion.ended, motion.state[0] + (overlap / opening if opening > noise else 0.0)
            )
            motion.touching[j], motion.state[1 + j] = False, 0.0


def _arrived(way: Course, motion: Motion, crests: Crests, outcome: Outcome) -> RowResult:
    line, lost = way.line, 1e3 * way.tolerance + 1e-15 * motion.evaluations
    guard(
        line,
        energy(line, overlaps(line, motion.state), velocities(line, motion.state)),
        velocities(line, motion.state),
        lost,
    )
    speeds, duration, deepest = (
        tuple(velocities(line, motion.state)),
        motion.ended - (motion.began or 0.0),
        crests.overlaps,
    )
    if outcome == "sticks":
        speeds, duration = common_velocities(line, motion.state, motion.touching), math.inf
        deepest = [max(pair) for pair in zip(deepest, resting_overlaps(line, motion.touching), strict=True)]
    return RowResult(
        velocities=speeds,
        duration=duration,
        overlaps=tuple(deepest),
        forces=tuple(crests.forces),
        outcome=outcome,
        evaluations=motion.evaluations + crests.evaluations,
        openings=motion.openings,
    )


def _advance(way: Course, motion: Motion, crests: Crests) -> None:
    """One accepted step, on the clock that suits it, ending at latest where a contact begins or ends."""
    state, touching = motion.state, motion.touching
    in_time = way.law(touching, TIME)
    base = in_time(state[0], state[1:])
    if way.damped:
        crests.onset(state, touching)
    trial, landing = _accepted(way, motion, base)
    crests.passed(state, trial, touching, base, in_time)
    growth = factor(trial.size)
    motion.clock, motion.landing, motion.stride = trial.clock, landing and not trial.lands, trial.h * growth
    lasted = max((trial.after[0] - state[0]) * growth, LEAST_STRIDE)
    motion.lasted = max(lasted, motion.lasted) if trial.lands else lasted
    motion.state = trial.after
    motion.evaluations += 1
    _note_touches(motion, trial.clock.contact if trial.lands else None)


def _accepted(way: Course, motion: Motion, base: Sequence[float]) -> tuple[Step, bool]:
    """The first trial that is exact enough and crosses no beginning or end of a contact; and whether it is on its way to one."""
    state, touching = motion.state, motion.touching
    landing = motion.landing and nears_zero(way, state, base, motion.clock)
    clock = (
        motion.clock if landing else suited_clock(way.powers, state, base, touching, motion.lasted, way.noise)
    )
    if clock is TIME:
        next_touch = due(way, state, base, motion.lasted, touching)
        if next_touch is not None:
            clock, landing = landing_clock(way.powers, next_touch, touching), True
    stride = stride_for(state, base, clock, motion.lasted)
    if clock is motion.clock and motion.stride and abs(motion.stride) < abs(stride):
        stride = motion.stride
    if stride == 0.0:  # too short for this clock to tick
        clock, landing, stride = TIME, False, motion.lasted
    for count in range(MOST_TRIALS):
        trial = attempt(way.step, clock, way.law(touching, clock), state, base, stride, way.tolerance)
        motion.evaluations += EVALUATIONS
        if not trial.size <= 1.0:
            stride = trial.h * factor(trial.size)
            if landing and count > 20:  # the speed turns before the bodies part: there is nowhere to land
                clock, landing = TIME, False
                stride = 0.1 * motion.lasted
            continue
        speeds = closing_speeds(way.line, trial.after)
        own = trial.clock.contact
        if (
            own is not None and speeds[own] * base[own] < 0.0
        ):  # its clock stood still on the way: beyond, time would run back
            stride = 0.2 * trial.h
            continue
        crossing = first_crossing(way, state, base, trial, speeds, touching)
        if count < 60 and crossing is None and grazes(way, state, base, trial, speeds, touching):
            stride = 0.5 * trial.h
            continue
        if crossing is None or count > 60:
            return trial, landing
        if base[crossing] != 0.0 and (base[crossing] < 0.0) == touching[crossing]:
            clock, landing = landing_clock(way.powers, crossing, touching), True
            stride = -reading(clock, state)
        else:
            stride = 0.5 * trial.h
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
        motion.clock, motion.stride = TIME, 0.0
