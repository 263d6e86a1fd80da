"""What errors decide: whether friction holds that can hold hardly more than it must, or less; which of several hits is first."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from corollary.scenes.constraint import Rub, State, farther_off
from corollary.scenes.motion.complementarity import settled
from corollary.scenes.motion.hits import hangs_on_order
from corollary.scenes.motion.multipliers import Item, Status
from corollary.scenes.motion.path import Doubt, Trajectory
from corollary.scenes.motion.sizes import Sizes
from corollary.scenes.motion.system import Array, System
from corollary.scenes.run import GuardFailed
from corollary.scenes.scene import Conserves, Scene, start_of

SENTENCES: dict[Doubt, str] = {
    "graze": "a touch grazes at about {:.6g} s: whether it happens is within the error, and in the errors stated",
    "crowd": "at {:.6g} s a body is hit from several sides all but at once: which hit is first is in the errors stated",
    "order": "at {:.6g} s a body is hit from several sides at once, or hit while something else holds it: these are settled together; one "
    "after the other they would leave it otherwise",
    "tie": "friction soon after {:.6g} s can hold as much as it must, but for errors: whether it does is in the errors stated",
    "rival": "at {:.6g} s what carries a body decides how much friction can hold, and the laws of rigid bodies leave it open: the errors "
    "stated span another motion that obeys them",
}

# The coarsest tolerance for pucks that are tied.
TIED = 1e-10

Rubbing = TypeVar("Rubbing", Item, Rub)


def ties_pucks(scene: Scene) -> bool:
    """Whether rods or strings tie what rubs on a table: the ways in which such bodies begin to slip show in fine steps only."""
    system = System(scene)
    pucks = {i for rub in system.rubs if len(rub.driven) == 2 for i in rub.bodies}
    return any(len(pucks.intersection(c.bodies)) > 1 for c in system.constraints)


def leaned(each: Rubbing, share: float) -> Rubbing:
    """The same with friction that much stronger."""
    return replace(each, kinetic=each.kinetic * (1.0 + share), static=each.static * (1.0 + share))


def shift_all(system: System, shift: float, tie: float) -> None:
    """Let every touch happen so much (m) later and friction hold more than what is `tied` with it; or earlier and less, if negative,
    and take the one or the other of two motions most unlike where laws leave it open.

    The first wall is shifted by that, the second by twice as much, and so on: hits all but at one moment come in this order or the other.
    """
    if not shift:
        return
    start = start_of(system.scene)
    system.constraints = [farther_off(c, start, i * shift) for i, c in enumerate(system.constraints, 1)]
    system.rubs = [leaned(rub, math.copysign(2.0 * tie, shift)) for rub in system.rubs]
    system.rival = 0 if shift > 0.0 else 1


def damp_all(system: System, less: float) -> None:
    """Let hits give back up to a part `less` less; where energy is conserved nothing forgets how it began, and they stay as they are."""
    if less and Conserves.ENERGY not in system.scene.conserves:
        system.constraints = [replace(c, less=less) for c in system.constraints]


def tied(items: Sequence[Item], statuses: Sequence[Status], inverse: Array, share: float) -> bool:
    """Whether something would stick that slips, or slip that sticks, were friction by such a `share` stronger or weaker."""
    undecided = ["stick" in item.may for item in items]
    if not any(undecided):
        return False
    sticks = [status == "stick" for status in statuses]
    for sign in (1.0, -1.0):
        try:
            changed = [leaned(item, sign * share * may) for item, may in zip(items, undecided, strict=True)]
            other = settled(changed, inverse, "")
        except GuardFailed:
            return True
        if [status == "stick" for status in other] != sticks:
            return True
    return False


def crowded(system: System, time: float, y: State, near: Sequence[int], sizes: Sizes) -> set[Doubt]:
    """Whether what is hit now, with those `near`, is hit elsewhere all but at once, or at once, so that errors or a rule decide."""
    gaps = {i: c.gap(time, y) for i, c in enumerate(system.constraints) if not c.two_sided}
    closing = [
        i
        for i, gap in gaps.items()
        if gap < sizes.doubt and system.rate(time, y, system.constraints[i]) < -sizes.speed
    ]
    for group, _ in system.clusters(time, y, closing, []):
        found = sorted(gaps[i] for i in group)
        if found[0] <= sizes.gap and found[-1] - found[0] > 8.0 * math.ulp(sizes.long):
            return {"crowd"}
    return {"order"} if hangs_on_order(system, time, y, near, sizes) else set()


def doubts(*paths: Trajectory) -> list[str]:
    """What errors have decided on the way, in sentences: when first, and that it is in the errors stated."""
    return [
        sentence.format(min(path.doubts.get(what, math.inf) for path in paths))
        for what, sentence in SENTENCES.items()
        if any(what in path.doubts for path in paths)
    ]
