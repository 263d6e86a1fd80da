"""Two spheres seen from one of them: where they meet, an undamped contact as two rigorous integrals, and what is observed."""

from __future__ import annotations

import math
from dataclasses import astuple, dataclass
from fractions import Fraction

from flint import acb, arb

from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.integrate.contact_motion import NEAREST
from corollary.scenes.models.certain import (
    Balls,
    Evaluated,
    decided,
    double_of,
    geometric,
    integral,
    root,
    sign,
)
from corollary.scenes.models.two_bodies import undamped
from corollary.scenes.run import BadSetting, Model, Outcome

Vector = tuple[float, float]
PASS = "the spheres pass each other"
NO_DAMPING = "no damping: energy and angular momentum of the pair leave two integrals"
CONSERVATION: tuple[Model, str] = "conservation", "no damping: momentum and energy are as at the start"


@dataclass(frozen=True, slots=True)
class Pair:
    """Spheres A and B: B seen from A is `apart` (m), `velocities` (m/s) are of both; they touch closer than `reach`, the sum of the radii."""

    mass_a: float
    mass_b: float
    apart: Vector
    velocities: tuple[Vector, Vector]
    reach: float
    contact: Contact

    @property
    def mass(self) -> float:
        """The reduced mass."""
        return self.mass_a / (self.mass_a + self.mass_b) * self.mass_b

    @property
    def relative(self) -> Vector:
        """The velocity of B seen from A, rounded."""
        (ua, va), (ub, vb) = self.velocities
        return ub - ua, vb - va


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

    def in_doubles() -> Touching | None:
        met = touch(pair)
        if met is None:
            return None
        angle = arb.atan2(met.direction[1], met.direction[0])
        return Touching(*map(float, (angle, met.overlap, met.inward, met.spin, met.after)))

    found = decided(
        in_doubles,
        "Two spheres that graze each other by less than any digits tell; move one of them a little.",
    )
    if found is None:
        return None
    if not all(map(math.isfinite, astuple(found))):
        raise OverflowError
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


def touch(pair: Pair) -> Touch | None:
    """The beginning of the contact in balls: what doubles are given is exact, and so is whether they meet. Raises MoreDigits."""
    (x, y), (ua, va), (ub, vb) = (map(arb, each) for each in (pair.apart, *pair.velocities))
    u, v, reach = ub - ua, vb - va, arb(pair.reach)
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


def turned_and_lasted(pair: Pair, inward: arb, spin: arb) -> tuple[arb, arb, arb]:
    """The largest overlap, the angle turned by the line of centres, and the duration of an undamped contact.

    With overlap = X w^s and w = 1 - y^2 the square of the radial speed is y^2 times a sum of positive terms: nothing cancels, and
    the integrands are smooth at the largest overlap X and at the touch. By symmetry the second half mirrors the first. Head-on it is Beta
    functions.
    """
    d, q, s = arb(pair.reach), pair.contact.q, max(smoothing_power(pair.contact), 2)
    top = _deepest(pair, inward, spin)
    refuse_too_soft(float(top), pair.reach)
    if not sign(spin):
        hit = undamped(reduced_mass(pair), arb(pair.contact.k), arb(q), inward)
        assert hit.duration is not None
        return top, arb(0), hit.duration
    near = acb(d - top)
    stiff = acb(2 * arb(pair.contact.k) / ((arb(q) + 1) * reduced_mass(pair)) * top ** (arb(q) + 1))
    turning = acb(spin * spin * top)

    def pace(y: acb, analytic: bool) -> tuple[acb, acb]:
        """dt / dy over 4 s X, and the distance of the centres."""
        w = 1 - y * y
        r = d - top * w**s
        rate = stiff * geometric(w, s * (Fraction(q) + 1), analytic)
        rate += turning * geometric(w, Fraction(s), analytic) * (r + near) / (near * near * r * r)
        return w ** (s - 1) / rate.sqrt(analytic=analytic), r

    def turning_rate(y: acb, analytic: bool) -> acb:
        rate, r = pace(y, analytic)
        return rate / (r * r)

    lasted = 4 * s * top * integral(lambda y, analytic: pace(y, analytic)[0], arb(0), arb(1))
    return top, 4 * s * top * spin * integral(turning_rate, arb(0), arb(1)), lasted


def collision(pair: Pair) -> Evaluated:
    """Everything observed of two spheres that meet from outside without damping, or pass each other.

    Raises BadSetting when the centres all but meet, MoreDigits for more digits.
    """
    met, no = touch(pair), arb(0)
    if met is None:
        return _observed(pair, "missed", (no, no), (no, no, no), PASS, "conservation")
    top, turned, lasted = turned_and_lasted(pair, met.inward, met.spin)
    contact = top, arb(pair.contact.k) * top ** arb(pair.contact.q), lasted
    c, s = turned.cos(), turned.sin()
    x, y = met.direction
    length = (x * x + y * y).sqrt()
    nx, ny = (x * c - y * s) / length, (x * s + y * c) / length
    across, (a, b) = met.spin / arb(pair.reach), _before(pair)
    u, v = b[0] - a[0], b[1] - a[1]
    change = met.inward * nx - across * ny - u, met.inward * ny + across * nx - v
    return _observed(pair, "released", change, contact, NO_DAMPING, "quadrature")


def _before(pair: Pair) -> list[tuple[arb, ...]]:
    return [tuple(map(arb, each)) for each in pair.velocities]


def _observed(
    pair: Pair,
    outcome: Outcome,
    change: tuple[arb, arb],
    contact: tuple[arb, arb, arb],
    why: str,
    model: Model,
) -> Evaluated:
    (ma, mb), mass, (a, b) = (arb(pair.mass_a), arb(pair.mass_b)), reduced_mass(pair), _before(pair)
    impulse = tuple(mass * c for c in change)
    then_a = tuple(v - j / ma for v, j in zip(a, impulse, strict=True))
    then_b = tuple(v + j / mb for v, j in zip(b, impulse, strict=True))
    # An elastic contact gives back what it took, whatever the quadratures say.
    energy = (ma * (a[0] * a[0] + a[1] * a[1]) + mb * (b[0] * b[0] + b[1] * b[1])) / 2
    values: dict[str, Balls] = {
        "velocities": (*then_a, *then_b),
        "duration": contact[2],
        "largest_overlap": contact[0],
        "peak_force": contact[1],
        "impulse": impulse,
        "impulses": (-impulse[0], -impulse[1], *impulse),
        "momentum": tuple(ma * p + mb * q for p, q in zip(a, b, strict=True)),
        "energy": energy,
        "energy_ratio": arb(1),
    }
    by: dict[str, tuple[Model, str]] = dict.fromkeys(("energy_ratio", "momentum", "energy"), CONSERVATION)
    return Evaluated(outcome, values, model, why, by)
