"""One contact in equal steps of an angle (`w = rho sin`, its rate `rho cos`), so that the order of a method shows.

The contact runs from phase 0 to pi whatever the damping, as long as it ends; the force is smooth there at both ends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.scenes.integrate import contact_motion
from corollary.scenes.integrate.contact_motion import SIZE, SPIN, TIME, TURN, P, W
from corollary.scenes.integrate.runge_kutta import Tableau, step
from corollary.scenes.integrate.single_contact import groups_of
from corollary.scenes.models.pair import Pair, Parting, Touching


def through(pair: Pair, met: Touching, table: Tableau, steps: int) -> Parting:
    """The contact in a number of equal steps of any method; it begins at zero overlap, and its damping lets it end."""
    groups, depth, speed = groups_of(pair, met)
    spent = 0

    def slope(phase: float, state: Sequence[float]) -> list[float]:
        nonlocal spent
        spent += 1
        rho, share, time, turn = state
        w, rate = rho * math.sin(phase), rho * math.cos(phase)
        rates = [0.0] * SIZE
        contact_motion.slope([w, rate, share, time, turn], rates, groups, False)  # pyright: ignore[reportUnknownMemberType]
        ahead = (rate * rates[W] - w * rates[P]) / (rho * rho)
        grown = (w * rates[W] + rate * rates[P]) / rho
        return [grown / ahead, rates[SPIN] / ahead, rates[TIME] / ahead, rates[TURN] / ahead]

    state, h = [met.inward / speed, 1.0, 0.0, 0.0], math.pi / steps
    for i in range(steps):
        state, _ = step(table, slope, i * h, state, h, slope(i * h, state))
    rho, share, time, turn = state
    return Parting(
        turned=turn,
        outward=rho * speed,
        spin=share * met.spin,
        duration=time * depth / speed,
        overlap=depth,
        force=math.nan,
        sticks=False,
        evaluations=spent,
    )
