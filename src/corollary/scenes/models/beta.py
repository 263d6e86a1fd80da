"""One contact without weight or damping, in closed form: Beta functions close the energy integral."""

from __future__ import annotations

import math


def largest_overlap(m: float, k: float, q: float, v: float) -> float:
    """The overlap (m) at which k overlap^q has stopped a (reduced) mass m that arrived at speed v.

    Source: energy, m v^2 / 2 = k overlap^(q+1) / (q+1).
    """
    return (0.5 * (q + 1.0) * m * v * v / k) ** (1.0 / (q + 1.0))


def duration_factor(q: float) -> float:
    """Contact time in units of largest overlap over speed: pi for a spring, 2.943275… for Hertz contact."""
    p = 1.0 / (q + 1.0)
    return 2.0 * math.sqrt(math.pi) * math.exp(math.lgamma(1.0 + p) - math.lgamma(0.5 + p))


def contact_time(m: float, k: float, q: float, v: float) -> float:
    """How long (s) a (reduced) mass m touches when it arrives at speed v and is pushed back by k overlap^q."""
    return duration_factor(q) * largest_overlap(m, k, q, v) / v


def suggested_step(m: float, k: float, q: float, v: float) -> float:
    """A time step (s) for a fixed-step program: a hundredth of the contact time, good to about 1e-4."""
    return contact_time(m, k, q, v) / 100.0
