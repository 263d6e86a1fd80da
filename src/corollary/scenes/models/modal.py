"""Normal modes of bodies in a row with springs between them: while the same ones touch, the motion is a sum of swings."""

# pyright: reportUnknownArgumentType=false

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.row import (
    RowOfBodies,
    RowResult,
    Units,
    conserved,
    guard,
    in_si,
    in_units,
    natural_units,
)
from corollary.scenes.run import GuardFailed, Outcome

Array = NDArray[np.floating]
Flags = NDArray[np.bool_]

# Speeds below this (in natural units) are what rounding leaves of zero, and overlaps below such a part of what they swing by.
NOISE = 1e-14


@dataclass(frozen=True, slots=True)
class NormalModes:
    """The overlaps as sums of modes: shapes @ (start cos wt + speed sin wt / w), a straight line where w is zero.

    shapes is (contacts, modes); frequencies, start and speed are (modes,). `apart` (contacts,) is what open contacts begin with: no
    force knows of it, and the rounding of a gap of miles would be more than all that oscillates. Of `noise` (contacts,) is what rounding
    leaves of no overlap: that of a light body swings by far less than those of heavy ones.
    """

    shapes: Array
    frequencies: Array
    start: Array
    speed: Array
    apart: Array
    noise: Array

    def at(self, times: Array) -> tuple[Array, Array]:
        """Overlaps and their rates at some times, each (contacts, times)."""
        w = self.frequencies[:, None]
        cosine, sine = (
            np.cos(w * times),
            np.where(w > 0.0, np.sin(w * times) / np.where(w > 0.0, w, 1.0), times),
        )
        place = self.start[:, None] * cosine + self.speed[:, None] * sine
        rate = self.speed[:, None] * cosine - self.start[:, None] * w**2 * sine
        return self.shapes @ place + self.apart[:, None], self.shapes @ rate

    def of(self, contact: int) -> OneOverlap:
        """The overlap of one contact."""
        shape = self.shapes[contact]
        parts = self.frequencies.tolist(), (shape * self.start).tolist(), (shape * self.speed).tolist()
        return OneOverlap(((0.0, float(self.apart[contact]), 0.0), *zip(*parts, strict=True)))


@dataclass(frozen=True, slots=True)
class OneOverlap:
    """One overlap in time: (frequency, start, speed) of each mode. For single times plain sums are faster than arrays."""

    modes: tuple[tuple[float, float, float], ...]

    def overlap(self, time: float) -> float:
        found = 0.0
        for w, a, b in self.modes:
            found += a * math.cos(w * time) + (b * math.sin(w * time) / w if w else b * time)
        return found

    def rate(self, time: float) -> float:
        found = 0.0
        for w, a, b in self.modes:
            found += b * math.cos(w * time) - a * w * math.sin(w * time)
        return found


@dataclass(frozen=True, slots=True)
class Swings:
    """How the overlaps of a row swing while certain contacts touch: `shapes` and `frequencies` as of `NormalModes`, `lower` and `modes` lead to them."""

    lower: Array
    modes: Array
    shapes: Array
    frequencies: Array

    @classmethod
    def of(cls, line: RowOfBodies, touching: Flags) -> Swings:
        """overlap'' = -M K overlap, where M couples neighbours by their inverse masses and K holds the springs that touch.

        With M = L L^T the matrix L^T K L is symmetric, so its modes are orthogonal however unequal the masses are. Every open contact
        gives one mode that does not oscillate.
        """
        inverse = np.array([1.0 / m for m in line.masses])
        coupling = (
            np.diag(inverse[:-1] + inverse[1:]) - np.diag(inverse[1:-1], 1) - np.diag(inverse[1:-1], -1)
        )
        try:
            lower = np.linalg.cholesky(coupling)
        except np.linalg.LinAlgError:
            raise GuardFailed(
                "Beside the lightest one nothing is left of the others. Make the masses less unequal."
            ) from None
        springs = np.array([c.k for c in line.contacts]) * touching
        squares, modes = np.linalg.eigh(lower.T @ (springs[:, None] * lower))
        squares[: int(np.sum(~touching))] = 0.0
        return cls(lower, modes, lower @ modes, np.sqrt(np.maximum(squares, 0.0)))

    def begun(self, touching: Flags, overlaps: Array, rates: Array) -> NormalModes:
        """The motion from these overlaps and rates on, while exactly these contacts touch."""
        both = np.stack((np.where(touching, overlaps, 0.0), rates), axis=1)
        start, speed = (self.modes.T @ np.linalg.solve(self.lower, both)).T
        w, swinging = self.frequencies, self.frequencies > 0.0
        wide = np.where(swinging, np.abs(start) + np.abs(speed) / np.where(swinging, w, 1.0), 0.0)
        noise = NOISE * np.where(touching, np.minimum(np.abs(self.shapes) @ wide, 1.0), 1.0)
        return NormalModes(self.shapes, w, start, speed, np.where(touching, 0.0, overlaps), noise)


