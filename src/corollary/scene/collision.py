"""A collision on a line, by the least model that answers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from corollary.scene.line import Line, Passage, natural_units, reduced_mass
from corollary.scene.method import regularised
from corollary.scene.model.beta import contact_time, largest_overlap
from corollary.scene.run import GuardFailed, Model

# What rounding leaves of a closed formula.
CLOSED = 2e-15


@dataclass(frozen=True, slots=True)
class Collided:
    """A passage with the error of each thing seen in it (in natural units), and the model that found it."""

    passage: Passage
    errors: dict[str, float]
    model: Model
    why: str
    spent: int


@lru_cache(maxsize=1024)
def collide(line: Line, tolerance: float) -> Collided:
    """What the line comes to. Raises GuardFailed when no run keeps momentum and energy."""
    if _one_free_contact(line):
        return _two_bodies(line)
    if _springs(line):
        return _swinging(line)
    return _integrated(line, tolerance)


def _one_free_contact(line: Line) -> bool:
    return len(line.masses) == 2 and line.contacts[0].eta == 0.0 and line.weight == 0.0 and line.gaps[0] >= 0.0


def _springs(line: Line) -> bool:
    return line.weight == 0.0 and all(c.q == 1.0 and c.eta == 0.0 for c in line.contacts)


def _swinging(line: Line) -> Collided:
    from corollary.scene.model import modal  # here, since it brings numpy, which most scenes never need

    passage = modal.collide(line)
    # Every opening or closing hands its rounding on to what follows.
    sure = dict.fromkeys(("velocities", "overlaps", "forces"), CLOSED * len(line.masses) * max(passage.openings, 1))
    errors = sure | {"duration": 10.0 * sure["velocities"]}
    return Collided(passage, errors, "piecewise exact", "springs: from one opening to the next the motion is a sum of swings", 0)


def _two_bodies(line: Line) -> Collided:
    (a, b), (u, v), (contact,) = line.masses, line.velocities, line.contacts
    if u <= v:
        return Collided(Passage((u, v), 0.0, (0.0,), (0.0,), "missed", 0), {}, "conservation", "the bodies never meet", 0)
    mass, closing = reduced_mass(a, b), u - v
    overlap = largest_overlap(mass, contact.k, contact.q, closing)
    after = (u - 2.0 * mass / a * closing, v + 2.0 * mass / b * closing)
    passage = Passage(
        velocities=after,
        duration=contact_time(mass, contact.k, contact.q, closing),
        overlaps=(overlap,),
        forces=(contact.k * overlap**contact.q,),
        outcome="released",
        evaluations=0,
        openings=1,
    )
    why = "two bodies, no damping: momentum and energy give the velocities, Beta functions close the energy integral"
    return Collided(passage, dict.fromkeys(("velocities", "duration", "overlaps", "forces"), CLOSED), "quadrature", why, 0)


def _integrated(line: Line, tolerance: float) -> Collided:
    """The error is the difference from a coarser run, which is the coarser one's: the finer one's is smaller."""
    coarse = regularised.collide(line, max(tolerance, 1e-14))
    fine = regularised.collide(line, max(tolerance / 30.0, 1e-15))
    if coarse.outcome != fine.outcome:
        raise GuardFailed(f"One run ends {coarse.outcome!r}, a finer one {fine.outcome!r}. Move the settings off that edge.")
    units = natural_units(line)
    if units is None:
        return Collided(fine, {}, "conservation", "nothing moves toward anything", 0)
    error = {
        "velocities": _apart(coarse.velocities, fine.velocities) / units.speed,
        "duration": 0.0 if math.isinf(fine.duration) else abs(coarse.duration - fine.duration) / max(units.time, fine.duration),
        "overlaps": _apart(coarse.overlaps, fine.overlaps) / units.overlap,
        "forces": _apart(coarse.forces, fine.forces) / units.force,
    }
    why = _reason(line)
    errors = {name: max(e, CLOSED) for name, e in error.items()}
    return Collided(fine, errors, "integration", why, coarse.evaluations + fine.evaluations)


def _reason(line: Line) -> str:
    if any(c.eta > 0.0 for c in line.contacts):
        return "damping takes energy at every moment of the contact: no integral of motion is left"
    return f"{len(line.masses)} bodies touch at once: momentum and energy are two equations for {len(line.masses)} velocities"


def _apart(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))
