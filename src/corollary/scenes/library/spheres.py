"""Two spheres collide in a plane: contact force k overlap^q between the centres, drag on the relative velocity (12.6)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition, Setting, one, row
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.pair import Pair, Parting, Touching, after_parting, meet, oblique
from corollary.scenes.run import BadSetting, GuardFailed, Observed, Run

SETTINGS = (
    Setting("mA", "mass of A", "kg", 0.1, above=0.0),
    Setting("mB", "mass of B", "kg", 0.1, above=0.0),
    Setting("R", "radius of each sphere", "m", 0.02, above=0.0),
    Setting("k", "contact constant", "N/m^q", 2e4, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.5, least=1.0, most=10.0),
    Setting("eta", "viscous constant", "kg/s", 1.0, least=0.0),
    Setting("dx", "x of B seen from A at the start", "m", 0.08),
    Setting("dy", "y of B seen from A at the start", "m", 0.018),
    Setting("vA", "velocity of A (x, y)", "m/s", (1.0, 0.0), many=True),
    Setting("vB", "velocity of B (x, y)", "m/s", (0.0, 0.0), many=True),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """`velocities` is (A x, A y, B x, B y) once the spheres are apart, `impulse` the one on B, `deflection` the angle B turned.

    Between the start and the touch, and after it, nothing acts: that part is a root of a quadratic, never a step.
    """
    ma, mb, reach = one(settings, "mA"), one(settings, "mB"), 2.0 * one(settings, "R")
    va, vb = row(settings, "vA", 2, "components"), row(settings, "vB", 2, "components")
    contact = Contact(one(settings, "k"), one(settings, "q"), one(settings, "eta"))
    apart, relative = (one(settings, "dx"), one(settings, "dy")), (vb[0] - va[0], vb[1] - va[1])
    if apart == (0.0, 0.0):
        raise BadSetting("spheres: dx = dy = 0 puts one centre on the other; start them apart.")
    pair = Pair(ma, mb, apart, relative, reach, contact)
    met = meet(pair)
    if met is None:
        nothing: dict[str, Observed] = {
            "velocities": (*va, *vb),
            "duration": 0.0,
            "largest_overlap": 0.0,
            "peak_force": 0.0,
            "impulse": (0.0, 0.0),
            "energy_ratio": 1.0,
        }
        return Run(
            nothing, dict.fromkeys(nothing, 0.0), "conservation", "the spheres pass each other", 0, "missed"
        )
    if contact.eta == 0.0 and met.overlap == 0.0:
        parted, error, spent = _sure(oblique(pair, met))
        model, why = "quadrature", "no damping: energy and angular momentum of the pair leave two integrals"
    else:
        parted, error, spent = _twice(pair, met, tolerance)
        model, why = (
            "integration",
            "damping, or a start inside the contact: one contact followed in its own time",
        )
    left = after_parting(pair, met, parted)
    total = ma + mb
    change = (left[0] - relative[0], left[1] - relative[1])
    observed: dict[str, Observed] = {
        "velocities": (
            *(v - mb / total * c for v, c in zip(va, change, strict=True)),
            *(v + ma / total * c for v, c in zip(vb, change, strict=True)),
        ),
        "duration": parted.duration,
        "largest_overlap": parted.overlap,
        "peak_force": parted.force,
        "impulse": (pair.mass * change[0], pair.mass * change[1]),
        "energy_ratio": _energy_ratio(ma, mb, va, vb, change),
    }
    return Run(
        observed, dict.fromkeys(observed, error), model, why, spent, "sticks" if parted.sticks else "released"
    )


def _energy_ratio(
    ma: float, mb: float, va: tuple[float, ...], vb: tuple[float, ...], change: tuple[float, float]
) -> float:
    a = [v - mb / (ma + mb) * c for v, c in zip(va, change, strict=True)]
    b = [v + ma / (ma + mb) * c for v, c in zip(vb, change, strict=True)]
    before = ma * math.hypot(*va) ** 2 + mb * math.hypot(*vb) ** 2
    return (ma * math.hypot(*a) ** 2 + mb * math.hypot(*b) ** 2) / before if before else math.inf


def _sure(parted: Parting) -> tuple[Parting, float, int]:
    return parted, 4.0 * parted.error_estimate, parted.evaluations


def _twice(pair: Pair, met: Touching, tolerance: float) -> tuple[Parting, float, int]:
    """Two runs; their difference is the error of the coarser."""
    coarse, fine = follow(pair, met, max(tolerance, 1e-14)), follow(pair, met, max(tolerance / 30.0, 1e-15))
    if coarse.sticks != fine.sticks:
        raise GuardFailed("One run releases the spheres, a finer one does not. Move eta off that edge.")
    speed = math.hypot(*pair.relative) or 1.0
    seen = [
        math.dist(after_parting(pair, met, coarse), after_parting(pair, met, fine)) / speed,
        abs(coarse.overlap / fine.overlap - 1.0),
        abs(coarse.force / fine.force - 1.0),
        0.0 if fine.sticks else abs(coarse.duration / fine.duration - 1.0),
    ]
    return fine, max(*seen, 2e-15), coarse.evaluations + fine.evaluations


SCENE = SceneDefinition("two spheres collide in a plane, with or without damping", SETTINGS, play)