# A body a millionth as heavy as its neighbours is thrown to and fro some 1600 times, each time opening and closing two contacts. In rows
# of more than so many bodies all that takes longer, and what is struck so often is not known in the end: fewer are enough.
MOST_PHASES, LONG = 8000, 10
MOST_BLOCKS = 5_000
# The energy that rounding may change: so much in all, or so much for each body at every opening.
LEAST_ALLOWED, ALLOWED_EACH = 1e-11, 2e-14
# A grid so fine that an overlap has one turning point at most between two of its points.
CELL = 0.05
# So many cells are looked at together: few at first, for what is light opens soon again.
FIRST_CELLS, MOST_CELLS = 32, 256


@np.errstate(all="ignore")  # what leaves the range of a computer is found in the values
def collide(line: RowOfBodies, otherwise: bool = False) -> RowResult:
    """Follow a line of springs (q = 1, no damping, no weight) exactly from one opening or closing to the next.

    With `otherwise` in other units, so that all is rounded otherwise: what that changes is what rounding has come to.
    Raises GuardFailed when momentum or energy is lost, or the end is not reached.
    """
    units = natural_units(line)
    if units is None:
        still = (0.0,) * len(line.gaps)
        return RowResult(line.velocities, 0.0, still, still, "missed", 0)
    if otherwise:
        units = Units(1.1 * units.mass, 0.9 * units.speed, 1.3 * units.overlap)
    return in_si(_follow(in_units(line, units)), units)


def _follow(line: RowOfBodies) -> RowResult:
    overlaps = -np.array(line.gaps)
    rates = np.array(line.velocities[:-1]) - np.array(line.velocities[1:])
    touching = overlaps >= 0.0
    largest = np.maximum(overlaps, 0.0)
    time, began, ended, openings, strain = 0.0, math.inf, 0.0, 0, 0.0
    opens, noise, swung = 0.0, np.zeros(len(rates)), np.zeros(len(rates))
    swings: dict[bytes, Swings] = {}
    most = MOST_PHASES * LONG // max(LONG, len(line.masses))
    for _ in range(most):
        awake = touching & ((overlaps > noise) | (rates > NOISE))
        if not awake.any():
            closing = np.where(
                rates > NOISE, np.maximum(-overlaps, 0.0) / np.where(rates > NOISE, rates, 1.0), np.inf
            )
            j = int(np.argmin(closing))
            if math.isinf(closing[j]):
                arrived = _arrived(line, overlaps, rates, largest, ended - began, openings)
                return replace(arrived, strain=max(strain, opens))
            time += float(closing[j])
            strain = max(strain, (1.0 + float(closing[j])) / float(rates[j]))
            overlaps, touching = overlaps + rates * closing[j], np.arange(len(rates)) == j
            overlaps[j] = 0.0
        began = min(began, time)
        which = touching.tobytes()
        if which not in swings:
            swings[which] = Swings.of(line, touching)
        motion = swings[which].begun(touching, overlaps, rates)
        noise = motion.noise
        swung = np.where(touching, np.maximum(swung, noise / NOISE), 0.0)
        j, lasted, maxima = _until_change(motion, touching)
        largest = np.maximum(largest, maxima)
        overlaps, rates = (values[:, 0] for values in motion.at(np.array([lasted])))
        time += lasted
        overlaps[j] = 0.0
        openings += int(touching[j])
        if touching[j]:
            # What is off in its overlap, and in its rate, as a part of what it swings by.
            off = float(swung[j]) + 1.0 / float(motion.frequencies.max())
            ended, opens = time, off / max(abs(float(rates[j])), NOISE)
        touching = touching ^ (np.arange(len(rates)) == j)
    raise GuardFailed(
        f"The springs opened and closed {most} times without an end. Make the masses less unequal."
    )


def _until_change(motion: NormalModes, touching: Flags) -> tuple[int, float, Array]:
    """The contact that opens or closes next, after how long, and the largest overlap of each contact until then."""
    cell = CELL / float(motion.frequencies.max())
    sign = np.where(touching, 1.0, -1.0)[:, None]
    maxima = np.zeros(len(touching))
    begin, cells = 0, FIRST_CELLS
    for _ in range(MOST_BLOCKS):
        times = cell * (begin + np.arange(cells + 1))
        overlaps, rates = motion.at(times)
        # Turned so that every contact, open or closed, changes when its value falls through zero.
        values, slopes = sign * overlaps, sign * rates
        falls = values[:, 1:] < -motion.noise[:, None]
        falls |= ~falls & _dips(motion, times, values, slopes, sign)
        first = int(falls.any(axis=0).argmax())
        found = bool(falls[:, first].any())
        stop = first + 1 if found else cells
        for j, i in zip(
            *np.nonzero(touching[:, None] & (rates[:, :stop] > 0.0) & (rates[:, 1 : stop + 1] <= 0.0)),
            strict=True,
        ):
            alone = motion.of(int(j))
            maxima[j] = max(maxima[j], alone.overlap(_zero(alone.rate, float(times[i]), float(times[i + 1]))))
        if found:
            moment, j = min(
                (
                    _falling_zero(
                        motion.of(j),
                        float(sign[j, 0]),
                        float(motion.noise[j]),
                        *_around(times, values[j], first),
                    ),
                    j,
                )
                for j in np.flatnonzero(falls[:, first]).tolist()
            )
            return j, moment, maxima
        begin, cells = begin + cells, min(2 * cells, MOST_CELLS)
    raise GuardFailed(
        "Beside how fast the lightest one swings the others hardly move. Make the masses less unequal."
    )


