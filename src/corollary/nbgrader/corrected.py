"""A set that was corrected after work on it was recorded: nbgrader takes no cell more or less then, so both sides are met.

Parts that are new get their cells in the gradebook, and parts that are gone stay in the source: their marks hold. What a part is
out of, which is one number for everybody there, stays until somebody agrees to other marks.
"""

# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.
# pyright: reportAttributeAccessIssue=false, reportArgumentType=false, reportCallIssue=false

from __future__ import annotations

from copy import deepcopy
from typing import TYPE_CHECKING

from nbformat import NotebookNode

from corollary.notebook.cells import answer_cell, graded_cell, written_cell

if TYPE_CHECKING:
    from nbgrader.api import Gradebook, Notebook

GONE = "This part is not asked any more; marks that it was given stay."


def brought_together(
    book: Gradebook, set_name: str, source: NotebookNode, *, agreed: bool = False
) -> NotebookNode:
    """The source with the cells of parts that are gone, once the gradebook has the cells of those that are new; parts are out of
    what the gradebook has them out of, or of what they are out of now if that is `agreed` to.

    As it is when nothing has been handed in: then nbgrader makes its cells anew itself.
    """
    from nbgrader.api import MissingEntry

    try:
        notebook = book.find_notebook(set_name, set_name)
    except MissingEntry:
        return source
    if not notebook.submissions:
        return source
    _add_new(book, notebook, source)
    return _with_gone(notebook, source if agreed else _as_agreed(notebook, source))


def _add_new(book: Gradebook, notebook: Notebook, source: NotebookNode) -> None:
    """Cells of new parts, with a row for everybody whose work is recorded."""
    from nbgrader.api import Comment, Grade, GradeCell, SolutionCell, SourceCell

    grades, solutions, sources = (
        {cell.name: cell for cell in cells}
        for cells in (notebook.grade_cells, notebook.solution_cells, notebook.source_cells)
    )
    marks = {cell.id: (cell, cell.metadata["nbgrader"]) for cell in source.cells}
    for name, (cell, mark) in marks.items():
        if mark["grade"] and name not in grades:
            new = GradeCell(
                name=name, notebook=notebook, cell_type=cell.cell_type, max_score=float(mark["points"])
            )
            book.db.add_all([new, *(Grade(cell=new, notebook=each) for each in notebook.submissions)])
        if mark["solution"] and name not in solutions:
            new = SolutionCell(name=name, notebook=notebook)
            book.db.add_all([new, *(Comment(cell=new, notebook=each) for each in notebook.submissions)])
        if name not in sources:
            book.db.add(
                SourceCell(name=name, notebook=notebook, cell_type=cell.cell_type, locked=mark["locked"])
            )
    for name, cell in sources.items():
        if name not in marks and name not in grades and name not in solutions:
            book.db.delete(cell)  # words only: a figure that is gone, a question
    book.db.commit()


def _as_agreed(notebook: Notebook, source: NotebookNode) -> NotebookNode:
    maxima, found = {cell.name: cell.max_score for cell in notebook.grade_cells}, deepcopy(source)
    for cell in found.cells:
        mark = cell.metadata["nbgrader"]
        if mark["grade"]:
            mark["points"] = maxima.get(cell.id, mark["points"])
    return found


def _with_gone(notebook: Notebook, source: NotebookNode) -> NotebookNode:
    here = {cell.id for cell in source.cells}
    solutions = {cell.name for cell in notebook.solution_cells}
    graded = {cell.name: cell for cell in notebook.grade_cells}
    gone: list[NotebookNode] = [
        answer_cell(name, "") for name in sorted(solutions) if name not in here and name not in graded
    ]
    for name, cell in graded.items():
        if name not in here and name in solutions:
            gone.append(written_cell(name, GONE, cell.max_score))
        elif name not in here:
            gone.append(graded_cell(name, f"# {GONE}", cell.max_score))
    return NotebookNode(source | {"cells": [*source.cells, *gone]})
