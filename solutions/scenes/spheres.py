"""Two spheres collide in a plane: contact force k overlap^q between the centres, drag on the relative velocity (12.6)."""

from __future__ import annotations

import math
from dataclasses import replace

from second_way import followed

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, vector
from corollary.scenes.film import AGAIN, Film, film
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.single_contact import collided
from corollary.scenes.models.pair import Pair
from corollary.scenes.run import (
    BadSetting,
    Observable,
    Run,
    components,
)
from corollary.scenes.scene import Body, Scene

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


def second_way(settings: Settings, tolerance: float) -> Run | None:
    """From start to end as an author's own scene, two bodies of their own; none for damping, whose contact is followed in steps."""
    pair = pair_of(settings, "spheres")
    if pair.contact.eta:
        return None
    bodies = tuple(
        Body(m, x, v, 0.5 * pair.reach)
        for m, x, v in zip((pair.mass_a, pair.mass_b), ((0.0, 0.0), pair.apart), pair.velocities, strict=True)
    )
    observe = {each for each in Observable if each.value in NAMES}
    run = followed(Scene(bodies, (pair.contact,), name="spheres"), observe, tolerance)
    given = run.measured["impulse"]
    value, error = components(given.value)[2:], components(given.error)[2:]
    return replace(run, measured=run.measured | {"impulse": replace(given, value=value, error=error)})


def filmed(settings: Settings) -> Film | None:
    ma, mb, reach, k, q, eta, dx, dy = numbers(settings, "mA", "mB", "R", "k", "q", "eta", "dx", "dy")
    va, vb, apart = vector(settings, "vA"), vector(settings, "vB"), (dx, dy)
    relative = vb[0] - va[0], vb[1] - va[1]
    speed = math.hypot(*relative)
    nearest = -(apart[0] * relative[0] + apart[1] * relative[1]) / speed**2 if speed else 0.0
    if nearest <= 0.0:
        return None
    a, b = Body(ma, (0.0, 0.0), va, reach, "A"), Body(mb, apart, vb, reach, "B")
    return film((a, b), [((Contact(k, q, eta),), (1.0 + AGAIN) * nearest)])


SCENE = SceneDefinition(
    "two spheres collide in a plane, with or without damping",
    SETTINGS,
    play,
    second_way=second_way,
    film=filmed,
)
