"""Two spheres without damping: energy and angular momentum give the contact as two integrals."""

from __future__ import annotations

import math

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.models.gauss import integral
from corollary.scenes.models.pair import Pair, Parting, Touching, deepest, hold_apart


def glance(pair: Pair, met: Touching) -> Parting:
    """The contact from its beginning to its end; by symmetry its second half mirrors the first.

    The square of the radial speed is written as a difference from its zero at the largest overlap, so no digits are lost there;
    with overlap = deepest sin(angle)^s the integrand is smooth. Raises BadSetting when the centres all but meet.
    """
    d, q = pair.reach, pair.contact.q
    depth = deepest(pair, met)
    hold_apart(depth, d)
    s, p = max(smoothing_power(pair.contact), 2), q + 1.0
    stiff, turning, nearest = 2.0 * pair.contact.k / (p * pair.mass) * depth**p, met.spin**2, d - depth

    def at(angle: float) -> tuple[float, float]:
        """dt/d(angle), and the distance of the centres."""
        sine, cosine = math.sin(angle), math.cos(angle)
        log = 0.5 * s * math.log1p(-cosine * cosine) if sine > 0.5 else s * math.log(sine)
        lacking = -math.expm1(log)
        r = nearest + depth * lacking
        square = -stiff * math.expm1(p * log) + turning * depth * lacking * (r + nearest) / (
            nearest * nearest * r * r
        )
        return depth * s * sine ** (s - 1) * cosine / math.sqrt(square), r

    def turning_rate(angle: float) -> float:
        pace, r = at(angle)
        return pace * met.spin / (r * r)

    half, doubt, spent = integral(lambda angle: at(angle)[0], 0.0, 0.5 * math.pi)
    turned, doubt_of_turn, spent_too = (
        integral(turning_rate, 0.0, 0.5 * math.pi) if met.spin else (0.0, 0.0, 0)
    )
    force = pair.contact.k * depth**q
    doubt = max(doubt, doubt_of_turn, 2e-15)
    return Parting(
        2.0 * turned, met.inward, met.spin, 2.0 * half, depth, force, False, spent + spent_too, doubt
    )
