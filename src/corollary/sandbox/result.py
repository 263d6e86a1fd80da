"""What one notebook gave: cells that ran or did not, answers as inert data, figures as their lines, and what went wrong."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from corollary.formula.value import Value

Status = Literal["ok", "error", "timeout", "not run"]


@dataclass(frozen=True, slots=True)
class Line:
    """One curve, cloud of points or row of bars: `x` and `y` are equally long, in data coordinates."""

    x: tuple[float, ...]
    y: tuple[float, ...]
    label: str
    kind: Literal["line", "points", "bars"]


@dataclass(frozen=True, slots=True)
class Axes:
    """One pair of axes as drawn: the labels as typed, the limits, the scales ("linear", "log"…), the legend's entries."""

    title: str
    xlabel: str
    ylabel: str
    xlim: tuple[float, float]
    ylim: tuple[float, float]
    xscale: str
    yscale: str
    legend: tuple[str, ...]
    lines: tuple[Line, ...]


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure shown by the cell with id `cell`; `png` is None when no picture was wanted or none could be drawn."""

    cell: str
    axes: tuple[Axes, ...]
    png: bytes | None


@dataclass(frozen=True, slots=True)
class CellRun:
    """How one cell fared: its outputs as nbformat 4 dicts, and its error in one line ("" when there is none)."""

    id: str
    status: Status
    outputs: tuple[dict[str, object], ...]
    seconds: float
    error: str


@dataclass(frozen=True, slots=True)
class Answered:
    """What a called function returned and printed; `trouble` is "" or a sentence on why there is no value."""

    value: Value
    output: str
    trouble: str


@dataclass(frozen=True, slots=True)
class Isolation:
    """Which walls stood around the notebook.

    Level 3: namespaces, Landlock, seccomp and rlimits. Level 2: seccomp, rlimits and one of the other two. Level 1: one wall
    beside rlimits. Level 0: rlimits only, not fit for strangers' work. `missing` says what is not in force and why.
    """

    level: int
    line: str
    missing: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ExecutionResult:
    """What came back of one job; `trouble` is "" or one sentence on what ended it early."""

    cells: tuple[CellRun, ...]
    values: dict[str, Value]
    calls: dict[str, Answered]
    figures: tuple[Figure, ...]
    isolation: Isolation
    trouble: str
