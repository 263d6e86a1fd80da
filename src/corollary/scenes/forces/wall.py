"""A hard wall that a body bounces off at once, with a coefficient of restitution (equation 12.60)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class HardWall:
    """The plane normal . place = offset; bodies stay on the side the unit vector `normal` points to."""

    normal: tuple[float, ...]
    offset: float = 0.0
    restitution: float = 1.0


def clearance(wall: HardWall, place: Sequence[float], radius: float) -> float:
    """How far (m) the surface of a body is from the wall; negative behind it."""
    return sum(n * x for n, x in zip(wall.normal, place, strict=True)) - wall.offset - radius


def bounced(wall: HardWall, velocity: Sequence[float]) -> list[float]:
    """The velocity after the bounce: what goes into the wall comes back with the restitution's share."""
    into = min(sum(n * v for n, v in zip(wall.normal, velocity, strict=True)), 0.0)
    return [v - (1.0 + wall.restitution) * into * n for n, v in zip(wall.normal, velocity, strict=True)]
