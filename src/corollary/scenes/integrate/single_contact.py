"""One contact between two spheres, damping and turning included, in a time stretched where the contact is young.

With overlap = w^s and dt = s w^(s-1) d(sigma) the equations are polynomials in w, and the release is a simple zero of w, reached
exactly with w itself as the variable of the last step.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate.controller import factor
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.extrema import maximum_between
from corollary.scenes.integrate.step import IntegrationStep, tried
from corollary.scenes.models.pair import Pair, Parting, Touching, deepest, loaded_speed, refuse_too_soft
from corollary.scenes.models.sticking import never_faster
from corollary.scenes.run import GuardFailed

MOST_STEPS = 3000
# Places in the state: root of the overlap, its rate, share of the spin left, time, angle turned.
W, P, SPIN, TIME, TURN = range(5)


@dataclass(frozen=True, slots=True)
class Groups:
    """The pure numbers on which a contact depends, in units of its depth and its speed.

    rate' = -spring x^q - drag rate - across^2 thickness share^2 / (1 - thickness x)^3, where x is the overlap.
    """

    q: float
    s: int
    spring: float
    drag: float
    across: float
    thickness: float

    def slope(self, _: float, y: Sequence[float]) -> list[float]:
        w, rate, share = y[W], y[P], y[SPIN]
        x, pace = w**self.s, self.s * w ** (self.s - 1)
        near = 1.0 - self.thickness * x
        spring = self.spring * x**self.q if x > 0.0 else 0.0
        push = spring + self.drag * rate + self.across**2 * self.thickness * share**2 / near**3
        return [
            rate,
            -pace * push,
            -pace * self.drag * share,
            pace,
            pace * self.across * self.thickness * share / near**2,
        ]

    def force(self, y: Sequence[float]) -> float:
        """The size of the force, its drag across the line of centres included."""
        x = max(y[W], 0.0) ** self.s
        return math.hypot(self.spring * x**self.q + self.drag * y[P], self._drag_across(y, x))

    def _drag_across(self, y: Sequence[float], x: float) -> float:
        return self.drag * self.across * y[SPIN] / (1.0 - self.thickness * x)

    def force_growth(self, y: Sequence[float]) -> float:
        """Half the rate of change of the force squared."""
        x = max(y[W], 0.0) ** self.s
        near, rate = 1.0 - self.thickness * x, y[P]
        push = self.spring * x**self.q + self.drag * rate
        gained = -push - self.across**2 * self.thickness * y[SPIN] ** 2 / near**3
        stiffness = self.spring * self.q * x ** (self.q - 1.0) if x > 0.0 else 0.0
        side = self._drag_across(y, x)
        return push * (stiffness * rate + self.drag * gained) + side**2 * (
            self.thickness * rate / near - self.drag
        )

    def sticks(self, y: Sequence[float]) -> bool:
        """Whether the contact will never end: the argument for two bodies on a line, the turning counted as a spring.

        It fades faster than the overlap, so what holds now holds for ever.
        """
        x, rate = max(y[W], 0.0) ** self.s, y[P]
        if self.drag == 0.0 or x == 0.0 or rate > 0.0:
            return False
        turning = self.across**2 * self.thickness * y[SPIN] ** 2 / x
        return never_faster(self.drag, self.spring * x ** (self.q - 1.0) + turning, -rate / x)


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
    numbers = Groups(
        q=contact.q,
        s=smoothing_power(contact),
        spring=contact.k * depth ** (contact.q + 1.0) / (mass * speed**2),
        drag=contact.eta * depth / (mass * speed),
        across=met.spin / (pair.reach * speed),
        thickness=depth / pair.reach,
    )
    return numbers, depth, speed


def follow(pair: Pair, met: Touching, tolerance: float) -> Parting:
    """The contact from `met` to its end; `tolerance` is the error allowed to a step, in units of the depth and the speed.

    Raises GuardFailed when the end is not reached, BadSetting when the centres all but meet.
    """
    groups, depth, speed = groups_of(pair, met)
    state = [(met.overlap / depth) ** (1.0 / groups.s), met.inward / speed, 1.0, 0.0, 0.0]
    top_force, top_overlap, spent, h = groups.force(state), met.overlap / depth, 0, 0.1
    ended = False
    for _ in range(MOST_STEPS):
        if ended or groups.sticks(state):
            return Parting(
                turned=state[TURN],
                outward=-state[P] * speed,
                spin=state[SPIN] * met.spin,
                duration=state[TIME] * depth / speed if ended else math.inf,
                overlap=top_overlap * depth,
                force=top_force * pair.mass * speed**2 / depth,
                sticks=not ended,
                evaluations=spent,
            )
        trial = _try(groups, state, h, tolerance)
        size, new = trial.size, trial.after
        spent += len(DOP853.rows)
        if not size <= 1.0 or (new[W] <= 0.0 and not trial.lands):
            h *= min(0.5, factor(size))
            continue
        if state[P] > 0.0 >= new[P]:
            top, cost = maximum_between(state[P], new[P], trial.part_way, lambda y: y[P])
            top_overlap, spent = top[W] ** groups.s, spent + cost
            refuse_too_soft(top_overlap * groups.thickness, 1.0)
        refuse_too_soft(new[W] ** groups.s * groups.thickness, 1.0)
        rising, falling = groups.force_growth(state), groups.force_growth(new)
        if rising > 0.0 >= falling:
            top, cost = maximum_between(rising, falling, trial.part_way, groups.force_growth)
            top_force, spent = max(top_force, groups.force(top)), spent + cost
        state, ended = new, trial.lands
        h *= factor(size)
    remedy = "Choose less damping." if groups.drag > 0.0 else "Start the spheres apart, or faster."
    raise GuardFailed(f"The contact did not end within {MOST_STEPS} steps. {remedy}")


def _try(groups: Groups, state: list[float], h: float, tolerance: float) -> IntegrationStep:
    """One step in stretched time; when that would pass the release, one with w as the variable that ends there."""
    allowed = [tolerance] * len(state)
    stepped = tried(groups.slope, 0.0, state, h, allowed)
    if stepped.after[W] > 0.0 or state[P] >= 0.0 or state[W] == 0.0:
        return stepped

    def by_root(w: float, y: Sequence[float]) -> list[float]:
        rates = groups.slope(0.0, [w, *y[1:]])
        return [rate / rates[W] for rate in rates]

    landed = tried(by_root, state[W], state, -state[W], allowed, lands=True)
    landed.after[W] = 0.0
    return landed
