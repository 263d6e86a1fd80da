"""The largest overlap and the largest force of each contact, found between the steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from corollary.scene.force.contact import push
from corollary.scene.line import Line
from corollary.scene.method.line_motion import Law, closing_acceleration, closing_speed


class Crests:
    """Keeps the greatest overlap and force met by each contact; told of every step of a motion."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.overlaps = [max(-gap, 0.0) for gap in line.gaps]
        self.forces = [0.0] * len(line.gaps)
        self.evaluations = 0

    def onset(self, state: Sequence[float], touching: Sequence[bool]) -> None:
        """A damped contact pushes at once when it closes: that may already be its largest force."""
        for j, on in enumerate(touching):
            if on and state[1 + j] >= 0.0:
                force = push(self.line.contacts[j], state[1 + j], closing_speed(self.line, state, j))
                self.forces[j] = max(self.forces[j], force)

    def passed(
        self,
        old: Sequence[float],
        new: Sequence[float],
        touching: Sequence[bool],
        base: Sequence[float],
        in_time: Law,
        part_way: Callable[[float], list[float]],
    ) -> None:
        """Look for a crest between two states; `part_way` gives the state after a part (0 to 1) of the step."""
        for j, on in enumerate(touching):
            if not on or old[1 + j] < 0.0 or new[1 + j] < 0.0:
                continue
            before, after = closing_speed(self.line, old, j), closing_speed(self.line, new, j)
            if before > 0.0 >= after:
                top, spent = top_between(before, after, part_way, lambda y, j=j: closing_speed(self.line, y, j))
                self.evaluations += spent
                self.overlaps[j] = max(self.overlaps[j], top[1 + j])
                if self.line.contacts[j].eta == 0.0:
                    self.forces[j] = max(self.forces[j], push(self.line.contacts[j], top[1 + j], 0.0))
            if self.line.contacts[j].eta > 0.0:
                rising = self._growth(old, base, j)
                self.evaluations += 1
                falling = self._growth(new, in_time(new), j)
                if rising > 0.0 >= falling:
                    top, spent = top_between(rising, falling, part_way, lambda y, j=j: self._growth(y, in_time(y), j))
                    self.evaluations += spent
                    force = push(self.line.contacts[j], top[1 + j], closing_speed(self.line, top, j))
                    self.forces[j] = max(self.forces[j], force)

    def _growth(self, state: Sequence[float], slope: Sequence[float], j: int) -> float:
        """How fast the force of a damped contact grows."""
        contact, rate = self.line.contacts[j], closing_speed(self.line, state, j)
        stiffness = contact.k * contact.q * state[1 + j] ** (contact.q - 1.0) if state[1 + j] > 0.0 else 0.0
        return stiffness * rate + contact.eta * closing_acceleration(self.line, slope, j)


def top_between(
    before: float, after: float, part_way: Callable[[float], list[float]], growth: Callable[[list[float]], float]
) -> tuple[list[float], int]:
    """The state within a step where `growth` falls through zero, and the evaluations spent.

    A crest is flat, so half the digits of its place give all those of its height.
    """
    left, right, held, spent = 0.0, 1.0, 0, 12
    top, place = part_way(1.0), 1.0
    for _ in range(12):
        last, place = place, left + (right - left) * before / (before - after)
        top = part_way(place)
        spent += 12
        here = growth(top)
        if here == 0.0 or abs(place - last) < 1e-9:
            break
        # Illinois: an end that stays twice counts half, so that both ends move.
        if here > 0.0:
            left, before, after, held = place, here, after * (0.5 if held > 0 else 1.0), 1
        else:
            right, after, before, held = place, here, before * (0.5 if held < 0 else 1.0), -1
    return top, spent
