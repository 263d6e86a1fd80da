"""What became of a sheet on its way: another student's notebook, edited statements and checks; reported, never marked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from corollary.messages import catalogue
from corollary.notebook.cells import as_handed_out
from corollary.notebook.locate import cells_by_id
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.worksheet import Worksheet

if TYPE_CHECKING:
    from nbformat import NotebookNode

_ = catalogue(__name__)
MOST_NAMED = 4


def notes(sheet: Worksheet, notebook: NotebookNode) -> tuple[str, ...]:
    """Sentences for the student and the instructor on what is not as it was handed out; empty when all is.

    A cell that is missing is no tampering. A cell that differs from the sheet's but still has the checksum it was handed out with
    comes from another sheet (a friend's, or an older print of one's own): only a changed one is called edited. A figure as it was
    handed out says nothing about whose it is: its numbers stand in the statement too, and how it is drawn may change in a term.
    """
    found = cells_by_id(notebook)
    edited: list[str] = []
    foreign: list[str] = []
    for cell in handed_out(sheet).cells:
        theirs = found.get(cell.id)
        locked = cell.metadata["nbgrader"]["locked"]
        if not locked or theirs is None or _normal(theirs.source) == _normal(cell.source):
            continue
        if not as_handed_out(theirs, cell):
            edited.append(cell.id)
        elif cell.id != "title" and not cell.id.endswith("_figure"):
            foreign.append(cell.id)
    return tuple(_sentences(sheet, _owner(notebook), edited, foreign))


def _sentences(sheet: Worksheet, owner: str, edited: list[str], foreign: list[str]) -> Iterator[str]:
    if owner and owner != sheet.student.id:
        yield _(
            "This notebook was made for {owner}, not for {own}: it was marked with {own}'s own numbers.",
            owner=owner,
            own=sheet.student.id,
        )
    elif foreign:
        yield _.plural(
            "The cell {cells} is not from this student's sheet (somebody else's, or an older one): "
            "everything was marked with the student's own numbers.",
            "The cells {cells} are not from this student's sheet (somebody else's, or an older one): "
            "everything was marked with the student's own numbers.",
            len(foreign),
            cells=_listed(foreign),
        )
    run = {"setup", "check_all", *(prompt.key for prompt in sheet.prompts)}
    checks = [name for name in edited if name in run]
    texts = [name for name in edited if name not in run]
    if texts:
        yield _.plural(
            "The cell {cells} is edited: everything was marked with the numbers that were handed out.",
            "The cells {cells} are edited: everything was marked with the numbers that were handed out.",
            len(texts),
            cells=_listed(texts),
        )
    if checks:
        yield _.plural(
            "The cell {cells} is edited; checks only say how an answer is read, so this earns nothing and costs nothing.",
            "The cells {cells} are edited; checks only say how an answer is read, so this earns nothing and costs nothing.",
            len(checks),
            cells=_listed(checks),
        )


def _listed(names: list[str]) -> str:
    """The first few by name."""
    words = ", ".join(names[:MOST_NAMED])
    more = len(names) - MOST_NAMED
    return _("{names} and {more} more", names=words, more=more) if more > 0 else words


def _owner(notebook: NotebookNode) -> str:
    """The student a notebook says it was made for; "" when it says nothing that could be one."""
    about = notebook.get("metadata", {}).get("corollary")
    owner = about.get("student") if isinstance(about, Mapping) else None
    return owner[:100] if isinstance(owner, str) and owner.isprintable() else ""


def _normal(source: object) -> str:
    """The text but for what editors change by themselves: ends of lines and blanks behind them."""
    return "\n".join(line.rstrip() for line in str(source).strip().splitlines())
