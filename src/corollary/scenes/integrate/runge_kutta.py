"""One explicit Runge-Kutta step, whatever the table of coefficients."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import mul

Slope = Callable[[float, Sequence[float]], Sequence[float]]
"""The rate of change of the state, given x and the state."""


@dataclass(frozen=True, slots=True)
class Coefficients:
    """A weighted sum of earlier slopes; only the slopes that count are named."""

    stages: tuple[int, ...]
    weights: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Tableau:
    """An explicit method: row i gives the state at which slope i is taken, `result` the state after the step.

    `estimates` are sums of slopes that vanish for an exact step (differences from embedded methods), the most sensitive first; a
    method without any does not estimate its own error.
    """

    order: int
    nodes: tuple[float, ...]
    rows: tuple[Coefficients, ...]
    result: Coefficients
    estimates: tuple[Coefficients, ...] = ()


def weighted(row: Coefficients, slopes: Sequence[Sequence[float]]) -> list[float]:
    """The sum the row stands for, component by component."""
    return [
        sum(map(mul, row.weights, column)) for column in zip(*[slopes[i] for i in row.stages], strict=True)
    ]


def step(
    table: Tableau, slope: Slope, x: float, y: Sequence[float], h: float, first: Sequence[float]
) -> tuple[list[float], list[Sequence[float]]]:
    """The state after a step h from (x, y), and the slopes met on the way; `first` is the slope at (x, y)."""
    slopes: list[Sequence[float]] = [first]
    for node, row in zip(table.nodes[1:], table.rows[1:], strict=True):
        slopes.append(slope(x + node * h, [a + h * b for a, b in zip(y, weighted(row, slopes), strict=True)]))
    return [a + h * b for a, b in zip(y, weighted(table.result, slopes), strict=True)], slopes