def _dips(motion: NormalModes, times: Array, values: Array, slopes: Array, sign: Array) -> Flags:
    """Cells inside which a value falls below zero and is back at the end: those with a minimum, looked at closely."""
    dips = np.zeros((len(values), len(times) - 1), dtype=bool)
    # Where it bends upward it stays above its tangents; with twice their slopes there is something to spare.
    lasts = times[1] - times[0]
    near = (values[:, :-1] < -2.0 * lasts * slopes[:, :-1]) | (values[:, 1:] < 2.0 * lasts * slopes[:, 1:])
    for j, i in zip(*np.nonzero((slopes[:, :-1] < 0.0) & (slopes[:, 1:] > 0.0) & near), strict=True):
        alone, turn = motion.of(int(j)), float(sign[j, 0])
        low = _zero(
            lambda t, alone=alone, turn=turn: -turn * alone.rate(t), float(times[i]), float(times[i + 1])
        )
        dips[j, i] = turn * alone.overlap(low) < -motion.noise[j]
    return dips


def _around(times: Array, values: Array, i: int) -> tuple[float, float]:
    """The ends of the cell in which a value that falls below its noise in cell i falls through zero: that one, or one before."""
    before = np.flatnonzero(values[: i + 1] > 0.0)
    left = int(before[-1]) if len(before) else 0
    return float(times[left]), float(times[left + 1])


def _falling_zero(alone: OneOverlap, sign: float, noise: float, left: float, right: float) -> float:
    def value(t: float) -> float:
        return sign * alone.overlap(t)

    if value(left) <= noise and sign * alone.rate(left) > 0.0 > sign * alone.rate(right):
        # It has just changed, rises, and falls again within the cell: look beyond its highest point.
        left = _zero(lambda t: sign * alone.rate(t), left, right)
    if value(left) <= 0.0:
        return left
    if value(right) > -noise:  # it dips between: fall to the lowest point only
        right = _zero(lambda t: -sign * alone.rate(t), left, right)
    return _zero(value, left, right)


def _zero(value: Callable[[float], float], left: float, right: float) -> float:
    """Where a value that falls from `left` to `right` is zero, to the last digit (Illinois)."""
    high, low, side = value(left), value(right), 0
    for _ in range(60):
        if high <= low:  # nothing but rounding on either side
            break
        middle = left + (right - left) * high / (high - low)
        if not left < middle < right:
            return min(max(middle, left), right)
        here = value(middle)
        if here > 0.0:
            left, high, low, side = middle, here, low * (0.5 if side > 0 else 1.0), 1
        elif here < 0.0:
            right, low, high, side = middle, here, high * (0.5 if side < 0 else 1.0), -1
        else:
            return middle
    return 0.5 * (left + right)


def _arrived(
    line: RowOfBodies, overlaps: Array, rates: Array, largest: Array, duration: float, openings: int
) -> RowResult:
    """Velocities from the differences to that of the heaviest body (or the wall), which momentum (or the wall) gives."""
    behind = -np.concatenate([[0.0], np.cumsum(rates)])
    heaviest = max(range(len(line.masses)), key=line.masses.__getitem__)
    behind -= behind[heaviest]
    anchor = line.velocities[heaviest]
    if not math.isinf(line.masses[heaviest]):
        moved = [m * (v - b) for m, v, b in zip(line.masses, line.velocities, behind.tolist(), strict=True)]
        anchor = math.fsum(moved) / math.fsum(line.masses)
    velocities = tuple(anchor + b for b in behind.tolist())
    masses = [m for m in line.masses if not math.isinf(m)]
    # Rounding counts as the square root of the mass ratio: so unequal are the modes.
    unequal = max(1.0, 0.1 * math.sqrt(max(masses) / min(masses)))
    allowed = max(LEAST_ALLOWED, ALLOWED_EACH * len(velocities) * openings) * unequal
    before = conserved(line, [-gap for gap in line.gaps], line.velocities)
    guard(line, before, conserved(line, [0.0] * len(rates), velocities), allowed, 0)
    outcome: Outcome = "released" if openings else "missed"
    forces = tuple(c.k * float(d) for c, d in zip(line.contacts, largest, strict=True))
    return RowResult(velocities, max(duration, 0.0), tuple(map(float, largest)), forces, outcome, 0, openings)
