"""Two bodies on a line with a coefficient of restitution, made by a spring with a dashpot between them (section 12.5)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING, collide
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.contact import Contact
from corollary.scenes.row import RowOfBodies, reduced_mass
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

    A spring with a dashpot lets go with r = exp(-pi z / sqrt(1 - z^2)), z its share of critical damping, whatever the masses and
    speeds; for r = 0 the damping is critical and the bodies stay together.
    """
    ma, mb, va, vb, r, k = (one(settings, name) for name in ("mA", "mB", "vA", "vB", "r", "k"))
    log = -math.log(r) if r else math.inf
    share = log / math.hypot(math.pi, log) if r else 1.0
    eta = 2.0 * share * math.sqrt(k * reduced_mass(ma, mb)) * (1.0 if r else 1.0 + 1e-9)
    found = collide(RowOfBodies((ma, mb), (va, vb), (0.0,), (Contact(k, 1.0, eta),)), tolerance)
    result = found.result
    a, b = result.velocities
    before = ma * va * va + mb * vb * vb
    observed: dict[str, Observed] = {
        "velocities": (a, b),
        "duration": result.duration,
        "peak_force": result.forces[0],
        "largest_overlap": result.overlaps[0],
        "impulse": mb * (b - vb),
        "energy_ratio": (ma * a * a + mb * b * b) / before if before else 1.0,
    }
    of = {"duration": "duration", "peak_force": "forces", "largest_overlap": "overlaps"}
    errors = {name: found.errors.get(of.get(name, "velocities"), ROUNDING) for name in observed}
    return Run(observed, errors, found.model, found.why, found.spent, result.outcome)


SCENE = SceneDefinition("two bodies on a line with a coefficient of restitution", SETTINGS, play)
