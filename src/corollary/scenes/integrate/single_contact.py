"""One contact between two spheres that damping or an overlap at the start keeps from quadrature, followed in its own time."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate import both_ways, contact_motion
from corollary.scenes.integrate.contact_motion import ROOM, SIZE, SPIN, TIME, TURN, P
from corollary.scenes.models.certain import found
from corollary.scenes.models.pair import (
    Pair,
    Parting,
    Touching,
    after_parting,
    collision,
    deepest,
    loaded_speed,
    meet,
    refuse_too_soft,
)
from corollary.scenes.run import GuardFailed, Observed, Run, by_relative_errors, two_runs

SAFE, LUCK = 3.0, 3e-4  # held in 10 000 draws against references of 31 digits

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


def collided(pair: Pair, tolerance: float) -> Run:
    """Everything that can be observed of two spheres, by quadrature or step by step. Raises BadSetting, GuardFailed."""
    met = meet(pair)
    if met is None or (pair.contact.eta == 0.0 and met.overlap == 0.0):
        return found(lambda: collision(pair))
    parted, error, spent = _twice(pair, met, tolerance)
    why = "damping, or a start inside the contact: one contact followed in its own time"
    left = after_parting(pair, met, parted)
    ma, mb, relative, (va, vb) = pair.mass_a, pair.mass_b, pair.relative, pair.velocities
    total = ma + mb
    change = (left[0] - relative[0], left[1] - relative[1])
    then_a = [v - mb / total * c for v, c in zip(va, change, strict=True)]
    then_b = [v + ma / total * c for v, c in zip(vb, change, strict=True)]
    impulse = pair.mass * change[0], pair.mass * change[1]
    had, has = (
        0.5 * (ma * math.hypot(*a) ** 2 + mb * math.hypot(*b) ** 2) for a, b in ((va, vb), (then_a, then_b))
    )
    observed: dict[str, Observed] = {
        "velocities": (*then_a, *then_b),
        "duration": parted.duration,
        "largest_overlap": parted.overlap,
        "peak_force": parted.force,
        "impulse": impulse,
        "energy_ratio": has / had if had else math.inf,
        "impulses": (-impulse[0], -impulse[1], *impulse),
        "momentum": (ma * va[0] + mb * vb[0], ma * va[1] + mb * vb[1]),
        "energy": has,
    }
    fast, thrown = max(map(abs, (*va, *vb, *relative))), pair.mass * math.hypot(*relative, *change)
    scales = {
        "velocities": fast,
        "impulse": thrown,
        "impulses": thrown,
        "energy_ratio": 1.0,
        "momentum": max(ma, mb) * fast,
        "energy": had,
    }
    errors = dict.fromkeys(observed, error)
    # The energy goes with the square of the velocities: much, where what was brought is little of what the contact gave.
    errors["energy_ratio"] = errors["energy"] = 2.0 * error * max(1.0, math.sqrt(has / had) if had else 1.0)
    outcome = "sticks" if parted.sticks else "released"
    return by_relative_errors(observed, errors, "integration", why, spent, outcome, scales)


def _twice(pair: Pair, met: Touching, tolerance: float) -> tuple[Parting, float, int]:
    """Two runs; their difference is the error of the coarser. Times SAFE it holds for what both have in common, too."""
    allowed = two_runs(tolerance)
    coarse, fine = (follow(pair, met, each) for each in allowed)
    if coarse.sticks != fine.sticks:
        raise GuardFailed("One run releases the spheres, a finer one does not. Move eta off that edge.")
    speed = math.hypot(*pair.relative) or 1.0
    seen = [
        math.dist(after_parting(pair, met, coarse), after_parting(pair, met, fine)) / speed,
        abs(coarse.overlap / fine.overlap - 1.0),
        abs(coarse.force / fine.force - 1.0),
        0.0 if fine.sticks else abs(coarse.duration / fine.duration - 1.0),
    ]
    # Agreement far below what a step is allowed is luck.
    return fine, SAFE * max(*seen, 5e-15, LUCK * allowed[0]), coarse.evaluations + fine.evaluations
