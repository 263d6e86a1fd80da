"""Numbers that guessing finds without any physics: one digit, a round angle, a simple share, a small count."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.answers.expected import Values
from corollary.units.unit import ONE, Unit

ROUND_ANGLE, OFF = 15.0, 0.05  # degrees: 30°, 45°, 60°, 90° … and their radians to three figures
PARTS, LARGEST_SHARE, SHARE_OFF = (1, 2, 3, 4), 4.0, 2e-3  # 1/2, 2/3, 1.5, 25 %
SMALL_COUNT = 99
SAME = 1e-9


def may_be_guessed(
    typed: Sequence[float], values: Values, target: Values, unit: Unit, *, counted: bool = False
) -> bool:
    """True if a slip fits what anybody may type: `typed` in its own unit, `values` in SI, where `target` is right.

    Of a number of one digit, such as 1 or 100, a sign may be a slip all the same; of an angle, a share, and a count it is a guess.
    """
    if are_round(values, unit, counted=counted):
        return True
    digits = max(len(f"{abs(x):.9e}".partition("e")[0].replace(".", "").rstrip("0")) for x in typed)
    return digits <= 1 and not _same_sizes(values, target)


def are_round(values: Values, unit: Unit, *, counted: bool = False) -> bool:
    """True if all are round angles, simple shares or small counts, whichever the unit asks for; of other quantities none is."""
    if unit.dimension != ONE:
        return False
    return all(map(_small_count if counted else _round_angle if unit.is_angle else _simple_share, values))


def _same_sizes(values: Values, target: Values) -> bool:
    return all(math.isclose(abs(x), abs(y), rel_tol=SAME) for x, y in zip(values, target, strict=True))


def _round_angle(angle: float) -> bool:
    return abs(math.remainder(math.degrees(angle), ROUND_ANGLE)) <= OFF


def _simple_share(share: float) -> bool:
    return abs(share) <= LARGEST_SHARE and any(
        abs(math.remainder(share * part, 1.0)) <= SHARE_OFF * part and share for part in PARTS
    )


def _small_count(count: float) -> bool:
    return abs(count) <= SMALL_COUNT
