"""Newton's second law for bodies in a row.

The state is (time, overlaps, velocities). Gaps and not positions are the unknowns: nothing cancels however hard the bodies are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from corollary.scene.force.contact import push
from corollary.scene.line import Line

Law = Callable[[Sequence[float]], list[float]]


def overlaps(line: Line, state: Sequence[float]) -> Sequence[float]:
    return state[1 : len(line.masses)]


def velocities(line: Line, state: Sequence[float]) -> Sequence[float]:
    return state[len(line.masses) :]


def closing_speed(line: Line, state: Sequence[float], contact: int) -> float:
    """How fast the overlap of a contact grows."""
    left = len(line.masses) + contact
    return state[left] - state[left + 1]


def closing_acceleration(line: Line, slope: Sequence[float], contact: int) -> float:
    """How fast the closing speed grows; `slope` is the state's rate of change."""
    left = len(line.masses) + contact
    return slope[left] - slope[left + 1]


def law_of_motion(line: Line, touching: Sequence[bool]) -> Law:
    """The rate of change of the state; only contacts that touch push."""
    count = len(line.masses)
    inverse = [1.0 / m for m in line.masses]
    falling = [-line.weight if i else 0.0 for i in inverse]
    live = [(j, contact) for j, (contact, on) in enumerate(zip(line.contacts, touching, strict=True)) if on]
    rest = range(count - 1)

    def slope(state: Sequence[float]) -> list[float]:
        speeds = state[count:]
        rates = [speeds[j] - speeds[j + 1] for j in rest]
        gained = falling.copy()
        for j, contact in live:
            overlap = state[1 + j]
            if overlap >= 0.0:
                force = push(contact, overlap, rates[j])
                gained[j] -= force * inverse[j]
                gained[j + 1] += force * inverse[j + 1]
        return [1.0, *rates, *gained]

    return slope
