"""One undamped contact of a body that weight pulls on: its deepest point is a root of the energy, its duration a rigorous quadrature."""

from __future__ import annotations

from fractions import Fraction

from flint import acb, acb_poly, arb

from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.models.certain import double_of, geometric, integral, root
from corollary.scenes.models.two_bodies import Hit, undamped


def largest_overlap(m: float, k: float, q: float, v: float) -> float:
    """The overlap (m) at which k overlap^q has stopped a (reduced) mass m that arrived at speed v."""
    return double_of(lambda: undamped(arb(m), arb(k), arb(q), arb(v)).overlap)


def contact_time(m: float, k: float, q: float, v: float) -> float:
    """How long (s) a (reduced) mass m touches when it arrives at speed v and is pushed back by k overlap^q."""
    return double_of(lambda: undamped(arb(m), arb(k), arb(q), arb(v)).duration or arb(0))


def depth_of(contact: Contact, m: float, v: float, g: float) -> float:
    """The largest overlap (m) without damping, as a double; with weight where there is some."""
    if g == 0.0:
        return largest_overlap(m, contact.k, contact.q, v)
    return double_of(lambda: deepest(contact, arb(m), arb(v), arb(g)))


def deepest(contact: Contact, mass: arb, speed: arb, weight: arb) -> arb:
    """The overlap where a body that meets the floor at `speed` and is pulled on by `weight` (m/s^2) comes to rest.

    speed^2 + 2 g x = 2 k x^(q+1) / ((q+1) m): the root lies between the larger of those without either term on the left and its double.
    """
    p = arb(contact.q) + 1
    stiff = 2 * arb(contact.k) / (p * mass)
    unit = ((speed * speed / stiff) ** (1 / p)).max((2 * weight / stiff) ** (1 / arb(contact.q)))
    unit = unit.lower()

    def lacking(x: arb) -> arb:
        return stiff * x**p - 2 * weight * x - speed * speed

    return root(lacking, unit / 2, 2 * unit)


def bounce(contact: Contact, mass: arb, speed: arb, weight: arb) -> Hit:
    """The contact of a body that meets the floor at `speed` (> 0) and feels `weight` (> 0) meanwhile.

    With x = X w^s and w = 1 - y^2, the square of the speed is y^2 times a sum of powers of w with positive coefficients: nothing
    cancels, and the integrand is smooth at the deepest point X and at the touch.
    """
    s, q = max(smoothing_power(contact), 2), contact.q
    top = deepest(contact, mass, speed, weight)
    square, fall = acb(speed * speed), acb(2 * weight * top)

    powers = s * (Fraction(q) + 1), s * Fraction(q)
    whole = powers[0].denominator == 1
    sums = acb_poly([square] * round(powers[0])) + acb_poly([0] * s + [fall] * round(powers[1]))

    def per_y(y: acb, analytic: bool) -> acb:
        w = 1 - y * y
        if whole:
            rate = sums(w)
        else:
            rate = square * geometric(w, powers[0], analytic)
            rate += fall * w**s * geometric(w, powers[1], analytic)
        return w ** (s - 1) / rate.sqrt(analytic=analytic)

    duration = 4 * s * top * integral(per_y, arb(0), arb(1))
    return Hit(arb(1), top, arb(contact.k) * top ** arb(q), duration)
