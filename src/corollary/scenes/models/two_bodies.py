"""Two bodies on a line, one contact from a touch to its end.

Undamped by conservation and Beta functions, or with weight by a root of the energy and a rigorous quadrature; or a spring with a dashpot.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import arb

from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.certain import Balls, Evaluated, double_of, sign
from corollary.scenes.run import NEVER_PART, Model, Outcome

CONSERVED = "momentum and energy give what two bodies have after an undamped collision"
BETA = "two bodies, no damping: Beta functions close the energy integral"
FADES = "a spring with a dashpot: the swing fades as it goes, which is known exactly"
APART = "the bodies never meet"


@dataclass(frozen=True, slots=True)
class Hit:
    """One contact in balls: `restitution` is the speed of parting over that of meeting; `duration` (s) is none for bodies that stick."""

    restitution: arb
    overlap: arb
    force: arb
    duration: arb | None


def inverse(mass: float) -> arb:
    """One over a mass; zero for a wall."""
    return arb(0) if math.isinf(mass) else 1 / arb(mass)


def undamped(mass: arb, k: arb, q: arb, closing: arb) -> Hit:
    """A (reduced) mass that meets k overlap^q: m v^2 / 2 = k overlap^(q+1) / (q+1), and Beta functions close dt = dx / speed."""
    part = 1 / (q + 1)
    overlap = ((q + 1) * mass * closing * closing / (2 * k)) ** part
    factor = 2 * arb.pi().sqrt() * (1 + part).gamma() / (part + arb(0.5)).gamma()
    return Hit(arb(1), overlap, k * overlap**q, factor * overlap / closing)


def damped(mass: arb, k: arb, eta: arb, closing: arb, swings: int) -> Hit:
    """A (reduced) mass that meets a spring k and a dashpot eta: m x'' = -k x - eta x' until x is zero again.

    `swings` is 1 below critical damping, 0 at it, -1 above; from there on x never returns.
    """
    half = eta / (2 * mass)
    slow = abs(k / mass - half * half).sqrt()
    if swings > 0:
        return fading(mass, k, half / slow, closing)
    # The top is where the rate is zero.
    top = (slow / (k / mass).sqrt()).asinh() / slow if swings else 1 / half
    return Hit(arb(0), closing / (k / mass).sqrt() * (-half * top).exp(), eta * closing, None)


def fading(mass: arb, k: arb, fade: arb, closing: arb) -> Hit:
    """The same below critical damping; `fade` is how much the swing fades (in powers of e) while it turns by one radian."""
    frequency = (k / mass).sqrt()
    slower = (1 + fade * fade).sqrt()
    turned = (1 / fade).atan() if sign(fade) else arb.pi() / 2
    force = closing * (k * mass).sqrt()
    # The force swings three times as far ahead as the damping shifts the swing: from half the critical damping on it is largest at the touch.
    ahead = arb.pi() / 2 - 3 * fade.atan()
    peak = force * (-fade * ahead).exp() if ahead > 0 else arb(0)
    return Hit(
        (-arb.pi() * fade).exp(),
        closing / frequency * (-fade * turned).exp(),
        peak.max(2 * fade / slower * force),
        arb.pi() * slower / frequency,
    )


def largest_overlap(m: float, k: float, q: float, v: float) -> float:
    """The overlap (m) at which k overlap^q has stopped a (reduced) mass m that arrived at speed v."""
    return double_of(lambda: undamped(arb(m), arb(k), arb(q), arb(v)).overlap)


def contact_time(m: float, k: float, q: float, v: float) -> float:
    """How long (s) a (reduced) mass m touches when it arrives at speed v and is pushed back by k overlap^q."""
    return double_of(lambda: undamped(arb(m), arb(k), arb(q), arb(v)).duration or arb(0))


def collision(masses: tuple[float, float], velocities: tuple[float, float], contact: Contact) -> Evaluated:
    """Everything that can be observed of two bodies of which nothing else acts on either; they touch or come to a touch first."""
    given = inverse(masses[0]), inverse(masses[1])
    u, v = arb(velocities[0]), arb(velocities[1])
    closing = u - v
    if sign(closing) <= 0:
        return missed(masses, velocities)
    mass, k = 1 / (given[0] + given[1]), arb(contact.k)
    if contact.eta > 0.0:
        hit = damped(mass, k, arb(contact.eta), closing, swings(masses, contact))
        return after(masses, velocities, hit, FADES, FADES)
    return after(masses, velocities, undamped(mass, k, arb(contact.q), closing), CONSERVED, BETA)


def swings(masses: tuple[float, float], contact: Contact) -> int:
    """The sign of 4 k mu - eta^2, written without a quotient so that critical damping is told exactly."""
    loose = [arb(m) for m in masses if not math.isinf(m)]
    product, total = (loose[0] * loose[1], loose[0] + loose[1]) if len(loose) == 2 else (loose[0], arb(1))
    return sign(4 * arb(contact.k) * product - arb(contact.eta) ** 2 * total)


def missed(masses: tuple[float, float], velocities: tuple[float, float]) -> Evaluated:
    """Two bodies that never meet."""
    before = arb(velocities[0]), arb(velocities[1])
    nothing = Hit(arb(0), arb(0), arb(0), arb(0))
    return _evaluated("missed", masses, before, before, nothing, APART, APART)


def after(
    masses: tuple[float, float], velocities: tuple[float, float], hit: Hit, why: str, why_contact: str
) -> Evaluated:
    """What a contact makes of two bodies."""
    a, b = inverse(masses[0]), inverse(masses[1])
    u, v = arb(velocities[0]), arb(velocities[1])
    impulse = (1 + hit.restitution) * (u - v) / (a + b)
    outcome: Outcome = "sticks" if hit.duration is None else "released"
    return _evaluated(outcome, masses, (u, v), (u - a * impulse, v + b * impulse), hit, why, why_contact)


def _evaluated(
    outcome: Outcome,
    masses: tuple[float, float],
    before: tuple[arb, arb],
    then: tuple[arb, arb],
    hit: Hit,
    why: str,
    why_contact: str,
) -> Evaluated:
    loose = [(arb(m), u, v) for m, u, v in zip(masses, before, then, strict=True) if not math.isinf(m)]
    had = sum((m * u * u / 2 for m, u, _ in loose), arb(0))
    has = sum((m * v * v / 2 for m, _, v in loose), arb(0))
    values: dict[str, Balls] = {
        "velocities": then,
        "impulse": tuple(m * (v - u) for m, u, v in loose),
        "momentum": (sum((m * v for m, _, v in loose), arb(0)),),
        "energy": has,
        "energy_ratio": has / had if sign(had) else arb(1),
        "largest_overlap": hit.overlap,
        "peak_force": hit.force,
    }
    if hit.duration is not None:
        values["duration"] = hit.duration
    of_the_contact = dict.fromkeys(("largest_overlap", "peak_force", "duration"), why_contact)
    model: Model = "conservation" if why in (CONSERVED, APART) else "piecewise exact"
    dearer: Model = model if why_contact != BETA else "quadrature"
    by: dict[str, tuple[Model, str]] = {name: (dearer, each) for name, each in of_the_contact.items()}
    return Evaluated(outcome, values, model, why, by, () if hit.duration is not None else (NEVER_PART,))
