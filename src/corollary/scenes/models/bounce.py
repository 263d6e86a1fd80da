"""One undamped contact by its energy integral: Beta functions close it without weight, a quadrature gives it on a floor with weight."""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.models.gauss import integral


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


@dataclass(frozen=True, slots=True)
class Bounce:
    """`overlap` (m) is the largest, `force` (N) the floor's largest push, `duration` (s) that of the contact."""

    overlap: float
    force: float
    duration: float
    error_estimate: float
    evaluations: int


def deepest(contact: Contact, mass: float, speed: float, weight: float) -> float:
    """The overlap where a ball that meets the floor at `speed` and is pulled on by `weight` (m/s^2) comes to rest."""
    if weight == 0.0:
        return largest_overlap(mass, contact.k, contact.q, speed)
    # In units of the answer without weight: x^(q+1) = 1 + g x, increasing and convex beyond its root, so Newton falls onto it.
    p, x = contact.q + 1.0, 2.0
    unit = max(
        largest_overlap(mass, contact.k, contact.q, speed),
        (p * mass * weight / contact.k) ** (1.0 / contact.q),
    )
    stiff = 2.0 * contact.k * unit**p / (p * mass)
    for _ in range(200):
        step = (stiff * x**p - 2.0 * weight * unit * x - speed**2) / (
            stiff * p * x ** (p - 1.0) - 2.0 * weight * unit
        )
        x -= step
        if abs(step) <= 2e-16 * x:
            break
    return unit * x


def bounce(contact: Contact, mass: float, speed: float, weight: float) -> Bounce:
    """The contact of a ball that meets the floor at `speed` (> 0).

    speed^2 + 2 g overlap - 2 k overlap^(q+1) / ((q+1) m) is the square of the ball's speed; written as a difference from its zero
    at the largest overlap D it loses no digits there. With overlap = D sin(angle)^s the integrand is smooth.
    """
    overlap = deepest(contact, mass, speed, weight)
    force = contact.k * overlap**contact.q
    if weight == 0.0:
        return Bounce(overlap, force, contact_time(mass, contact.k, contact.q, speed), 1e-15, 0)
    s, p = max(smoothing_power(contact), 2), contact.q + 1.0
    stiff, fall = 2.0 * contact.k * overlap**p / (p * mass), 2.0 * weight * overlap

    def per_angle(angle: float) -> float:
        sine, cosine = math.sin(angle), math.cos(angle)
        log = 0.5 * s * math.log1p(-cosine * cosine) if sine > 0.5 else s * math.log(sine)
        square = -stiff * math.expm1(p * log) + fall * math.expm1(log)
        return s * sine ** (s - 1) * cosine / math.sqrt(square)

    value, error_estimate, spent = integral(per_angle, 0.0, 0.5 * math.pi)
    return Bounce(overlap, force, 2.0 * overlap * value, error_estimate, spent)
