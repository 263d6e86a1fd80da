"""The marked notebook: the sheet as it was handed out, with the student's answers, what they gave, and what is said of them."""

# pyright: reportUnknownVariableType=false

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell

from corollary.answers.verdict import Unmarked, Unread
from corollary.grading.part_grades import Marked, PartGrade
from corollary.messages import catalogue, in_convention
from corollary.nbgrader.safe import safe_attachments, safe_markdown, safe_outputs
from corollary.notebook.cells import checksum
from corollary.notebook.content import with_names
from corollary.notebook.locate import cells_by_id
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.render.wording import look
from corollary.sandbox.job import CellRun

_ = catalogue(__name__)
NOBODY = Student("")
WRITTEN = "corollary_written"  # where a cell's metadata have an answer that was made harmless in its text
FOLDED_AWAY = "# The code of check() is left out of the marked notebook."


def marked_notebook(marked: Marked, problem_set: ProblemSet, submitted: NotebookNode | None) -> NotebookNode:
    """What formgrader and `corollary mark` show: the student's sheet with their answers, what is said of them, and what a
    person is to mark them by. Nothing of ours in it says whose it is: marking is anonymous."""
    sheet = worksheet(problem_set, NOBODY, (grade.variant for grade in marked.grades))
    nb = restored(sheet, submitted, marked.runs)
    with_verdicts(nb, marked)
    with_rubrics(nb, marked)
    noticed = _("The report has notes on this notebook.") if marked.notes else ""
    remarks = [f"> **{safe_markdown(text)}**" for text in (marked.trouble, noticed) if text]
    nb.cells[1:1] = [
        new_markdown_cell(remark, id=f"remark_{number}") for number, remark in enumerate(remarks)
    ]
    return nb


def with_verdicts(nb: NotebookNode, marked: Marked) -> NotebookNode:
    """The same notebook, whose cells that carry points say what is said of each part."""
    verdicts = dict(part_grades(marked))
    for cell in nb.cells:
        mark = cell.metadata.get("nbgrader")
        if mark and mark["grade"] and not mark["solution"] and cell.id in verdicts:
            cell.outputs = [_verdict(verdicts[cell.id])]
    return nb


def with_rubrics(nb: NotebookNode, marked: Marked) -> None:
    """Below the cell that carries the points of a part which waits for a person: what a good answer says, instead of what it
    said before."""
    verdicts = dict(part_grades(marked))
    earlier = {f"{key}_rubric" for key in verdicts}
    cells: list[NotebookNode] = []
    for cell in nb.cells:
        if cell.get("id", "") in earlier:
            continue
        cells.append(cell)
        grade = verdicts.get(cell.get("id", ""))
        if grade is not None and isinstance(grade.verdict, Unmarked) and grade.verdict.rubric:
            items = "\n".join(f"> - {item}" for item in grade.verdict.rubric)
            heading = _("Rubric ({points} points)", points=in_convention(f"{grade.out_of:g}"))
            cells.append(new_markdown_cell(f"> **{heading}**\n>\n{items}", id=f"{cell.id}_rubric"))
    nb.cells = cells


def restored(sheet: Worksheet, submitted: NotebookNode | None, runs: Iterable[CellRun] = ()) -> NotebookNode:
    """The student's own sheet with what they wrote in it. Cells missing, doubled or altered in the submission do no harm: the
    sheet's own cells stand in their places, and what the student added stands, as code of no mark, below the cell it followed.
    """
    nb = notebook(sheet)
    submitted = with_names(submitted, sheet) if submitted is not None else None
    answers = cells_by_id(submitted) if submitted is not None else {}
    ran = {run.id: run for run in runs}
    for cell in nb.cells:
        mark, theirs = cell.metadata["nbgrader"], answers.get(cell.id)
        if mark["solution"] and theirs is not None:
            _fill_in(cell, theirs)
            if (run := ran.get(theirs.get("id", ""))) is not None and cell.cell_type == "code":
                cell.outputs = safe_outputs(run.outputs)
        if cell.id == "setup":
            cell.source = FOLDED_AWAY
            mark["checksum"] = checksum(cell)
    if submitted is not None:
        _add_extras(nb, submitted, ran)
    return nb


