"""One contact between two spheres that damping or an overlap at the start keeps from quadrature, followed in its own time."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate import both_ways, contact_motion
from corollary.scenes.integrate.contact_motion import ROOM, SIZE, SPIN, TIME, TURN, P
from corollary.scenes.models.pair import Pair, Parting, Touching, deepest, loaded_speed, refuse_too_soft
from corollary.scenes.run import GuardFailed

MOST_STEPS = 3000
Groups = tuple[float, int, float, float, float, float]
"""The pure numbers on which a contact depends (`contact_motion`)."""


def groups_of(pair: Pair, met: Touching) -> tuple[Groups, float, float]:
    """The pure numbers of a contact, and its units of depth (the true largest overlap, about) and speed.

    A start that overlaps and goes on inward is measured by how deep it will be, not by how deep it is: what rounding made overlap
    goes in a million times as far.
    """
    mass, contact = pair.mass, pair.contact
    if met.overlap > 0.0:
        loaded = loaded_speed(pair, met.overlap)
        if met.inward > 0.0:
            speed = math.hypot(met.inward, loaded)
            depth = max(met.overlap, deepest(pair, replace(met, overlap=0.0, inward=speed)))
        else:
            depth = met.overlap
            flung = met.spin / pair.reach * math.sqrt(2.0 * depth / pair.reach)
            speed = math.hypot(met.inward, flung, loaded)
    else:
        speed, depth = met.inward, deepest(pair, met)
    if contact.eta > 0.0:
        depth = max(min(depth, mass * speed / contact.eta), met.overlap)
    spring = contact.k * depth ** (contact.q + 1.0) / (mass * speed**2)
    drag, across = contact.eta * depth / (mass * speed), met.spin / (pair.reach * speed)
    groups = contact.q, smoothing_power(contact), spring, drag, across, depth / pair.reach
    return groups, depth, speed


def follow(pair: Pair, met: Touching, tolerance: float) -> Parting:
    """The contact from `met` to its end; `tolerance` is the error allowed to a step, in units of the depth and the speed.

    Raises GuardFailed when the end is not reached, BadSetting when the centres all but meet.
    """
    groups, depth, speed = groups_of(pair, met)
    y = [(met.overlap / depth) ** (1.0 / groups[1]), met.inward / speed, 1.0, 0.0, 0.0]
    follow, fast = contact_motion.follow, both_ways.wanted()
    if fast:
        (y,), follow = both_ways.arrays(y), both_ways.compiled("contact_motion").follow
    room = both_ways.room(ROOM, SIZE, fast)
    end, overlap, force, spent = follow(y, groups, tolerance, MOST_STEPS, room)
    if end == contact_motion.TOO_SOFT:
        refuse_too_soft(1.0, 1.0)
    if end == contact_motion.TOO_LONG:
        remedy = "Choose less damping." if pair.contact.eta > 0.0 else "Start the spheres apart, or faster."
        raise GuardFailed(f"The contact did not end within {MOST_STEPS} steps. {remedy}")
    stuck = end == contact_motion.STICKS
    return Parting(
        turned=float(y[TURN]),
        outward=-float(y[P]) * speed,
        spin=float(y[SPIN]) * met.spin,
        duration=math.inf if stuck else float(y[TIME]) * depth / speed,
        overlap=overlap * depth,
        force=force * pair.mass * speed**2 / depth,
        sticks=stuck,
        evaluations=spent,
    )
