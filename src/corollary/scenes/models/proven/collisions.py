"""Collisions of bodies whose motion no formula gives, from settings to values with proven bounds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from flint import arb

from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.certain import Evaluated, sign
from corollary.scenes.models.pair import Pair, after_contact, reduced_mass, touch
from corollary.scenes.models.proven import follow
from corollary.scenes.models.proven.laws import PairLaw, RowLaw
from corollary.scenes.models.proven.step import State
from corollary.scenes.models.two_bodies import Hit

PRECISIONS = (144, 224)
"""Bits. A motion loses about as many on its way as it has to spare beyond a double; what the second ones do not tell is stated as it is."""
WHY = "Taylor polynomials in balls, each with a bound on what it leaves out (Picard, Cauchy)"


def row(
    masses: Sequence[float], velocities: Sequence[float], gaps: Sequence[float], k: float, q: float
) -> Evaluated:
    """Undamped bodies in a row, the first of which comes in. All in units of its mass and speed, and of how deep it would go alone."""
    mass, speed = arb(masses[0]), arb(velocities[0])
    length = (mass * speed * speed / k) ** (1 / (arb(q) + 1))
    law = RowLaw(tuple(mass / m for m in masses), arb(1), arb(q))
    start = State(
        tuple(v / speed for v in map(arb, velocities)), tuple(-gap / length for gap in map(arb, gaps))
    )
    seen = follow.row(law, start)
    deepest = reduce(arb.max, seen.overlaps, arb(0))
    values: dict[str, arb | tuple[arb, ...]] = {
        "velocities": tuple(speed * v for v in seen.state.speeds),
        "largest_overlap": length * deepest,
        "peak_force": mass * speed * speed / length * deepest ** arb(q),
    }
    if seen.began is None or seen.ended is None:
        return Evaluated("missed", values | {"duration": arb(0)}, "integration", WHY)
    duration = (seen.ended - seen.began) * length / speed
    return Evaluated("released", values | {"duration": duration}, "integration", WHY)


def spheres(pair: Pair, depth: float, speed: float) -> Evaluated:
    """Two spheres in a plane that meet, with or without damping; `depth` and `speed` are units of about the right size."""
    met, contact = touch(pair), pair.contact
    assert met is not None
    turns = bool(sign(met.spin))  # head-on nothing does, and what is zero stays it
    mass, d, v = reduced_mass(pair), arb(depth), arb(speed)
    law = PairLaw(
        inverse=arb(1),
        k=contact.k * d ** (arb(contact.q) + 1) / (mass * v * v),
        q=arb(contact.q),
        eta=contact.eta * d / (mass * v),
        reach=pair.reach / d if turns else None,
        weight=arb(0),
    )
    seen = follow.pair(law, State((met.inward / v, met.spin / (d * v)), (met.overlap / d, arb(0))))
    assert seen.ended is not None
    (rate, spin), turned = seen.state.speeds, seen.state.places[1]
    if not turns:
        spin = turned = arb(0)
    force = seen.force_square.sqrt() * mass * v * v / d
    contact_values = seen.overlaps[0] * d, force, seen.ended * d / v
    return after_contact(pair, met, (turned, -rate * v, spin * d * v), contact_values, WHY)


def on_a_floor(mass: float, contact: Contact, speed: arb, g: float, depth: float) -> Hit:
    """A ball that meets a floor whose contact is damped, until it leaves it again; `depth` is a unit of about the right size."""
    m, d = arb(mass), arb(depth)
    law = PairLaw(
        inverse=arb(1),
        k=contact.k * d ** (arb(contact.q) + 1) / (m * speed * speed),
        q=arb(contact.q),
        eta=contact.eta * d / (m * speed),
        reach=None,
        weight=g * d / (speed * speed),
    )
    seen = follow.pair(law, State((arb(1), arb(0)), (arb(0), arb(0))))
    assert seen.ended is not None
    force = seen.force_square.sqrt() * m * speed * speed / d
    return Hit(-seen.state.speeds[0], seen.overlaps[0] * d, force, seen.ended * d / speed)
