"""Collisions on a line, each touch followed on its own clock, so that a method of high order keeps its order.

A contact force k overlap^(3/2) has no second derivative where it begins; in w, overlap = w^2, it is a polynomial. So w is the
clock while a contact is young or about to end, which also lets the last step end exactly where the bodies part.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scene.line import Line, Passage, energy, guard, in_si, in_units, natural_units
from corollary.scene.method.clock import TIME, Clock, landing_clock, reading, stride_for, suited_clock
from corollary.scene.method.crest import Crests
from corollary.scene.method.line_motion import Law, closing_speed, law_of_motion, overlaps, velocities
from corollary.scene.method.trial import Trial, attempt
from corollary.scene.model.flight import asleep, first_touch, flown
from corollary.scene.model.sticking import common_velocities, resting_overlaps, stays
from corollary.scene.run import GuardFailed, Outcome

# A middle ball 1e-4 as heavy as its neighbours takes 3 000 steps; 1e-6 as heavy would take 30 000, which nobody waits for.
MOST_STEPS = 15_000
MOST_TRIALS = 80
FIRST_STRIDE = 0.05


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


def collide(line: Line, tolerance: float = 1e-13) -> Passage:
    """Follow the line from its start to the last opening; `tolerance` is the error allowed to a single step, in natural units.

    Raises GuardFailed when momentum or energy is lost, or the end is not reached.
    """
    units = natural_units(line)
    if units is None:
        still = (0.0,) * len(line.gaps)
        return Passage(line.velocities, 0.0, still, still, "missed", 0)
    return in_si(_follow(in_units(line, units), tolerance), units)


def _follow(line: Line, tolerance: float) -> Passage:
    # Speeds that a few steps' errors can make are not told from none.
    noise = max(1e-14, 3.0 * tolerance)
    motion = Motion([0.0, *(-gap for gap in line.gaps), *line.velocities], [gap <= 0.0 for gap in line.gaps])
    crests = Crests(line)
    for _ in range(MOST_STEPS):
        for j, overlap in enumerate(overlaps(line, motion.state)):
            if overlap == 0.0:  # just touching: the speed says whether the contact begins or has ended
                motion.touching[j] = closing_speed(line, motion.state, j) >= 0.0
        if asleep(line, motion.state, motion.touching, noise):
            _let_go(line, motion)
            meeting = first_touch(line, motion.state, noise, bounced=motion.began is not None)
            if meeting is None:
                return _arrived(line, motion, crests, tolerance, "released" if motion.began is not None else "missed")
            motion.state = flown(line, motion.state, meeting)
            motion.touching = [j == meeting.contact for j in range(len(line.gaps))]
            motion.clock, motion.landing, motion.lasted = TIME, False, FIRST_STRIDE
        if motion.began is None:
            motion.began = motion.state[0]
        if stays(line, motion.state, motion.touching, tolerance):
            return _arrived(line, motion, crests, tolerance, "sticks")
        _advance(line, motion, crests, tolerance, noise)
    raise GuardFailed(f"The collision did not end within {MOST_STEPS} steps. Make the masses less unequal or the balls fewer.")


def _let_go(line: Line, motion: Motion) -> None:
    """Contacts with too little left in them to matter have ended."""
    faint = [j for j, on in enumerate(motion.touching) if on and motion.state[1 + j] > 0.0]
    motion.openings += len(faint)
    motion.ended = motion.state[0] if faint else motion.ended
    for j in faint:
        motion.touching[j], motion.state[1 + j] = False, 0.0


def _arrived(line: Line, motion: Motion, crests: Crests, tolerance: float, outcome: Outcome) -> Passage:
    lost = 1e3 * tolerance + 1e-15 * motion.evaluations
    guard(line, energy(line, overlaps(line, motion.state), velocities(line, motion.state)), velocities(line, motion.state), lost)
    speeds, duration, deepest = tuple(velocities(line, motion.state)), motion.ended - (motion.began or 0.0), crests.overlaps
    if outcome == "sticks":
        speeds, duration = common_velocities(line, motion.state, motion.touching), math.inf
        deepest = [max(pair) for pair in zip(deepest, resting_overlaps(line, motion.touching), strict=True)]
    return Passage(
        velocities=speeds,
        duration=duration,
        overlaps=tuple(deepest),
        forces=tuple(crests.forces),
        outcome=outcome,
        evaluations=motion.evaluations + crests.evaluations,
        openings=motion.openings,
    )


def _advance(line: Line, motion: Motion, crests: Crests, tolerance: float, noise: float) -> None:
    """One accepted step, on the clock that suits it, ending at latest where a contact begins or ends."""
    state, touching = motion.state, motion.touching
    in_time = law_of_motion(line, touching)
    base = in_time(state)
    crests.onset(state, touching)
    trial, landing = _accepted(line, motion, in_time, base, tolerance, noise)
    crests.passed(state, trial.after, touching, base, in_time, trial.part_way)
    growth = min(5.0, 0.9 * trial.size**-0.125) if trial.size > 0.0 else 5.0
    motion.clock, motion.landing, motion.stride = trial.clock, landing and not trial.lands, trial.h * growth
    motion.lasted = max((trial.after[0] - state[0]) * growth, 1e-300)
    motion.state = trial.after
    motion.evaluations += 1
    _note_touches(line, motion, trial.clock.contact if trial.lands else None)


def _accepted(line: Line, motion: Motion, in_time: Law, base: list[float], tolerance: float, noise: float) -> tuple[Trial, bool]:
    """The first trial that is exact enough and crosses no beginning or end of a contact; and whether it is on its way to one."""
    state = motion.state
    landing = motion.landing
    clock = motion.clock if landing else suited_clock(line, state, base, motion.touching, noise)
    stride = motion.stride if clock == motion.clock and motion.stride else stride_for(line, state, clock, motion.lasted)
    for count in range(MOST_TRIALS):
        trial = attempt(line, clock, in_time, state, base, stride, tolerance)
        motion.evaluations += trial.evaluations
        if not trial.size <= 1.0:
            stride = trial.h * (max(0.2, 0.9 * trial.size**-0.125) if trial.size < math.inf else 0.2)
            if landing and count > 20:  # the speed turns before the bodies part: there is nowhere to land
                clock, landing = TIME, False
                stride = 0.1 * motion.lasted
            continue
        crossing = _first_crossing(line, state, trial, motion.touching, noise)
        if count < 60 and crossing is None and _grazes(line, state, trial, motion.touching):
            stride = 0.5 * trial.h
            continue
        if crossing is None or count > 60:
            return trial, landing
        speed = closing_speed(line, state, crossing)
        if speed != 0.0 and (speed < 0.0) == motion.touching[crossing]:
            clock, landing = landing_clock(line, crossing, motion.touching), True
            stride = -reading(clock, state)
        else:
            stride = 0.5 * trial.h
    raise GuardFailed("No step is small enough to follow the collision. Make the settings less extreme.")


def _note_touches(line: Line, motion: Motion, landed: int | None) -> None:
    """Say which contacts have opened or closed in the step just taken."""
    for j, overlap in enumerate(overlaps(line, motion.state)):
        if motion.touching[j] and (overlap < 0.0 or j == landed):
            motion.touching[j] = False
            motion.openings += 1
            motion.ended = motion.state[0]
        elif not motion.touching[j] and (overlap > 0.0 or j == landed):
            motion.touching[j] = True
    if landed is not None:
        motion.clock, motion.stride = TIME, 0.0


def _first_crossing(line: Line, old: list[float], trial: Trial, touching: list[bool], noise: float) -> int | None:
    """The contact that begins or ends first in a step, too slow ones apart: those change nothing that can be seen."""
    first, when = None, 2.0
    for j, on in enumerate(touching):
        before, after = old[1 + j], trial.after[1 + j]
        if j == trial.clock.contact or not ((on and after < 0.0 < before) or (not on and after > 0.0)):
            continue
        if abs(closing_speed(line, old, j)) <= noise and abs(closing_speed(line, trial.after, j)) <= noise:
            continue
        if before / (before - after) < when:
            first, when = j, before / (before - after)
    return first


def _grazes(line: Line, old: list[float], trial: Trial, touching: list[bool]) -> bool:
    """Whether an overlap may pass zero and come back inside a step; judged by a parabola, so it errs on shorter steps."""
    lasted = trial.after[0] - old[0]
    for j, on in enumerate(touching):
        sign = 1.0 if on else -1.0
        before, after = sign * closing_speed(line, old, j), sign * closing_speed(line, trial.after, j)
        if before < 0.0 < after and sign * old[1 + j] < 0.5 * before**2 * lasted / (after - before):
            return True
    return False
