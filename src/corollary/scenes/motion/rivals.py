"""Where the laws of rigid bodies leave more than one motion open: what carries a body decides how much friction can hold."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from corollary.scenes.motion.complementarity import combinations, consistent, differ, may_squeeze, moved
from corollary.scenes.motion.multipliers import Array, Item, Status, answer

# Looking for another answer is not worth more trials than these.
MOST_RIVALS = 700
# By such a part of all that holds motions differ that are not the same: a slight push is held or not.
ROUNDED = 1e-11

Statuses = tuple[Status, ...]


def rivals(
    items: Sequence[Item], first: Statuses, inverse: Array, lasts: Callable[[Statuses], bool]
) -> tuple[Statuses, Statuses] | None:
    """Of the combinations that are consistent and last, and of `first`, the two that move bodies most unlike; None where all move them alike.

    Without friction that depends on what presses there is one motion; where too many combinations are to be tried no other is looked for.
    What rests goes on resting where friction, once broken, could not hold it: that is no other motion, so what begins to slip is tried
    with all that friction can hold.
    """
    if math.prod(len(item.may) for item in items) > MOST_RIVALS or all(item.pressed < 0 for item in items):
        return None
    firm = [replace(item, kinetic=item.static) if "stick" in item.may else item for item in items]
    found = [(first, moved(firm, answer(firm, first, inverse), inverse))]
    for other in combinations(firm):
        tried = answer(firm, other, inverse)
        change = moved(firm, tried, inverse)
        if (
            all(differ(known, change, ROUNDED) for _, known in found)
            and consistent(firm, other, tried, inverse)
            and not may_squeeze(firm, other, inverse)
            and consistent(items, other, answer(items, other, inverse), inverse)
            and lasts(other)
        ):
            found.append((other, change))
    if len(found) == 1:
        return None
    (one, _), (other, _) = max(
        itertools.combinations(found, 2), key=lambda two: float(np.abs(two[0][1] - two[1][1]).max())
    )
    return one, other