def notebook_text(nb: NotebookNode) -> str:
    """The text of its file, not indented: nobody reads it but nbgrader, and indenting would take longer than all the rest."""
    return json.dumps(nb, ensure_ascii=False) + "\n"


def part_grades(marked: Marked) -> Iterator[tuple[str, PartGrade]]:
    """Every part's grade under the name its cell has in the gradebook."""
    for grade in marked.grades:
        for part in grade.parts:
            yield grade.variant.problem.answer_name(part.part), part


def answer_cells(nb: NotebookNode, key: str) -> list[NotebookNode]:
    """The cells of a marked notebook in which the student wrote for a part."""
    ids = (key, f"{key}_answer", f"{key}_plot")
    return [cell for cell in nb.cells if cell.get("id") in ids and cell.metadata["nbgrader"]["solution"]]


def answer_digest(nb: NotebookNode, key: str) -> str:
    """A digest of what the student wrote for a part: equal when the answer is the same."""
    written = json.dumps([cell.source for cell in answer_cells(nb, key)])
    return hashlib.sha256(written.encode()).hexdigest()[:16]


def verbatim(cell: NotebookNode) -> str:
    """What the student wrote in a cell of a marked notebook, to the letter: in data, and never in a page."""
    return str(cell.metadata.get(WRITTEN, cell.source))


def _fill_in(cell: NotebookNode, theirs: NotebookNode) -> None:
    """A written cell keeps its checksum, by which nbgrader tells an answer from an empty one."""
    source = str(theirs.source)
    if cell.cell_type == "markdown":
        cell.source = safe_markdown(source)
        if cell.source != source:
            cell.metadata[WRITTEN] = source
        if attachments := safe_attachments(theirs):
            cell["attachments"] = attachments
    else:
        cell.source = source


def _add_extras(nb: NotebookNode, submitted: NotebookNode, runs: Mapping[str, CellRun]) -> None:
    """The cells a student added, each below the cell of the sheet that it followed."""
    ours = {cell.id for cell in nb.cells}
    chosen = {name: cell for name, cell in cells_by_id(submitted).items() if name in ours}
    following: dict[str, list[NotebookNode]] = {}
    at = "title"
    for cell in submitted.cells:
        name = next((name for name, theirs in chosen.items() if theirs is cell), None)
        if name is not None:
            at = name
        elif str(cell.source).strip():
            following.setdefault(at, []).append(_extra(cell, runs))
    nb.cells = [each for cell in nb.cells for each in (cell, *following.get(cell.id, ()))]
    for number, cell in enumerate(nb.cells):
        if cell.id not in ours:
            cell["id"] = f"added_{number}"


def _extra(cell: NotebookNode, runs: Mapping[str, CellRun]) -> NotebookNode:
    if cell.cell_type != "code":
        return new_markdown_cell(safe_markdown(str(cell.source)))
    run = runs.get(cell.get("id", ""))
    return new_code_cell(str(cell.source), outputs=safe_outputs(run.outputs) if run is not None else [])


def _as_read(grade: PartGrade) -> str:
    return grade.answer if isinstance(grade.verdict, Unread | Unmarked) else in_convention(grade.answer)


def _verdict(grade: PartGrade) -> NotebookNode:
    """The verdict as the check cell's output; the feedback stands as a comment at the answer."""
    earned = _.plural(
        "{points} of {out_of} point",
        "{points} of {out_of} points",
        1 if grade.out_of == 1 else 2,
        points=in_convention(f"{grade.points:g}"),
        out_of=in_convention(f"{grade.out_of:g}"),
    )
    in_brackets = _("points will follow") if grade.waits else earned
    words = f"**{look(grade.verdict).phrase}** ({in_brackets})"
    if grade.answer:
        words += "\n\n" + _("Your answer was read as: {answer}", answer=safe_markdown(_as_read(grade)))
    # Not by new_output, which checks each one against the schema: that would be a third of the time a notebook takes to write.
    data = NotebookNode({"text/markdown": words, "text/plain": words.replace("**", "")})
    return NotebookNode(output_type="display_data", data=data, metadata=NotebookNode())
