"""Cells that came back without any name, recognised by what stands in them and by what they follow."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping

from nbformat import NotebookNode

from corollary.notebook.locate import cells_by_id
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.worksheet import Worksheet


def with_names(nb: NotebookNode, sheet: Worksheet) -> NotebookNode:
    """The notebook, its answer cells under the names they were handed out with, as far as they can be told.

    An editor may have dropped metadata and ids alike. Statements and questions are then known by their text, an answer by the
    question that it stands below.
    """
    ours = {cell.id: cell for cell in handed_out(sheet).cells}
    named = cells_by_id(nb)
    if all(name in named for name, cell in ours.items() if cell.metadata["nbgrader"]["solution"]):
        return nb
    known = {id(cell): name for name, cell in named.items() if name in ours}
    cells = [_called(cell, name) if name else cell for cell, name in _recognised(nb.cells, ours, known)]
    return NotebookNode({**nb, "cells": cells})


def _recognised(
    cells: list[NotebookNode], ours: Mapping[str, NotebookNode], known: Mapping[int, str]
) -> Iterator[tuple[NotebookNode, str]]:
    """Each cell and the name it has not got and should have; "" where it has one, or is the student's own."""
    order = list(ours)
    texts, heads = _unique(ours, _words), _unique(ours, _head)
    used, at = set(known.values()), -1
    for cell in cells:
        if name := known.get(id(cell)):
            at = order.index(name)
            yield cell, ""
            continue
        name = texts.get(_words(cell)) or heads.get(_head(cell)) or ""
        if not name and at + 1 < len(order):
            below = ours[order[at + 1]]
            if below.metadata["nbgrader"]["solution"] and below.cell_type == cell.cell_type:
                name = below.id
        if not name or name in used:
            yield cell, ""
            continue
        used.add(name)
        at = order.index(name)
        yield cell, name


def _unique(ours: Mapping[str, NotebookNode], key: Callable[[NotebookNode], str]) -> dict[str, str]:
    """The names of the cells whose key is theirs alone, by that key."""
    keys = {name: key(cell) for name, cell in ours.items() if not cell.metadata["nbgrader"]["solution"]}
    counted = Counter(keys.values())
    return {text: name for name, text in keys.items() if text and counted[text] == 1}


def _words(cell: NotebookNode) -> str:
    return " ".join(str(cell.source).split())


def _head(cell: NotebookNode) -> str:
    """The heading of a question or an exercise, which stays when its text was touched."""
    lines = str(cell.source).splitlines() if cell.cell_type == "markdown" else []
    return next((" ".join(line.split()) for line in lines if line.lstrip().startswith("##")), "")


def _called(cell: NotebookNode, name: str) -> NotebookNode:
    return NotebookNode({**cell, "id": name})
