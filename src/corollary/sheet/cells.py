"""The cells of a sheet: what is read, what is filled in, what is graded; with the metadata nbgrader knows them by."""

from __future__ import annotations

import hashlib

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell


def reading_cell(id: str, source: str) -> NotebookNode:
    """Markdown to be read, and locked."""
    cell = new_markdown_cell(source, id=id)
    return _marked(cell, id, locked=True)


def program_cell(id: str, source: str, *, folded: bool = False) -> NotebookNode:
    """Code that belongs to the sheet, and is locked; `folded` away unless somebody wants to see it."""
    cell = new_code_cell(source, id=id)
    if folded:
        cell.metadata["jupyter"] = {"source_hidden": True}
        cell.metadata["tags"] = ["hide-input"]  # the same, for Jupyter Book
    return _marked(cell, id, locked=True)


def answer_cell(id: str, source: str) -> NotebookNode:
    """Code that a student writes; its points stand on the check cell below it."""
    return _marked(new_code_cell(source, id=id), id, solution=True)


def graded_cell(id: str, source: str, points: float) -> NotebookNode:
    """The locked cell that carries the points of the answer above it."""
    return _marked(new_code_cell(source, id=id), id, locked=True, points=points)


def written_cell(id: str, source: str, points: float) -> NotebookNode:
    """Markdown that a student writes and a person marks."""
    return _marked(new_markdown_cell(source, id=id), id, solution=True, points=points)


def _marked(
    cell: NotebookNode, id: str, *, locked: bool = False, solution: bool = False, points: float | None = None
) -> NotebookNode:
    cell.metadata["nbgrader"] = {
        "schema_version": 3,
        "grade_id": id,
        "grade": points is not None,
        "solution": solution,
        "locked": locked,
        "task": False,
        "cell_type": cell.cell_type,
    }
    if points is not None:
        cell.metadata["nbgrader"]["points"] = points
    cell.metadata["deletable"] = False
    if locked:
        cell.metadata["editable"] = False
    cell.metadata["nbgrader"]["checksum"] = checksum(cell)
    return cell


def checksum(cell: NotebookNode) -> str:
    """nbgrader's fingerprint of a cell, by which it sees that one was changed (a detector; it protects nothing)."""
    mark = cell.metadata["nbgrader"]
    words = [cell.source, cell.cell_type, str(mark["grade"]), str(mark["solution"]), str(mark["locked"]), mark["grade_id"]]
    if mark["grade"]:
        words.append(str(float(mark["points"])))
    return hashlib.md5("".join(words).encode(), usedforsecurity=False).hexdigest()
