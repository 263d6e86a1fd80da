"""Two spheres collide in a plane: contact force k overlap^q between the centres, drag on the relative velocity (12.6)."""

from __future__ import annotations

import math

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, vector
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.certain import found
from corollary.scenes.models.pair import Pair, Parting, Touching, after_parting, collision, meet
from corollary.scenes.run import BadSetting, GuardFailed, Observed, Run, by_relative_errors, two_runs

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

SAFE, LUCK = 3.0, 3e-4  # by benchmarks/calibration.py
NAMES = ("velocities", "duration", "largest_overlap", "peak_force", "impulse", "energy_ratio")


def play(settings: Settings, tolerance: float) -> Run:
    """`velocities` is (A x, A y, B x, B y) once the spheres are apart, `impulse` the one on B.

    Between the start and the touch, and after it, nothing acts: that part is a root of a quadratic, never a step.
    """
    return collided(pair_of(settings, "spheres"), tolerance).only(NAMES)


def pair_of(settings: Settings, name: str) -> Pair:
    """The spheres of the scene of this name. Raises BadSetting."""
    ma, mb, radius, k, q, eta, dx, dy = numbers(settings, "mA", "mB", "R", "k", "q", "eta", "dx", "dy")
    va, vb = vector(settings, "vA"), vector(settings, "vB")
    if dx == dy == 0.0:
        raise BadSetting(f"{name}: dx = dy = 0 puts one centre on the other; start them apart.")
    return Pair(ma, mb, (dx, dy), (va, vb), 2.0 * radius, Contact(k, q, eta))


def collided(pair: Pair, tolerance: float) -> Run:
    """Everything that can be observed of two spheres, by quadrature or step by step. Raises BadSetting, GuardFailed."""
    met = meet(pair)
    if met is None or (pair.contact.eta == 0.0 and met.overlap == 0.0):
        return found(lambda: collision(pair))
    parted, error, spent = _twice(pair, met, tolerance)
    why = "damping, or a start inside the contact: one contact followed in its own time"
    left = after_parting(pair, met, parted)
    ma, mb, relative, (va, vb) = pair.mass_a, pair.mass_b, pair.relative, pair.velocities
    total = ma + mb
    change = (left[0] - relative[0], left[1] - relative[1])
    then_a = [v - mb / total * c for v, c in zip(va, change, strict=True)]
    then_b = [v + ma / total * c for v, c in zip(vb, change, strict=True)]
    impulse = pair.mass * change[0], pair.mass * change[1]
    had, has = (
        0.5 * (ma * math.hypot(*a) ** 2 + mb * math.hypot(*b) ** 2) for a, b in ((va, vb), (then_a, then_b))
    )
    observed: dict[str, Observed] = {
        "velocities": (*then_a, *then_b),
        "duration": parted.duration,
        "largest_overlap": parted.overlap,
        "peak_force": parted.force,
        "impulse": impulse,
        "energy_ratio": has / had if had else math.inf,
        "impulses": (-impulse[0], -impulse[1], *impulse),
        "momentum": (ma * va[0] + mb * vb[0], ma * va[1] + mb * vb[1]),
        "energy": has,
    }
    fast, thrown = max(map(abs, (*va, *vb, *relative))), pair.mass * math.hypot(*relative, *change)
    scales = {
        "velocities": fast,
        "impulse": thrown,
        "impulses": thrown,
        "energy_ratio": 1.0,
        "momentum": max(ma, mb) * fast,
        "energy": had,
    }
    errors = dict.fromkeys(observed, error)
    # The energy goes with the square of the velocities: much, where what was brought is little of what the contact gave.
    errors["energy_ratio"] = errors["energy"] = 2.0 * error * max(1.0, math.sqrt(has / had) if had else 1.0)
    outcome = "sticks" if parted.sticks else "released"
    return by_relative_errors(observed, errors, "integration", why, spent, outcome, scales)


def _twice(pair: Pair, met: Touching, tolerance: float) -> tuple[Parting, float, int]:
    """Two runs; their difference is the error of the coarser. Times SAFE it holds for what both have in common, too."""
    allowed = two_runs(tolerance)
    coarse, fine = (follow(pair, met, each) for each in allowed)
    if coarse.sticks != fine.sticks:
        raise GuardFailed("One run releases the spheres, a finer one does not. Move eta off that edge.")
    speed = math.hypot(*pair.relative) or 1.0
    seen = [
        math.dist(after_parting(pair, met, coarse), after_parting(pair, met, fine)) / speed,
        abs(coarse.overlap / fine.overlap - 1.0),
        abs(coarse.force / fine.force - 1.0),
        0.0 if fine.sticks else abs(coarse.duration / fine.duration - 1.0),
    ]
    # Agreement far below what a step is allowed is luck.
    return fine, SAFE * max(*seen, 5e-15, LUCK * allowed[0]), coarse.evaluations + fine.evaluations


SCENE = SceneDefinition("two spheres collide in a plane, with or without damping", SETTINGS, play)
