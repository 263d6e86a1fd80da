"""Many motions of one kind in one call: tables with a line for each, which a kernel follows one after another."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.integrate import both_ways
from corollary.scenes.progress import tell

MOST_PARTS = 100
"""In so many parts at most are lines followed, and after each it is told how far that is."""


def follow_lines(module: str, arrays: list[NDArray], *rest: Any, room: tuple[int, int]) -> int:
    """The kernel `follow_each` of a module on tables with a line for each motion, and rows that serve all; it changes them.

    Compiled where that is allowed, else in plain Python on lists that are written back. Gives the evaluations of all.
    """
    kernel, compiled = _kernel(module)
    empty, spent, count = np.zeros(room), 0, len(arrays[0])
    parts = min(MOST_PARTS, count)
    for done in range(parts):
        lines = slice(count * done // parts, count * (done + 1) // parts)
        some = [array[lines] if array.ndim > 1 else array for array in arrays]
        if compiled:
            spent += kernel(*some, *rest, empty)
        else:
            lists = [array.tolist() for array in some]
            spent += kernel(*lists, *rest, empty.tolist())
            for array, changed in zip(some, lists, strict=True):
                array[...] = changed
        tell((done + 1) / parts)
    return spent


def _kernel(module: str) -> tuple[Any, bool]:
    if both_ways.available():
        with suppress(ImportError):  # numba may be there and broken
            return both_ways.compiled(module).follow_each, True
    return both_ways.as_written(module).follow_each, False
