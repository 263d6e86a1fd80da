"""One step of DOP853 on any right side, tried: where it leads, and how far it is off."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Slope, error_estimate, step


@dataclass(slots=True)
class IntegrationStep:
    """Over h to the state `after`; `size` is the estimate of its error in units of what is allowed."""

    h: float
    after: list[float]
    size: float


def tried(slope: Slope, x: float, before: list[float], h: float, allowed: Sequence[float]) -> IntegrationStep:
    """`allowed` is the error allowed to each component. A step out of all range has an infinite size."""
    try:
        after, slopes = step(DOP853, slope, x, before, h, slope(x, before))
        return IntegrationStep(h, after, error_estimate(DOP853, slopes, h, allowed))
    except (OverflowError, ZeroDivisionError):
        return IntegrationStep(h, list(before), math.inf)
