"""The largest overlap and the largest force of each contact, found between the steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from corollary.scenes.forces.contact import push
from corollary.scenes.integrate.runge_kutta import Slope
from corollary.scenes.integrate.step import EVALUATIONS, IntegrationStep
from corollary.scenes.integrate.time_variable import beside
from corollary.scenes.row import RowOfBodies, closing_speed


class Extrema:
    """The greatest overlap and force of each contact so far; every step of a motion is handed to `look_within`."""

    def __init__(self, line: RowOfBodies) -> None:
        self.line = line
        self.overlaps = [max(-gap, 0.0) for gap in line.gaps]
        self.forces = [push(c, d, 0.0) for c, d in zip(line.contacts, self.overlaps, strict=True)]
        self.damped = [j for j, contact in enumerate(line.contacts) if contact.eta > 0.0]
        self.evaluations = 0

    def onset(self, state: Sequence[float], touching: Sequence[bool]) -> None:
        """A damped contact pushes at once when it closes: that may already be its largest force."""
        for j in self.damped:
            if touching[j] and state[1 + j] >= 0.0:
                force = push(self.line.contacts[j], state[1 + j], closing_speed(self.line, state, j))
                self.forces[j] = max(self.forces[j], force)

    def look_within(
        self,
        state: list[float],
        step: IntegrationStep,
        touching: Sequence[bool],
        base: Sequence[float],
        in_time: Slope,
    ) -> None:
        """Look for a maximum within a step from a state; `base` is the slope there, `in_time` the law that gave it."""
        after, count = step.after, len(self.overlaps)
        for j, on in enumerate(touching):
            if (
                on
                and base[j] > 0.0 >= after[1 + count + j] - after[2 + count + j]
                and state[1 + j] >= 0.0 <= after[1 + j]
            ):
                overlap, spent = largest_overlap(step, j)
                self.evaluations += spent
                if overlap > self.overlaps[j]:
                    self.overlaps[j] = overlap
                    if self.line.contacts[j].eta == 0.0:
                        self.forces[j] = push(self.line.contacts[j], overlap, 0.0)
        for j in self.damped:
            if touching[j] and state[1 + j] >= 0.0 <= after[1 + j]:
                self._peak(state, step, base, in_time, j)

    def _peak(
        self, state: list[float], step: IntegrationStep, base: Sequence[float], in_time: Slope, j: int
    ) -> None:
        """The largest force of a damped contact within a step."""

        def growth(y: list[float]) -> float:
            return self._growth(y, in_time(y[0], y[1:]), j)

        rising, falling = self._growth(state, base, j), growth(step.after)
        self.evaluations += 1
        if rising > 0.0 >= falling:
            best, spent = maximum_between(rising, falling, step.part_way, growth)
            self.evaluations += spent
            force = push(self.line.contacts[j], best[1 + j], closing_speed(self.line, best, j))
            self.forces[j] = max(self.forces[j], force)

    def _growth(self, state: Sequence[float], slope: Sequence[float], j: int) -> float:
        """How fast the force of a damped contact grows."""
        contact, count = self.line.contacts[j], len(self.overlaps)
        stiffness = contact.k * contact.q * state[1 + j] ** (contact.q - 1.0) if state[1 + j] > 0.0 else 0.0
        return stiffness * closing_speed(self.line, state, j) + contact.eta * (
            slope[count + j] - slope[count + j + 1]
        )


def largest_overlap(step: IntegrationStep, j: int) -> tuple[float, int]:
    """The largest overlap of a contact within a step in which its closing speed falls through zero; and the evaluations spent.

    A cubic through the closing speeds at both ends says where; there the overlap still missing is speed^2/(2 deceleration).
    """
    left = len(step.before) // 2 + j
    last = beside(step.variable, step.after)
    before, after = step.before[left] - step.before[left + 1], last[left] - last[left + 1]
    end = step.slope(step.x + step.h, last)
    rise, fall = step.first[left] - step.first[left + 1], end[left] - end[left + 1]
    part, least, spent = _zero(before, after, step.h * rise, step.h * fall), 3e-5 * max(before, -after), 1
    overlap = 0.0
    for _ in range(4):
        state = step.part_way(part)
        speed = state[left + 1] - state[left + 2]
        slopes = step.slope(step.x + part * step.h, beside(step.variable, state))
        growth, stretch = (
            slopes[left] - slopes[left + 1],
            1.0 if step.variable.contact is None else slopes[step.variable.contact],
        )
        overlap = state[1 + j] - (0.5 * speed * speed * stretch / growth if growth * stretch < 0.0 else 0.0)
        spent += EVALUATIONS + 1
        if abs(speed) <= least or growth * step.h >= 0.0:
            break
        part = min(max(part - speed / (growth * step.h), 0.0), 1.0)
    return overlap, spent


def _zero(before: float, after: float, rise: float, fall: float) -> float:
    """Where in 0..1 the cubic with these ends and slopes falls through zero; by halving, for it may be crooked."""
    low, high = 0.0, 1.0
    for _ in range(16):
        s = 0.5 * (low + high)
        rest = 1.0 - s
        value = rest * rest * ((1.0 + 2.0 * s) * before + s * rise) + s * s * (
            (3.0 - 2.0 * s) * after - rest * fall
        )
        low, high = (s, high) if value > 0.0 else (low, s)
    return 0.5 * (low + high)


def maximum_between(
    before: float,
    after: float,
    part_way: Callable[[float], list[float]],
    growth: Callable[[list[float]], float],
) -> tuple[list[float], int]:
    """The state within a step where `growth` falls through zero, and the evaluations spent.

    A maximum is flat, so half the digits of its place give all those of its height.
    """
    left, right, held, spent = 0.0, 1.0, 0, 0
    top, place = part_way(1.0), 1.0
    for _ in range(12):
        last, place = place, left + (right - left) * before / (before - after)
        top = part_way(place)
        spent += EVALUATIONS
        here = growth(top)
        if here == 0.0 or abs(place - last) < 1e-9:
            break
        # Illinois: an end that stays twice counts half, so that both ends move.
        if here > 0.0:
            left, before, after, held = place, here, after * (0.5 if held > 0 else 1.0), 1
        else:
            right, after, before, held = place, here, before * (0.5 if held < 0 else 1.0), -1
    return top, spent
