"""Two bodies on a line: a spring with a dashpot between them has a closed form; any other contact goes to the models of a row."""

from __future__ import annotations

from corollary.scenes.collision import CLOSED, Collided, collide
from corollary.scenes.models.dashpot import damped_spring
from corollary.scenes.row import Row, RowResult, reduced_mass


def collide_two(line: Row, tolerance: float) -> Collided:
    """What a line of two bodies comes to. Raises GuardFailed as `collide` does."""
    (a, b), (u, v), (contact,), (gap,) = line.masses, line.velocities, line.contacts, line.gaps
    if contact.q != 1.0 or contact.eta == 0.0 or line.weight != 0.0 or gap < 0.0 or u <= v:
        return collide(line, tolerance)
    mass, closing = reduced_mass(a, b), u - v
    found = damped_spring(mass, contact.k, contact.eta, closing)
    change = (1.0 + found.kept) * closing
    passage = RowResult(
        velocities=(u - mass / a * change, v + mass / b * change),
        duration=found.duration,
        overlaps=(found.overlap,),
        forces=(found.force,),
        outcome="sticks" if found.sticks else "released",
        evaluations=0,
        openings=0 if found.sticks else 1,
    )
    why = "a spring with a dashpot: the swing fades as it goes, which is known exactly"
    # Near critical damping the swing is slow, and what rounding leaves of the damping counts as often as it is slower.
    share = 0.25 * contact.eta**2 / (contact.k * mass)
    slow = 1.0 if found.sticks else 1.0 / (1.0 - share) if share < 1.0 else 1e15
    sure = 4.0 * CLOSED
    errors = {"velocities": sure, "overlaps": sure, "forces": sure, "duration": min(sure * slow, 1.0)}
    return Collided(passage, errors, "piecewise exact", why, 0)
