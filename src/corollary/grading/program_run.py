"""Results of a student's program for a part's judge: values of its functions, and the figures drawn."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from corollary.sandbox.job import CallResult, Figure


@dataclass(frozen=True, slots=True)
class ProgramRun:
    """What running the notebook brought for one code or plot part; `calls` by the key of each call.

    `figures` are those of the part's own cell, `elsewhere` those of cells that were meant for no figure, `of_others` those of
    other parts' cells.
    """

    calls: Mapping[str, CallResult] = field(default_factory=dict[str, CallResult])
    figures: tuple[Figure, ...] = ()
    ran: bool = False
    elsewhere: tuple[Figure, ...] = ()
    of_others: tuple[Figure, ...] = ()
