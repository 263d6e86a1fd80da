"""A Runge-Kutta step written out term by term for a fixed number of variables: the same sums as the table's, without a loop.

The text is made from the table alone and compiled once; a step then costs a tenth of one that walks through the table.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

from corollary.scenes.integrate.runge_kutta import Coefficients, Tableau

Slope = Callable[[float, Sequence[float]], Sequence[float]]
StepFunction = Callable[
    [Slope, float, float, Sequence[float], Sequence[float]], tuple[Sequence[float], float, float]
]
"""(slope, x, h, y, first) to the state after the step and the sums of squares of both doubts; `first` is the slope at (x, y)."""


@lru_cache(maxsize=32)
def written_out(table: Tableau, count: int) -> StepFunction:
    """The step of a table with two doubts, for `count` variables."""
    return from_text(step_text(table, count), "step", {})


def from_text(text: str, name: str, known: dict[str, Any]) -> Any:
    """The function of this name that the text defines; the text is only ever our own."""
    space = dict(known)
    exec(compile(text, f"<{name} written out>", "exec"), space)
    return space[name]


def step_text(table: Tableau, count: int) -> str:
    """The step as Python: one line for every slope."""
    places = range(count)
    lines = [
        "def step(slope, x, h, y, first):",
        f"    {_names('y', places)} = y",
        f"    {_names('a', places)} = first",
    ]
    for stage, (node, row) in enumerate(zip(table.nodes, table.rows, strict=True)):
        if stage:
            state = "".join(f"y{i} + h * ({_sum(row, i)}), " for i in places)
            lines.append(f"    {_names(_letter(stage), places)} = slope(x + {node!r} * h, ({state}))")
    lines += [f"    z{i} = {_sum(table.result, i)}" for i in places]
    after = "".join(f"y{i} + h * z{i}, " for i in places)
    squares = [" + ".join(f"({_doubt(table, row, i)}) ** 2" for i in places) for row in table.doubts]
    return "\n".join([*lines, f"    return ({after}), {', '.join(squares)}"])


def _doubt(table: Tableau, row: Coefficients, place: int) -> str:
    """A doubt; as its difference from the result where that has fewer terms."""
    weights = dict(zip(row.stages, row.weights, strict=True))
    apart = {
        s: b - weights.get(s, 0.0) for s, b in zip(table.result.stages, table.result.weights, strict=True)
    }
    apart = {s: weight for s, weight in apart.items() if abs(weight) > 1e-15}
    if len(apart) < len(row.stages) and weights.keys() <= set(table.result.stages):
        return f"z{place} - ({_sum(Coefficients(tuple(apart), tuple(apart.values())), place)})"
    return _sum(row, place)


def _letter(stage: int) -> str:
    return "abcdefgijklmnopqrstu"[stage]


def _names(letter: str, places: range) -> str:
    return "".join(f"{letter}{i}, " for i in places)


def _sum(row: Coefficients, place: int) -> str:
    return " + ".join(
        f"{weight!r} * {_letter(stage)}{place}" for stage, weight in zip(row.stages, row.weights, strict=True)
    )
