"""Two bodies on a line with a coefficient of restitution, made by a spring with a dashpot between them (section 12.5)."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.forces.contact import Contact
from corollary.scenes.line_collision import collide
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.models.two_bodies import FADES, Hit, after, fading, missed
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import ROUNDING, Observed, Run

SETTINGS = (
    Setting("mA", "mass of A, on the left", "kg", 2.0, above=0.0),
    Setting("mB", "mass of B", "kg", 3.0, above=0.0),
    Setting("vA", "velocity of A before", "m/s", 5.0),
    Setting("vB", "velocity of B before", "m/s", -1.0),
    Setting("r", "coefficient of restitution", "1", 0.6, least=0.0, most=1.0),
    Setting("k", "spring constant of the contact", "N/m", 1e6, above=0.0),
)


def _evaluated(a: Ball, b: Ball, u: Ball, v: Ball, r: Ball, k: Ball) -> Evaluated:
    """Velocities after the contact, the impulse on B, and what is left of the kinetic energy.

    A spring with a dashpot lets go with r = exp(-pi fade), where the swing fades by exp(-fade) while it turns by one radian,
    whatever the masses and speeds; for r = 0 the damping is critical and the bodies stay together.
    """
    masses, velocities, closing = (float(a), float(b)), (float(u), float(v)), u - v
    hit = _hit(r, k, 1 / (1 / a + 1 / b), closing) if closing > 0 else None
    seen = after(masses, velocities, hit, FADES, FADES) if hit else missed(masses, velocities)
    names = ("velocities", "duration", "peak_force", "largest_overlap", "energy_ratio")
    values = {name: seen.values[name] for name in names if name in seen.values}
    impulses = seen.values["impulse"]
    assert isinstance(impulses, tuple)
    return replace(seen, values=values | {"impulse": impulses[1]})


def _hit(r: Ball, k: Ball, mass: Ball, closing: Ball) -> Hit:
    if r > 0:
        return replace(fading(mass, k, -r.log() / Ball.pi(), closing), restitution=r)
    # Critical damping: x = closing t exp(-w t), pushed hardest at the touch.
    w = (k / mass).sqrt()
    return Hit(Ball(0), closing / w * Ball(-1).exp(), 2 * (k * mass).sqrt() * closing, None)


def second_way(settings: Settings, tolerance: float) -> Run:
    ma, mb, va, vb, r, k = numbers(settings, "mA", "mB", "vA", "vB", "r", "k")
    log = -math.log(r) if r else math.inf
    share = log / math.hypot(math.pi, log) if r else 1.0 + 1e-9
    eta = 2.0 * share * math.sqrt(k * ma / (ma + mb) * mb)
    found = collide(RowOfBodies((ma, mb), (va, vb), (0.0,), (Contact(k, 1.0, eta),)), tolerance)
    a, b = found.result.velocities
    values: dict[str, Observed] = {"velocities": (a, b), "impulse": mb * (b - vb)}
    fastest = max(map(abs, (va, vb, a, b)))
    # Rounding alone moves bodies that never meet.
    errors = dict.fromkeys(values, found.errors.get("velocities", ROUNDING))
    return found.observed(values, {"velocities": fastest, "impulse": mb * fastest}, errors)


SCENE = by_formulas(
    "two bodies on a line with a coefficient of restitution", SETTINGS, _evaluated, second_way=second_way
)
