"""Two bodies on a line with a coefficient of restitution, made by a spring with a dashpot between them (section 12.5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.certain import Evaluated, balls, found
from corollary.scenes.models.two_bodies import FADES, Hit, after, fading, inverse, missed
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("mA", "mass of A, on the left", "kg", 2.0, above=0.0),
    Setting("mB", "mass of B", "kg", 3.0, above=0.0),
    Setting("vA", "velocity of A before", "m/s", 5.0),
    Setting("vB", "velocity of B before", "m/s", -1.0),
    Setting("r", "coefficient of restitution", "1", 0.6, least=0.0, most=1.0),
    Setting("k", "spring constant of the contact", "N/m", 1e6, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocities after the contact, the impulse on B, and what is left of the kinetic energy.

    A spring with a dashpot lets go with r = exp(-pi fade), where the swing fades by exp(-fade) while it turns by one radian,
    whatever the masses and speeds; for r = 0 the damping is critical and the bodies stay together.
    """
    return found(lambda: _evaluated(settings))


def _evaluated(settings: Mapping[str, Observed]) -> Evaluated:
    ma, mb, va, vb = (one(settings, name) for name in ("mA", "mB", "vA", "vB"))
    r, k = balls(settings, "r", "k")
    closing = Ball(va) - Ball(vb)
    mass = 1 / (inverse(ma) + inverse(mb))
    seen = (
        after((ma, mb), (va, vb), _hit(r, k, mass, closing), FADES, FADES)
        if closing > 0
        else missed((ma, mb), (va, vb))
    )
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


SCENE = SceneDefinition("two bodies on a line with a coefficient of restitution", SETTINGS, play)
