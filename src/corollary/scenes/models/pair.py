"""Two spheres seen from one of them: where they meet, an undamped contact as two integrals, and what becomes of both velocities."""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.models.gauss import integral
from corollary.scenes.run import BadSetting

Vector = tuple[float, float]

# Centres nearer than this share of the reach: no contact law means anything there, and the turning, which grows as the inverse
# square of the distance, would leave doubles less than the twelve digits that are promised.
NEAREST = 1e-3


@dataclass(frozen=True, slots=True)
class Pair:
    """B seen from A: `apart` (m) and `relative` velocity (m/s); they touch when closer than `reach` (the sum of the radii)."""

    mass_a: float
    mass_b: float
    apart: Vector
    relative: Vector
    reach: float
    contact: Contact

    @property
    def mass(self) -> float:
        """The reduced mass."""
        return self.mass_a / (self.mass_a + self.mass_b) * self.mass_b


@dataclass(frozen=True, slots=True)
class Touching:
    """The pair when it begins to touch (or at the start, if it does): B in direction `angle` from A.

    `inward` is the rate at which the overlap grows, `spin` the angular momentum per reduced mass (r times the speed across).
    """

    angle: float
    overlap: float
    inward: float
    spin: float
    after: float


@dataclass(frozen=True, slots=True)
class Parting:
    """The pair when it ceases to touch: turned by `turned` since it began, parting at the rate `outward`, with the spin left."""

    turned: float
    outward: float
    spin: float
    duration: float
    overlap: float
    force: float
    sticks: bool
    evaluations: int
    error_estimate: float = 2e-15


def meet(pair: Pair) -> Touching | None:
    """The beginning of the contact, found without a step: the root of a quadratic; none when they pass each other.

    None, too, for two at rest with so little overlap that no double holds the speed it gives them.
    """
    (x, y), (u, v) = pair.apart, pair.relative
    spin, radial, distance = x * v - y * u, x * u + y * v, math.hypot(x, y)
    if distance < pair.reach:
        if radial == 0.0 and spin == 0.0 and loaded_speed(pair, pair.reach - distance) == 0.0:
            return None
        return Touching(math.atan2(y, x), pair.reach - distance, -radial / distance, spin, 0.0)
    speed = math.hypot(u, v)
    # (D - b)(D + b) and not D^2 - b^2: a grazing hit keeps its digits.
    room = (pair.reach * speed - abs(spin)) * (pair.reach * speed + abs(spin))
    if radial >= 0.0 or room <= 0.0:
        return None
    root = math.sqrt(room)
    after = (distance - pair.reach) * (distance + pair.reach) / (-radial + root)
    # Along and across the relative velocity; not apart + relative * after, which loses digits on a long way.
    along, across = -root / speed, -spin / speed
    angle = math.atan2(along * v + across * u, along * u - across * v)
    return Touching(angle, 0.0, root / pair.reach, spin, after)


def loaded_speed(pair: Pair, overlap: float) -> float:
    """The speed (m/s) at which the contact throws two at rest apart; by a root of the energy, whose square may leave the doubles."""
    power = pair.contact.q + 1.0
    return math.sqrt(2.0 * pair.contact.k / power / pair.mass) * overlap ** (0.5 * power)


def after_parting(pair: Pair, met: Touching, parted: Parting) -> Vector:
    """The relative velocity of B once they are apart; zero when they stick."""
    if parted.sticks:
        return 0.0, 0.0
    angle, across = met.angle + parted.turned, parted.spin / pair.reach
    c, s = math.cos(angle), math.sin(angle)
    return parted.outward * c - across * s, parted.outward * s + across * c


def refuse_too_soft(overlap: float, reach: float) -> None:
    """Raises BadSetting when two spheres are so soft that their centres all but meet."""
    if overlap > (1.0 - NEAREST) * reach:
        raise BadSetting(
            "The spheres are so soft that they pass through each other; raise k, or lower the speed."
        )


def deepest(pair: Pair, met: Touching) -> float:
    """The largest overlap of an undamped contact that begins at zero: by Newton's method, kept in its bracket.

    Energy: inward^2 = 2 k x^(q+1) / ((q+1) mass) + spin^2 (1/(D-x)^2 - 1/D^2).
    """
    d, p = pair.reach, pair.contact.q + 1.0
    stiff, turning = 2.0 * pair.contact.k / (p * pair.mass), met.spin**2

    def lacking(x: float) -> float:
        r = d - x
        return stiff * x**p + turning * x * (d + r) / (r * r * d * d) - met.inward**2

    elastic = (met.inward**2 / stiff) ** (1.0 / p)
    low, high = 0.0, min(elastic, d)
    x = 0.5 * high if high == d else high
    for _ in range(200):
        r = d - x
        value = lacking(x)
        low, high = (x, high) if value < 0.0 else (low, x)
        slope = stiff * p * x ** (p - 1.0) + 2.0 * turning / r**3
        step = x - value / slope
        step = step if low < step < high else 0.5 * (low + high)
        if abs(step - x) <= 2e-16 * x:
            return step
        x = step
    return x


def oblique(pair: Pair, met: Touching) -> Parting:
    """The contact from its beginning to its end; by symmetry its second half mirrors the first.

    The square of the radial speed is written as a difference from its zero at the largest overlap, so no digits are lost there;
    with overlap = deepest sin(angle)^s the integrand is smooth. Raises BadSetting when the centres all but meet.
    """
    d, q = pair.reach, pair.contact.q
    depth = deepest(pair, met)
    refuse_too_soft(depth, d)
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

    half, error_estimate, spent = integral(lambda angle: at(angle)[0], 0.0, 0.5 * math.pi)
    turned, error_of_turn, spent_too = (
        integral(turning_rate, 0.0, 0.5 * math.pi) if met.spin else (0.0, 0.0, 0)
    )
    force = pair.contact.k * depth**q
    error_estimate = max(error_estimate, error_of_turn, 2e-15)
    return Parting(
        2.0 * turned, met.inward, met.spin, 2.0 * half, depth, force, False, spent + spent_too, error_estimate
    )
