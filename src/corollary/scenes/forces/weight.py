"""Weight: the same acceleration for every body, down along the last axis."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Weight:
    """g in m/s^2."""

    g: float = 9.8
