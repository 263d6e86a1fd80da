"""The overlaps of bodies in a row with springs between them: sums of normal modes while the same ones touch."""

# pyright: reportUnknownArgumentType=false

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import GuardFailed

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
