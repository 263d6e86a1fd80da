"""What became of a sheet on its way: another student's notebook, edited statements and checks; told, never marked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from corollary.notebook.cells import as_handed_out
from corollary.notebook.locate import cells_by_id
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.worksheet import Worksheet

if TYPE_CHECKING:
    from nbformat import NotebookNode

MOST_NAMED = 4


def notes(sheet: Worksheet, notebook: NotebookNode) -> tuple[str, ...]:
    """Sentences for the student and the instructor on what is not as it was handed out; empty when all is.

    A cell that is missing is no tampering. A cell that differs from the sheet's but still has the checksum it was handed out with
    comes from another sheet (a friend's, or an older print of one's own): only a changed one is called edited.
    """
    found = cells_by_id(notebook)
    edited, foreign = [], []
    for cell in handed_out(sheet).cells:
        theirs = found.get(cell.id)
        if (
            not cell.metadata["nbgrader"]["locked"]
            or theirs is None
            or _plain(theirs.source) == _plain(cell.source)
        ):
            continue
        (foreign if as_handed_out(theirs, cell) else edited).append(cell.id)
    return tuple(_said(sheet, _owner(notebook), edited, foreign))


def _said(sheet: Worksheet, owner: str, edited: list[str], foreign: list[str]):
    if owner and owner != sheet.student.id:
        own = sheet.student.id
        yield f"This notebook was made for {owner}, not for {own}: it was marked with {own}'s own numbers."
    elif foreign:
        yield (
            f"{_named(foreign)} not from this student's sheet (somebody else's, or an older one): "
            "everything was marked with the student's own numbers."
        )
    checks = [id for id in edited if not _is_text(id, sheet)]
    texts = [id for id in edited if _is_text(id, sheet)]
    if texts:
        yield f"{_named(texts)} edited: everything was marked with the numbers that were handed out."
    if checks:
        yield f"{_named(checks)} edited; checks only say how an answer is read, so this earns nothing and costs nothing."


def _named(ids: list[str]) -> str:
    """The cells by name, and the verb that goes with them."""
    words = ", ".join(ids[:MOST_NAMED]) + (
        f" and {len(ids) - MOST_NAMED} more" if len(ids) > MOST_NAMED else ""
    )
    return f"The cell {words} is" if len(ids) == 1 else f"The cells {words} are"


def _is_text(id: str, sheet: Worksheet) -> bool:
    """Whether a cell is read rather than run."""
    return id not in {"setup", "check_all", *(prompt.key for prompt in sheet.prompts)}


def _owner(notebook: NotebookNode) -> str:
    """The student a notebook says it was made for; "" when it says nothing that could be one."""
    about = notebook.get("metadata", {}).get("corollary")
    said = about.get("student") if isinstance(about, Mapping) else None
    return said[:100] if isinstance(said, str) and said.isprintable() else ""


def _plain(source: str) -> str:
    """The text but for what editors change by themselves: ends of lines and blanks behind them."""
    return "\n".join(line.rstrip() for line in str(source).strip().splitlines())
