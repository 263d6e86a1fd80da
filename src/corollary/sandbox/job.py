"""The job of one notebook, and its result: cells, answers as inert data, figures as lines and labels, and errors."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Literal

import msgspec

from corollary.formula.value import Value
from corollary.sandbox.isolation import Isolation

Argument = float | int | tuple[float, ...] | str


@dataclass(frozen=True, slots=True)
class Cell:
    """One code cell to run, in its order; `id` is the notebook cell's id. `again`: where it stops at a name that no cell above it
    makes and another one does, it may be run a second time after all others."""

    id: str
    source: str
    again: bool = False


@dataclass(frozen=True, slots=True)
class FunctionCall:
    """A call of the student's function, made after all cells have run.

    `key` names the call in the result ("P12.14.h/0") and stays outside; the worker gets the function's name, the seconds,
    and the arguments, each passed by keyword.
    """

    key: str
    function: str
    arguments: tuple[tuple[str, Argument], ...]
    seconds: float = 10.0


@dataclass(frozen=True, slots=True)
class Job:
    """One notebook's work: `names` are the variables to bring back.

    With `pictures` each figure that was shown is also drawn as PNG, which costs more than all the rest together; that is
    done last, when every answer is out, so a figure that was changed after it was shown is drawn as it was in the end (its
    data are as shown), and its output says so.
    """

    cells: tuple[Cell, ...]
    names: tuple[str, ...]
    calls: tuple[FunctionCall, ...] = ()
    pictures: bool = True


@dataclass(frozen=True, slots=True)
class Limits:
    """What one notebook may use: seconds of wall clock, bytes of memory above the bare interpreter, bytes shown per cell,
    bytes on disk. It may start no process."""

    cell_seconds: float = 20.0
    total_seconds: float = 120.0
    memory_bytes: int = 1 << 30
    output_bytes: int = 1 << 20
    file_bytes: int = 16 << 20


Status = Literal["ok", "error", "timeout", "ended", "killed", "not run"]
"""`ended`: the process died in the cell; `killed`: by the signal that too much memory is answered with."""

# What a worker describes at most (worker/figures.py): a frame with more is forged.
_Points = Annotated[tuple[float, ...], msgspec.Meta(max_length=5_000)]
_Words = Annotated[str, msgspec.Meta(max_length=500)]


@dataclass(frozen=True, slots=True)
class DrawnLine:
    """One curve, cloud of points or row of bars: `x` and `y` are equally long, in data coordinates."""

    x: _Points
    y: _Points
    label: _Words
    kind: Literal["line", "points", "bars"]


@dataclass(frozen=True, slots=True)
class Axes:
    """One pair of axes as drawn: the labels as typed, the limits, the scales ("linear", "log"…), the legend's entries."""

    title: _Words
    xlabel: _Words
    ylabel: _Words
    xlim: tuple[float, float]
    ylim: tuple[float, float]
    xscale: _Words
    yscale: _Words
    legend: Annotated[tuple[_Words, ...], msgspec.Meta(max_length=60)]
    lines: Annotated[tuple[DrawnLine, ...], msgspec.Meta(max_length=60)]


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure shown by the cell with id `cell`; `png` is None when no picture was wanted or none could be drawn."""

    cell: str
    axes: tuple[Axes, ...]
    png: bytes | None


@dataclass(frozen=True, slots=True)
class CellRun:
    """How one cell ended: its outputs as nbformat 4 dicts, and its error in one line ("" when there is none)."""

    id: str
    status: Status
    outputs: tuple[dict[str, object], ...]
    seconds: float
    error: str


@dataclass(frozen=True, slots=True)
class CallResult:
    """What a called function returned and printed; `trouble` is "" or a sentence on why there is no value, `error` the error that it
    raised, in one line."""

    value: Value
    output: str
    trouble: str
    error: str = ""


@dataclass(frozen=True, slots=True)
class ExecutionResult:
    """What came back of one job; `trouble` is "" or one sentence on what ended it early. `again` has the answers that appeared only
    when a cell was run a second time, by the cell's index; that run stands in `cells`.

    With `machine_failed` the notebook was not run to its end for no reason of its own (no room on the disk, a process that
    could not be started or was killed from outside): nothing may be concluded from what is missing.
    """

    cells: tuple[CellRun, ...]
    values: dict[str, Value]
    calls: dict[str, CallResult]
    figures: tuple[Figure, ...]
    isolation: Isolation
    trouble: str
    machine_failed: bool = False
    again: dict[int, dict[str, Value]] = field(default_factory=dict[int, dict[str, Value]])
