"""A body that takes up mass at a steady rate (rocket equation 12.126)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Absorption:
    """One body takes up mass that moves with `velocity`, at `rate` kg/s (> 0)."""

    body: int
    velocity: tuple[float, ...]
    rate: float


def drag(absorption: Absorption, velocity: Sequence[float]) -> list[float]:
    """The force (N) of the mass taken up: (u - v) dm/dt."""
    return [absorption.rate * (u - v) for u, v in zip(absorption.velocity, velocity, strict=True)]
