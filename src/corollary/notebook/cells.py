"""The cells of a worksheet: what is read, what is filled in, what is graded; with the metadata nbgrader knows them by."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from html import escape
from typing import Literal

from nbformat import NotebookNode

DRAWING = re.compile(r"!\[([^\]]*)\]\((data:image/svg\+xml;base64,[^)\s]*)\)")


def reading_cell(grade_id: str, source: str) -> NotebookNode:
    """Markdown to be read, and locked; a drawing in it stands as a tag of HTML: VS Code's Markdown shows none otherwise."""
    return _cell("markdown", grade_id, DRAWING.sub(_as_tag, source), locked=True)


def program_cell(grade_id: str, source: str, *, folded: bool = False) -> NotebookNode:
    """Code that belongs to the worksheet, and is locked; `folded` away unless somebody wants to see it."""
    cell = _cell("code", grade_id, source, locked=True)
    if folded:
        cell.metadata["jupyter"] = NotebookNode(source_hidden=True)
        cell.metadata["tags"] = ["hide-input"]  # the same, for Jupyter Book
    return cell


def answer_cell(grade_id: str, source: str) -> NotebookNode:
    """Code that a student writes; its points stand on the check cell below it."""
    return _cell("code", grade_id, source, solution=True)


def graded_cell(grade_id: str, source: str, points: float) -> NotebookNode:
    """The locked cell that carries the points of the answer above it."""
    return _cell("code", grade_id, source, locked=True, points=points)


def written_cell(grade_id: str, source: str, points: float) -> NotebookNode:
    """Markdown that a student writes and a person marks."""
    return _cell("markdown", grade_id, source, solution=True, points=points)


def _as_tag(drawing: re.Match[str]) -> str:
    words, address = drawing.groups()
    return f'<img alt="{escape(words)}" src="{address}">'


def _cell(
    kind: Literal["code", "markdown"],
    grade_id: str,
    source: str,
    *,
    locked: bool = False,
    solution: bool = False,
    points: float | None = None,
) -> NotebookNode:
    """Put together by hand: nbformat's own makers check every cell against the schema, and so does the file's writer."""
    graded = {} if points is None else {"points": points}
    mark = NotebookNode(
        schema_version=3,
        grade_id=grade_id,
        grade=points is not None,
        solution=solution,
        locked=locked,
        task=False,
        cell_type=kind,
        checksum=_digest(source, kind, points is not None, solution, locked, grade_id, points),
        **graded,
    )
    uneditable = {"editable": False} if locked else {}
    metadata = NotebookNode(nbgrader=mark, deletable=False, **uneditable)
    not_run = {"execution_count": None, "outputs": []} if kind == "code" else {}
    return NotebookNode(cell_type=kind, id=grade_id, metadata=metadata, source=source, **not_run)


def as_handed_out(theirs: NotebookNode, ours: NotebookNode) -> bool:
    """Whether a cell that came back still has the checksum of its own text, as every cell of every worksheet has."""
    mark = theirs.get("metadata", {}).get("nbgrader")
    if not isinstance(mark, Mapping) or theirs.cell_type != ours.cell_type:
        return False
    return mark.get("checksum") == checksum(NotebookNode(ours | {"source": theirs.source}))


def checksum(cell: NotebookNode) -> str:
    """nbgrader's fingerprint of a cell, by which it sees that one was changed (a detector; it protects nothing)."""
    mark = cell.metadata["nbgrader"]
    points = float(mark["points"]) if mark["grade"] else None
    flags = mark["grade"], mark["solution"], mark["locked"]
    return _digest(cell.source, cell.cell_type, *flags, mark["grade_id"], points)


def _digest(
    source: str, kind: str, grade: bool, solution: bool, locked: bool, grade_id: str, points: float | None
) -> str:
    words = f"{source}{kind}{grade}{solution}{locked}{grade_id}{'' if points is None else float(points)}"
    return hashlib.md5(words.encode(), usedforsecurity=False).hexdigest()
