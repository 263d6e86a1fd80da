"""A body: how heavy, how large, where, and how fast."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Body:
    """SI; `place` and `velocity` have one or two components. A body of infinite mass is a wall: it keeps its velocity."""

    mass: float
    place: tuple[float, ...]
    velocity: tuple[float, ...]
    radius: float = 0.0
    name: str = ""
