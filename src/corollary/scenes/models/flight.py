"""Bodies on a line while nothing touches: straight or falling motion, and the moment of the next touch, in closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.forces.contact import stored
from corollary.scenes.row import RowOfBodies, reduced_mass


@dataclass(frozen=True, slots=True)
class Meeting:
    """The contact that closes next, and after how long."""

    contact: int
    after: float


def fall_of(line: RowOfBodies, contact: int) -> float:
    """How fast the closing speed of a contact grows by weight alone: only beside a wall or floor."""
    if line.weight == 0.0:
        return 0.0
    left, right = (0.0 if math.isinf(m) else line.weight for m in line.masses[contact : contact + 2])
    return right - left


def inactive(line: RowOfBodies, state: Sequence[float], touching: Sequence[bool], noise: float) -> bool:
    """Whether no contact pushes or is about to: all are open, or touch without closing and with too little stored to matter.

    `noise` is the speed that cannot be told from none; where a dashpot brings it about, closing has to end first: it decides
    whether the contact opens at all.
    """
    count = len(line.masses)
    for j, on in enumerate(touching):
        if not on:
            continue
        closing, fall = state[count + j] - state[count + j + 1], fall_of(line, j)
        damped = line.contacts[j].eta > 0.0 and state[1 + j] > 0.0
        if closing > (0.0 if damped else noise) or (fall > 0.0 and closing >= 0.0):
            return False
        faint = 0.5 * reduced_mass(line.masses[j], line.masses[j + 1]) * noise**2
        if stored(line.contacts[j], state[1 + j]) > (0.0 if fall > 0.0 else faint):
            return False
    return True


def first_touch(line: RowOfBodies, state: Sequence[float], noise: float, bounced: bool) -> Meeting | None:
    """The next touch, if there is one; after a bounce, bodies that only weight would bring back together count as released."""
    count = len(line.masses)
    best = None
    for j in range(count - 1):
        gap, closing, fall = (
            max(-state[1 + j], 0.0),
            state[count + j] - state[count + j + 1],
            fall_of(line, j),
        )
        if closing <= noise and (bounced or fall <= 0.0):
            continue
        discriminant = closing**2 + 2.0 * fall * gap
        if discriminant < 0.0:
            continue
        # The root free of cancellation, whichever sign the closing speed has.
        root = math.sqrt(discriminant)
        after = 2.0 * gap / (closing + root) if closing > 0.0 else (root - closing) / fall
        if best is None or after < best.after:
            best = Meeting(j, after)
    return best


def after_flight(line: RowOfBodies, state: Sequence[float], meeting: Meeting) -> list[float]:
    """The state at the meeting."""
    count, t = len(line.masses), meeting.after
    speeds = state[count:]
    gaps = [
        state[1 + j] + (speeds[j] - speeds[j + 1]) * t + 0.5 * fall_of(line, j) * t * t
        for j in range(count - 1)
    ]
    gaps[meeting.contact] = 0.0
    falls = [0.0 if math.isinf(m) else line.weight for m in line.masses]
    return [
        state[0] + t,
        *(min(gap, 0.0) for gap in gaps),
        *(v - g * t for v, g in zip(speeds, falls, strict=True)),
    ]
