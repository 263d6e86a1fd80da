"""A body that throws out mass at a steady rate (rocket equation 12.129)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Thrust:
    """Exhaust leaves one body with velocity `relative` to it, at the rate of `burn` kg/s (> 0)."""

    body: int
    relative: tuple[float, ...]
    burn: float


def push(thrust: Thrust) -> list[float]:
    """The force (N) of the exhaust: v_rel dm/dt, and dm/dt is negative."""
    return [-thrust.burn * v for v in thrust.relative]
