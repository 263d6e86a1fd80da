"""The order of a method on one contact, over a family of contacts: head-on and glancing, damped and not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.grading.programs.fixed_step import RK4
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Tableau
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.pair import Pair, after_parting, meet

from .measures import Order, at_the_fine_end
from .phases import through

# Where the power law holds: coarser steps do not follow it yet, and finer ones show rounding and the reference's own error.
COARSE, FINE = 1e-4, 3e-14

ASIDE = (0.0, 0.45, 0.9)
"""Impact parameters in units of the reach. At 0.95, lightly damped, rounding comes before the power law: RK4 shows 3.95 there."""

DAMPINGS = (0.0, 0.5, 1.0, 5.0)
"""In kg/s; the chapter's spheres stick from 9.6 kg/s on."""


@dataclass(frozen=True, slots=True)
class Sampling:
    """The counts of steps a method is tried with, and which part of those that follow a power law is kept, the finest."""

    table: Tableau
    counts: tuple[int, ...]
    part: float


SAMPLINGS = {
    "regularised_rk4": Sampling(RK4, tuple(round(20.0 * 2.0 ** (i / 3.0)) for i in range(19)), 0.5),
    # The error of order 8 has dips where two of its terms cancel, and reaches rounding soon: many counts close together, and all.
    "regularised_dop853": Sampling(DOP853, tuple(range(6, 240, 2)), 1.0),
}


def chapters(aside: float, eta: float) -> Pair:
    """The chapter's two spheres, with another impact parameter and damping."""
    return Pair(0.1, 0.1, (0.08, 0.04 * aside), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(2e4, 1.5, eta))


def least_order(
    method: str, asides: Sequence[float] = ASIDE, dampings: Sequence[float] = DAMPINGS
) -> tuple[Order, float, float]:
    """The lowest order of a method on these contacts, and the impact parameter and damping it was found with."""
    found = [
        (order_on(chapters(aside, eta), SAMPLINGS[method]), aside, eta)
        for aside in asides
        for eta in dampings
    ]
    return min(found, key=lambda each: each[0].value)


def order_on(pair: Pair, sampling: Sampling) -> Order:
    """The order of a method on one contact; its reference is the contact in adaptive steps of w.

    Raises ValueError when the two never meet, or too few counts lie where a power law holds.
    """
    met = meet(pair)
    if met is None:
        raise ValueError("These two spheres never meet.")
    true, speed = after_parting(pair, met, follow(pair, met, 1e-15)), math.hypot(*pair.relative)
    points: list[tuple[float, float]] = []
    for count in sampling.counts:
        error = math.dist(true, after_parting(pair, met, through(pair, met, sampling.table, count))) / speed
        if error < FINE:
            break
        if error < COARSE:
            points.append((1.0 / count, error))
        else:
            points.clear()
    if len(points) < 4:
        raise ValueError(
            f"Only {len(points)} of these counts of steps are neither coarse nor at the end of a double's digits."
        )
    kept = max(4, math.ceil(sampling.part * len(points)))
    return at_the_fine_end(points[-kept:])
