"""The job of one notebook: cells to run, answers to bring back, functions to call, and limits of use."""

from __future__ import annotations

from dataclasses import dataclass

Argument = float | int | tuple[float, ...] | str


@dataclass(frozen=True, slots=True)
class Cell:
    """One code cell to run, in its order; `id` is the notebook cell's id."""

    id: str
    source: str


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
