"""When two spheres that fly freely, or fall alike, begin to touch, and how they move then: known without a step, from however far they come."""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb

from corollary.scenes.models.certain import decided
from corollary.scenes.models.pair import Pair, Vector, touch


@dataclass(frozen=True, slots=True)
class Meeting:
    """The spheres when they begin to touch, or at the start, if they do: B is in the unit direction `toward` from A.

    They overlap by `overlap` (m); seen from A, B moves `along` this direction and `across` it (m/s, counter-clockwise). From then on they
    are watched for `left` (s).
    """

    toward: Vector
    overlap: float
    along: float
    across: float
    left: float


def met_within(pair: Pair, t: float) -> Meeting | None:
    """Their meeting, where it is within the time t (s). Raises GuardFailed when no digits tell whether they meet."""
    return decided(
        lambda: _met_within(pair, arb(t)),
        "Two spheres that graze each other by less than any digits tell; move one of them a little.",
    )


def _met_within(pair: Pair, t: arb) -> Meeting | None:
    met = touch(pair)
    # At the very moment of the touch nothing has come of it.
    if met is None or not float(t - met.after) > 0.0:
        return None
    x, y = met.direction
    length, distance = (x * x + y * y).sqrt(), arb(pair.reach) - met.overlap
    return Meeting(
        (float(x / length), float(y / length)),
        *map(float, (met.overlap, -met.inward, met.spin / distance, t - met.after)),
    )
