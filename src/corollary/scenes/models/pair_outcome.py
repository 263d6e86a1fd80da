"""What two spheres that have met, or passed each other, are observed to do."""

from __future__ import annotations

from flint import arb

from corollary.scenes.models.certain import Balls, Evaluated
from corollary.scenes.models.pair import Pair, Touch, Vector, reduced_mass, touch, turned_and_lasted
from corollary.scenes.run import Model, Outcome

PASS = "the spheres pass each other"
NO_DAMPING = "no damping: energy and angular momentum of the pair leave two integrals"
CONSERVATION: tuple[Model, str] = "conservation", "no damping: momentum and energy are as at the start"


def collision(pair: Pair, va: Vector, vb: Vector) -> Evaluated:
    """Everything observed of two spheres that meet from outside without damping, or pass each other; `va`, `vb` are their velocities.

    Raises BadSetting when the centres all but meet, MoreDigits for more digits.
    """
    a, b = tuple(map(arb, va)), tuple(map(arb, vb))
    met = touch(pair)
    if met is None:
        return _observed(
            pair, "missed", (a, b), (arb(0), arb(0)), (arb(0), arb(0), arb(0)), PASS, "conservation", True
        )
    top, turned, lasted = turned_and_lasted(pair, met.inward, met.spin)
    force = arb(pair.contact.k) * top ** arb(pair.contact.q)
    parting = turned, met.inward, met.spin
    return after_contact(pair, met, (a, b), parting, (top, force, lasted), NO_DAMPING)


def after_contact(
    pair: Pair,
    met: Touch,
    before: tuple[tuple[arb, ...], tuple[arb, ...]],
    parting: tuple[arb, arb, arb],
    contact: tuple[arb, arb, arb],
    why: str,
) -> Evaluated:
    """What is observed of two spheres that part: having turned by an angle, at a rate outward, with a spin.

    `before` are their velocities, `contact` the largest overlap, the largest force and the duration.
    """
    turned, outward, spin = parting
    c, s = turned.cos(), turned.sin()
    x, y = met.direction
    length = (x * x + y * y).sqrt()
    nx, ny = (x * c - y * s) / length, (x * s + y * c) / length
    across, (a, b) = spin / arb(pair.reach), before
    u, v = b[0] - a[0], b[1] - a[1]
    change = outward * nx - across * ny - u, outward * ny + across * nx - v
    # One that begins squeezed gives more than it took.
    elastic = pair.contact.eta == 0.0 and met.overlap.is_zero()
    model: Model = "quadrature" if elastic else "integration"
    return _observed(pair, "released", before, change, contact, why, model, elastic)


def _observed(
    pair: Pair,
    outcome: Outcome,
    before: tuple[tuple[arb, ...], tuple[arb, ...]],
    change: tuple[arb, arb],
    contact: tuple[arb, arb, arb],
    why: str,
    model: Model,
    elastic: bool,
) -> Evaluated:
    (ma, mb), mass, (a, b) = (arb(pair.mass_a), arb(pair.mass_b)), reduced_mass(pair), before
    impulse = tuple(mass * c for c in change)
    then_a = tuple(v - j / ma for v, j in zip(a, impulse, strict=True))
    then_b = tuple(v + j / mb for v, j in zip(b, impulse, strict=True))
    had, has = (
        (ma * (p[0] ** 2 + p[1] ** 2) + mb * (q[0] ** 2 + q[1] ** 2)) / 2
        for p, q in ((a, b), (then_a, then_b))
    )
    # An elastic contact gives back what it took, whatever the quadratures say.
    if elastic:
        has = had
    values: dict[str, Balls] = {
        "velocities": (*then_a, *then_b),
        "duration": contact[2],
        "largest_overlap": contact[0],
        "peak_force": contact[1],
        "impulse": impulse,
        "impulses": (-impulse[0], -impulse[1], *impulse),
        "momentum": tuple(ma * p + mb * q for p, q in zip(a, b, strict=True)),
        "energy": has,
    }
    if elastic or not had.is_zero():  # two at rest have no energy to compare with
        values["energy_ratio"] = arb(1) if elastic else has / had
    conserved = ("energy_ratio", "momentum", "energy") if elastic else ()
    return Evaluated(outcome, values, model, why, dict.fromkeys(conserved, CONSERVATION))
