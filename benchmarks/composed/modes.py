"""How discs are held: every combination of open and held, of stuck and slipping is tried, and the one that the laws allow is taken.

The laws are those of Signorini and Coulomb for motion, and of Newton (restitution) and Coulomb for hits. Where none or several that differ
are allowed, there is no reference, and that is said; nothing is decided by iterating.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from .discs import OnPlate, Row, System

STICKS = 0
AT_REST = 1e-9
"""Surfaces that are no faster than this (m/s) may stick."""
CLOSING = 1e-10
"""What approaches no faster than this (m/s) is not hit."""


class NoReference(Exception):
    """The laws, or the means of this reference, do not say what happens."""


class NoMode(NoReference):
    """No combination is allowed."""


@dataclass(frozen=True, slots=True)
class Mode:
    """Which constraints hold, where surfaces rub (`STICKS`, or the sign of the slip), and which pairs push each other."""

    held: tuple[int, ...] = ()
    rubbing: Mapping[int, int] = field(default_factory=dict)
    touching: frozenset[int] = frozenset()


class Response(NamedTuple):
    """Accelerations, what each constraint presses with, and what friction each stuck surface takes."""

    accelerations: Any
    presses: dict[int, float]
    takes: dict[int, float]


def gathered(
    system: System, t: float, state: Any, held: Sequence[int], rubbing: Mapping[int, int]
) -> tuple[list[Row], list[Any]]:
    """What is held at rest, then what sticks: its row, and the direction in which its force pushes. Slip on a plate tilts the force of that."""
    rows = [system.holds[i].row(t, state) for i in held]
    pushes = [row.on.copy() for row in rows]
    for k, sense in rubbing.items():
        which, surface, friction = system.rubs[k]
        slip = surface.slip(state)
        if sense == STICKS:
            rows.append(slip)
            pushes.append(slip.on)
        elif isinstance(surface, OnPlate):
            at = held.index(which)
            pushes[at] = pushes[at] - sense * friction * slip.on
    return rows, pushes


def solved(system: System, rows: list[Row], pushes: list[Any], right: Any) -> tuple[Any, Any]:
    """How large each of the forces (or impulses) is that makes `rows` what is asked, and what all do to the velocities."""
    if not rows:
        return np.zeros(0), 0.0
    across, along = np.array([row.on for row in rows]), np.array(pushes).T
    try:
        sizes = np.linalg.solve(across @ (system.mobility[:, None] * along), right)
    except np.linalg.LinAlgError as singular:
        raise NoMode("constraints that hold the same thing") from singular
    return sizes, system.mobility * (along @ sizes)


def motion(system: System, t: float, state: Any, mode: Mode) -> Response:
    """By Newton's second law, with what is held at rest."""
    forces = system.forces(state, mode.touching)
    for k, sense in mode.rubbing.items():
        which, surface, friction = system.rubs[k]
        if sense != STICKS and not isinstance(surface, OnPlate):
            forces -= sense * friction * system.pairs[which].elastic(state) * surface.slip(state).on
    rows, pushes = gathered(system, t, state, mode.held, mode.rubbing)
    free = system.mobility * forces
    sizes, change = solved(system, rows, pushes, np.array([-(row.on @ free + row.drift) for row in rows]))
    n, stuck = len(mode.held), [k for k, sense in mode.rubbing.items() if sense == STICKS]
    return Response(
        free + change,
        dict(zip(mode.held, sizes[:n], strict=True)),
        dict(zip(stuck, sizes[n:], strict=True)),
    )


