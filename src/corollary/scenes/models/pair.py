"""Two spheres seen from one of them: where they meet, an undamped contact as two rigorous integrals, and what becomes of both."""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import acb, arb

from corollary.formula.ball import MOST_BITS, precision_of
from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.integrate.contact_motion import NEAREST
from corollary.scenes.models.certain import (
    FIRST_BITS,
    MoreDigits,
    double_of,
    geometric,
    integral,
    root,
    sign,
)
from corollary.scenes.run import BadSetting, GuardFailed

Vector = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Pair:
    """B seen from A: `apart` (m) and `relative` velocity (m/s); they touch when closer than `reach` (the sum of the radii).

    `exact_velocities` are those of A and B where their difference, rounded, is not enough.
    """

    mass_a: float
    mass_b: float
    apart: Vector
    relative: Vector
    reach: float
    contact: Contact
    exact_velocities: tuple[Vector, Vector] | None = None

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


def meet(pair: Pair) -> Touching | None:
    """The beginning of the contact, found without a step: the root of a quadratic; none when they pass each other.

    None, too, for two at rest with so little overlap that no double holds the speed it gives them.
    """
    bits = FIRST_BITS
    while bits <= MOST_BITS:
        with precision_of(bits):
            try:
                met = touch(pair)
            except MoreDigits:
                bits *= 2
                continue
            numbers = (
                None
                if met is None
                else [float(each) for each in (met.angle(), met.overlap, met.inward, met.spin, met.after)]
            )
            break
    else:
        raise GuardFailed(
            "Two spheres that graze each other by less than any digits tell; move one of them a little."
        )
    if numbers is None:
        return None
    if not all(map(math.isfinite, numbers)):
        raise OverflowError
    found = Touching(*numbers)
    at_rest = found.overlap > 0.0 and found.inward == 0.0 and found.spin == 0.0
    return None if at_rest and loaded_speed(pair, found.overlap) == 0.0 else found


@dataclass(frozen=True, slots=True)
class Touch:
    """As Touching, in balls; the direction as a vector."""

    direction: tuple[arb, arb]
    overlap: arb
    inward: arb
    spin: arb
    after: arb

    def angle(self) -> arb:
        return arb.atan2(self.direction[1], self.direction[0])


def touch(pair: Pair) -> Touch | None:
    """The beginning of the contact in balls: what doubles are given is exact, and so is whether they meet. Raises MoreDigits."""
    (x, y), (u, v) = ((arb(a), arb(b)) for a, b in (pair.apart, pair.relative))
    if pair.exact_velocities is not None:
        (ua, va), (ub, vb) = pair.exact_velocities
        u, v = arb(ub) - arb(ua), arb(vb) - arb(va)
    reach = arb(pair.reach)
    spin, radial, square, speed = x * v - y * u, x * u + y * v, x * x + y * y, u * u + v * v
    if sign(square - reach * reach) < 0:
        distance = square.sqrt()
        return Touch((x, y), reach - distance, -radial / distance, spin, arb(0))
    room = reach * reach * speed - spin * spin
    if sign(radial) >= 0 or sign(room) <= 0:
        return None
    root_of_room = room.sqrt()
    after = (square - reach * reach) / (root_of_room - radial)
    # Along and across the relative velocity.
    along, across = -root_of_room, -spin
    return Touch((along * u - across * v, along * v + across * u), arb(0), root_of_room / reach, spin, after)


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
    """The largest overlap (m) of an undamped contact that begins at zero; the whole reach where the centres meet."""
    return double_of(lambda: _deepest(pair, arb(met.inward), arb(met.spin)))


def _deepest(pair: Pair, inward: arb, spin: arb) -> arb:
    """The root x of inward^2 = 2 k x^(q+1) / ((q+1) mass) + spin^2 (1/(D-x)^2 - 1/D^2)."""
    d, p = arb(pair.reach), arb(pair.contact.q) + 1
    stiff, turning = 2 * arb(pair.contact.k) / (p * reduced_mass(pair)), spin * spin
    high = (inward * inward / stiff) ** (1 / p)
    nearest = d * (1 - arb(2) ** -20)
    if not sign(turning):
        return high if high < nearest else d
    # Each term alone bounds the root; at an eighth of the least bound both together are still below the left side.
    high = high.min(inward * inward * d**3 / (2 * turning)).min(nearest)

    def lacking(x: arb) -> arb:
        r = d - x
        return stiff * x**p + turning * x * (d + r) / (r * r * d * d) - inward * inward

    most = (2 * high.upper()).min(nearest)
    return root(lacking, high.lower() / 8, most) if lacking(most) > 0 else d


def reduced_mass(pair: Pair) -> arb:
    """The reduced mass, in balls."""
    return 1 / (1 / arb(pair.mass_a) + 1 / arb(pair.mass_b))


def oblique(pair: Pair, met: Touching) -> Parting:
    """An undamped contact from its beginning to its end, as doubles. Raises BadSetting when the centres all but meet."""
    overlap, turned, duration = (
        double_of(lambda i=i: turned_and_lasted(pair, arb(met.inward), arb(met.spin))[i]) for i in range(3)
    )
    refuse_too_soft(overlap, pair.reach)
    force = pair.contact.k * overlap**pair.contact.q
    return Parting(turned, met.inward, met.spin, duration, overlap, force, False, 0)


def turned_and_lasted(pair: Pair, inward: arb, spin: arb) -> tuple[arb, arb, arb]:
    """The largest overlap, the angle turned by the line of centres, and the duration of an undamped contact.

    With overlap = X w^s and w = 1 - y^2 the square of the radial speed is y^2 times a sum of positive terms: nothing cancels, and
    the integrands are smooth at the largest overlap X and at the touch. By symmetry the second half mirrors the first.
    """
    d, q, s = arb(pair.reach), pair.contact.q, max(smoothing_power(pair.contact), 2)
    top = _deepest(pair, inward, spin)
    refuse_too_soft(float(top), pair.reach)
    near = acb(d - top)
    stiff = acb(2 * arb(pair.contact.k) / ((arb(q) + 1) * reduced_mass(pair)) * top ** (arb(q) + 1))
    turning = acb(spin * spin * top)

    def pace(y: acb, analytic: bool) -> tuple[acb, acb]:
        """dt / dy over 4 s X, and the distance of the centres."""
        w = 1 - y * y
        r = d - top * w**s
        rate = stiff * geometric(w, s * (q + 1.0), analytic)
        rate += turning * geometric(w, float(s), analytic) * (r + near) / (near * near * r * r)
        return w ** (s - 1) / rate.sqrt(analytic=analytic), r

    def turning_rate(y: acb, analytic: bool) -> acb:
        rate, r = pace(y, analytic)
        return rate / (r * r)

    lasted = 4 * s * top * integral(lambda y, analytic: pace(y, analytic)[0], arb(0), arb(1))
    turned = 4 * s * top * spin * integral(turning_rate, arb(0), arb(1)) if sign(spin) else arb(0)
    return top, turned, lasted
