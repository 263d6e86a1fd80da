"""Integrity of a sheet: another student's notebook, edited statements and checks; reported, never marked."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING

from corollary.messages import catalogue
from corollary.notebook.cells import as_handed_out
from corollary.notebook.locate import cells_by_id, is_of, origin, other_numbers
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.worksheet import Worksheet

if TYPE_CHECKING:
    from nbformat import NotebookNode

_ = catalogue(__name__)
MOST_NAMED = 4


def notes(sheet: Worksheet, notebook: NotebookNode) -> tuple[str, ...]:
    """Sentences for the student (the instructor reads the same) on what is not as it was handed out; empty when all is.

    A cell that is missing is no tampering. A cell that differs from the sheet's but still has the checksum it was handed out with
    comes from another sheet (a friend's, or an older print of one's own): only a changed one is called edited. Of those only the
    ones that ask count, and only where their numbers differ: a deadline that moved, a statement worded better, a figure drawn
    anew, other points, a part more or less and another version of the program accuse nobody.
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
        elif cell.id.endswith(("_statement", "_text")) and other_numbers(theirs.source, cell.source):
            foreign.append(cell.id)
    return tuple(_sentences(sheet, origin(notebook).student, edited, foreign))


def is_unedited(notebook: NotebookNode, released: bytes | None) -> bool:
    """True if every locked cell that came back has the text of the sheet's own file: then there is nothing to note, and the sheet
    need not be made again. False where the file cannot be read."""
    try:
        cells = json.loads(released or b"")["cells"]
        texts = {
            cell["id"]: "".join(cell["source"]) for cell in cells if cell["metadata"]["nbgrader"]["locked"]
        }
    except (ValueError, KeyError, TypeError):
        return False
    found = cells_by_id(notebook)
    return all(_normal(found[name].source) == _normal(text) for name, text in texts.items() if name in found)


def elsewhere(sheet: Worksheet, notebook: NotebookNode) -> str:
    """Why a notebook is not marked as this sheet: it belongs to another set. Empty when it belongs to this one."""
    if is_of(sheet, notebook):
        return ""
    own, other = sheet.problem_set.name, origin(notebook).set_name
    if other:
        return _(
            "The notebook you handed in belongs to {other}, not to {own}, so it was not marked. Hand in your {own}.ipynb.",
            own=own,
            other=other,
        )
    return _(
        "The notebook you handed in holds none of the exercises of {own}, so it was not marked. Hand in your {own}.ipynb.",
        own=own,
    )


def _sentences(sheet: Worksheet, owner: str, edited: list[str], foreign: list[str]) -> Iterator[str]:
    called = {
        f"{prompt.key}{end}": f"{prompt.name}{end}" for prompt in sheet.prompts for end in ("", "_text")
    }
    edited, foreign = ([called.get(name, name) for name in names] for names in (edited, foreign))
    run = {"setup", "check_all", *(prompt.name for prompt in sheet.prompts)}
    if owner and owner != sheet.student.id:
        yield _(
            "The notebook you handed in was made for {owner}. It was marked with the numbers of your own sheet ({own}).",
            owner=owner,
            own=sheet.student.id,
        )
    elif foreign and owner:
        yield _.plural(
            "The cell {cells} is from an earlier version of your sheet, with other numbers than it has now: "
            "your answers were marked with the present numbers.",
            "The cells {cells} are from an earlier version of your sheet, with other numbers than it has now: "
            "your answers were marked with the present numbers.",
            len(foreign),
            cells=_listed(foreign),
        )
    elif foreign:
        yield _.plural(
            "The cell {cells} has other numbers than your sheet: your answers were marked with your own numbers.",
            "The cells {cells} have other numbers than your sheet: your answers were marked with your own numbers.",
            len(foreign),
            cells=_listed(foreign),
        )
    checks = [name for name in edited if name in run]
    texts = [name for name in edited if name not in run]
    if texts:
        yield _.plural(
            "You edited the text in the cell {cells}. Your answers were marked with the numbers on your original sheet.",
            "You edited the text in the cells {cells}. Your answers were marked with the numbers on your original sheet.",
            len(texts),
            cells=_listed(texts),
        )
    if checks:
        yield _.plural(
            "You edited the cell {cells}. A check only shows how an answer is read, so this does not change your points.",
            "You edited the cells {cells}. A check only shows how an answer is read, so this does not change your points.",
            len(checks),
            cells=_listed(checks),
        )


def _listed(names: list[str]) -> str:
    """The first few by name."""
    words = ", ".join(names[:MOST_NAMED])
    more = len(names) - MOST_NAMED
    return _("{names} and {more} more", names=words, more=more) if more > 0 else words


def _normal(source: object) -> str:
    """The text but for what editors change by themselves: ends of lines and blanks behind them."""
    return "\n".join(line.rstrip() for line in str(source).strip().splitlines())