def closing(system: System, i: int, t: float, state: Any) -> float:
    """How fast the gap of a constraint grows; below zero it closes."""
    row = system.holds[i].row(t, state)
    return float(row.on @ state[len(state) // 2 :] + row.rate)


def slipping(system: System, k: int, state: Any) -> float:
    return float(system.rubs[k][1].slip(state).on @ state[len(state) // 2 :])


def pressed(system: System, k: int, state: Any, presses: Mapping[int, float]) -> float:
    """The force that friction is a part of."""
    which, surface, _ = system.rubs[k]
    return presses[which] if isinstance(surface, OnPlate) else system.pairs[which].elastic(state)


def put_right(system: System, t: float, state: Any, mode: Mode) -> Any:
    """The velocities without the little that steps have left of motion where something holds."""
    rows, _ = gathered(system, t, state, mode.held, mode.rubbing)
    if not rows:
        return state
    n, across = len(state) // 2, np.array([row.on for row in rows])
    wrong = -np.array([row.rate for row in rows]) - across @ state[n:]
    if np.abs(wrong).max() > 1e-6:
        raise NoMode(f"{np.abs(wrong).max():g} m/s where something is held")
    sizes = np.linalg.lstsq(across @ (system.mobility[:, None] * across.T), wrong, rcond=None)[0]
    return np.concatenate([state[:n], state[n:] + system.mobility * (across.T @ sizes)])


def ways(holds: Sequence[int]) -> Iterable[list[int]]:
    """All choices of what holds, most of them first."""
    for picks in itertools.product([True, False], repeat=len(holds)):
        yield [i for i, pick in zip(holds, picks, strict=True) if pick]


def chosen(
    system: System,
    t: float,
    state: Any,
    touched: Sequence[int],
    touching: frozenset[int],
    still: Collection[int] = (),
    loose: int | None = None,
) -> Mode:
    """The one mode the laws allow where `touched` may hold; `still` are surfaces that do not slip yet, of which `loose` no longer sticks."""
    fixed = [i for i in touched if not system.holds[i].opens]
    free = [i for i in touched if system.holds[i].opens]
    found: list[tuple[float, Mode, Any]] = []
    for some in ways(free):
        held = (*fixed, *some)
        rubbing = [
            k
            for k, (which, surface, _) in enumerate(system.rubs)
            if which in (held if isinstance(surface, OnPlate) else touching)
        ]
        senses: list[tuple[int, ...]] = []
        for k in rubbing:
            slip = slipping(system, k, state)
            resting = abs(slip) < AT_REST or k in still
            senses.append(
                ((1, -1) if k == loose else (STICKS, 1, -1)) if resting else (1 if slip > 0 else -1,)
            )
        for combination in itertools.product(*senses):
            mode = Mode(held, dict(zip(rubbing, combination, strict=True)), touching)
            try:
                response = motion(system, t, state, mode)
            except NoMode:
                continue
            margin = min(_margins(system, t, state, mode, response, free, still), default=math.inf)
            if margin >= -1e-9 * max(1.0, np.abs(response.accelerations).max()):
                found.append((margin, mode, response.accelerations))
    if not found:
        raise NoMode(f"no mode at {t:g} s")
    found.sort(key=lambda each: -each[0])
    _, best, rates = found[0]
    if any(np.abs(other - rates).max() > 1e-6 * max(1.0, np.abs(rates).max()) for *_, other in found[1:]):
        raise NoReference(f"several modes at {t:g} s")
    return best


def _margins(
    system: System,
    t: float,
    state: Any,
    mode: Mode,
    response: Response,
    free: Sequence[int],
    still: Collection[int],
) -> Iterable[float]:
    """What must not be below zero: forces of what holds, openings of what does not, what friction has left, slip as its sign says."""
    for i in free:
        if i in mode.held:
            yield response.presses[i]
        else:
            row = system.holds[i].row(t, state)
            yield float(row.on @ response.accelerations + row.drift)
    for k, sense in mode.rubbing.items():
        if sense == STICKS:
            yield system.rubs[k][2] * pressed(system, k, state, response.presses) - abs(response.takes[k])
        elif abs(slipping(system, k, state)) < AT_REST or k in still:
            slip = system.rubs[k][1].slip(state)
            yield sense * float(slip.on @ response.accelerations + slip.drift)


def hit(system: System, t: float, state: Any, touched: Sequence[int], smallest: float) -> Any:
    """The state after hits, one after another while any that touch close; what would bounce slower than `smallest` (m/s) does not."""
    n = len(state) // 2
    for _ in range(60):
        state = np.concatenate([state[:n], _struck(system, t, state, touched, smallest)])
        if not any(closing(system, i, t, state) < -CLOSING for i in touched if system.holds[i].opens):
            return state
    raise NoReference("sixty hits in turn")


def _struck(system: System, t: float, state: Any, touched: Sequence[int], smallest: float) -> Any:
    """Velocities after one hit of all that closes."""
    velocities = state[len(state) // 2 :]
    fixed = [i for i in touched if not system.holds[i].opens]
    struck: dict[int, float] = {}
    for i in touched:
        if system.holds[i].opens and (rate := closing(system, i, t, state)) < CLOSING:
            back = -rate * system.holds[i].restitution
            struck[i] = back if back > smallest else 0.0
    small, found = 1e-11 * max(1.0, np.abs(velocities).max()), []
    for some in ways(list(struck)):
        held = [*fixed, *some]
        rough = [k for k, (i, on, _) in enumerate(system.rubs) if isinstance(on, OnPlate) and i in some]
        for combination in itertools.product((STICKS, 1, -1), repeat=len(rough)):
            rubbing = dict(zip(rough, combination, strict=True))
            rows, pushes = gathered(system, t, state, held, rubbing)
            speeds = [struck.get(i, 0.0) for i in held] + [0.0] * (len(rows) - len(held))
            right = [v - row.rate - row.on @ velocities for v, row in zip(speeds, rows, strict=True)]
            try:
                sizes, change = solved(system, rows, pushes, np.array(right))
            except NoMode:
                continue
            after = velocities + change
            presses = dict(zip(held, sizes[: len(held)], strict=True))
            takes = iter(sizes[len(held) :])
            margins = [presses[i] for i in some]
            for i in struck.keys() - set(some):
                row = system.holds[i].row(t, state)
                margins.append(row.on @ after + row.rate - struck[i])
            for k, sense in rubbing.items():
                which, surface, friction = system.rubs[k]
                if sense == STICKS:
                    margins.append(friction * presses[which] - abs(next(takes)))
                else:
                    margins.append(sense * (surface.slip(state).on @ after))
            if min(margins, default=0.0) >= -small:
                found.append(after)
    if not found:
        raise NoMode(f"no hit at {t:g} s")
    if any(np.abs(each - found[0]).max() > 1e-8 * max(1.0, np.abs(velocities).max()) for each in found):
        raise NoReference(f"several hits at {t:g} s")
    return found[0]
