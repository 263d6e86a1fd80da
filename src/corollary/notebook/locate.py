"""A student's answers, found again in the notebook that came back, and the set and student that it names, which proves nothing."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from corollary.answers.answer_type import AnswerType
from corollary.answers.registry import answer_type
from corollary.notebook.unbound import assigned, text_found
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.part import Part

if TYPE_CHECKING:  # a report is read without nbformat, which loads for a second
    from nbformat import NotebookNode

SILENT_CHECK = "def check(*names):\n    pass"


def cells_by_id(nb: NotebookNode) -> dict[str, NotebookNode]:
    """The cells of a notebook by the grade_id they were handed out with.

    A copied cell carries the grade_id of the original but not its cell id, so the cell that still has both wins; then the
    first with the grade_id; then, where an editor dropped the metadata, the cell with that id.
    """
    named: dict[str, NotebookNode] = {}
    for cell in nb.cells:
        name = grade_id(cell)
        if name and (name not in named or (cell.get("id") == name and named[name].get("id") != name)):
            named[name] = cell
    for cell in nb.cells:
        if not grade_id(cell) and cell.get("id"):
            named.setdefault(cell["id"], cell)
    return named


def grade_id(cell: NotebookNode) -> str:
    """The nbgrader name of a cell; empty when it has none, or something that is no name."""
    mark = cell.get("metadata", {}).get("nbgrader")
    name = mark.get("grade_id") if isinstance(mark, Mapping) else None
    return name if isinstance(name, str) else ""


def cell_id(key: str, its_type: AnswerType) -> str:
    """The grade_id of the cell in which an answer of this type is written."""
    return {"cell": key, "figure": f"{key}_plot"}.get(its_type.found_in, f"{key}_answer")


def answer_id(key: str, part: Part) -> str:
    """The grade_id of the cell that holds the answer; for a function with a plot, the function's."""
    return cell_id(key, answer_type(part.answer_type))


def plot_id(key: str, part: Part) -> str | None:
    """The grade_id of the cell whose figures matter; None for a part without a plot."""
    drawn = [each for each in map(answer_type, part.answer_types) if each.found_in == "figure"]
    return cell_id(key, drawn[0]) if drawn else None


def written_text(nb: NotebookNode, prompt: Prompt) -> str | None:
    """What was written in a cell of words; None when it is missing or was left as it was."""
    cell = cells_by_id(nb).get(prompt.key)
    blank = prompt.answer_types[0].blank(prompt.question)
    text = str(cell.source).replace(blank, "").strip() if cell is not None else ""
    return text or None


def written_elsewhere(nb: NotebookNode, prompt: Prompt) -> str:
    """What was written for an answer that takes a name, into its cell or, where that was left as it was, behind the name in
    another; empty where nothing was."""
    its_type = prompt.answer_types[0]
    if its_type.found_in != "variable":
        return ""
    named, own = cells_by_id(nb), answer_id(prompt.key, prompt.part)
    cell = named.get(own)
    text = ""
    if cell is not None:
        # A cell that was turned to Markdown runs nothing, whatever it computes.
        runs = prompt.name if cell.cell_type == "code" else ""
        text = text_found(str(cell.source), its_type.blank(prompt.question), prompt.name, runs)
    if text:
        return text
    others = (str(each.source) for each in nb.cells if each is not cell and grade_id(each) != prompt.key)
    found = (assigned(source, name) for source in others for name in (prompt.name, prompt.key))
    return next(filter(None, found), "") or _written_below(nb, prompt)


def written_into_question(nb: NotebookNode, ours: Mapping[str, str], prompt: Prompt) -> str:
    """The lines that were added to a part's question, which else is as it was handed out: `ours` has the sources by cell."""
    name = f"{prompt.key}_text"
    cell, asked = cells_by_id(nb).get(name), ours.get(name, "").strip()
    source = str(cell.source).strip() if cell is not None else ""
    if not asked or not source.startswith(asked):
        return ""
    return text_found(source.removeprefix(asked), "", prompt.name, "")


def _written_below(nb: NotebookNode, prompt: Prompt) -> str:
    """What stands in cells of the student's own between the question and the next cell that was handed out for something else."""
    own, texts, below = {answer_id(prompt.key, prompt.part), prompt.key}, list[str](), False
    for cell in nb.cells:
        name = grade_id(cell)
        if name == f"{prompt.key}_text":
            below = True
        elif below and name and name not in own:
            break
        elif below and not name:
            texts.append(text_found(str(cell.source), "", prompt.name, ""))
    return "\n".join(filter(None, texts))


def code_to_run(nb: NotebookNode, handed_out: NotebookNode) -> tuple[tuple[str, str], ...]:
    """The (cell id, source) of the code that has to run for the answers to appear, in the student's order.

    Left out is what was handed out as it came back: the checks. Code written into a check cell does run, and its `check`
    is silent.
    """
    ours = {"", *(cell.source.strip() for cell in handed_out.cells if not cell.metadata.nbgrader["solution"])}
    run = [("setup", SILENT_CHECK)]
    for cell in nb.cells:
        if cell.cell_type != "code":
            continue
        name = grade_id(cell) or cell.get("id", "")
        if name != "setup" and str(cell.source).strip() not in ours:
            run.append((cell.get("id", name), cell.source))
    return tuple(run)


def ran_to_its_end(nb: NotebookNode) -> dict[str, bool]:
    """By the id of each cell: whether the file says that it was run, and did not end in an error."""
    return {
        str(cell.get("id", "")): isinstance(cell.get("execution_count"), int)
        and all(each.get("output_type") != "error" for each in cell.get("outputs", ()))
        for cell in nb.cells
    }


def plot_cells(nb: NotebookNode, sheet: Worksheet) -> dict[str, str]:
    """For each part with a plot, by key: the id that the drawing cell has in the notebook that came back."""
    named = cells_by_id(nb)
    return {
        prompt.key: named[name].get("id", name)
        for prompt in sheet.prompts
        if (name := plot_id(prompt.key, prompt.part)) is not None and name in named
    }


LONGEST = 100
NUMBER = re.compile(r"\d+(?:[.,]\d+)*")
# The head of a statement and of a part: codes, titles and points, which are not of one student (`notebook.notebook` writes them).
HEAD = re.compile(r"\A\s*(?:---\s+##[^\n]*(?:\s+\*[^*\n]+\*[ \t\r]*(?=\n|\Z))?|####[^\n]*)")


@dataclass(frozen=True, slots=True)
class Origin:
    """The name of the set and the id of the student; "" where the notebook does not say, or says what cannot be one."""

    set_name: str
    student: str


def origin(nb: NotebookNode) -> Origin:
    """What the notebook's metadata say; an editor may have dropped them."""
    about: object = nb.get("metadata", {}).get("corollary")
    metadata = cast("Mapping[str, object]", about if isinstance(about, Mapping) else {})
    return Origin(_word(metadata.get("set")), _word(metadata.get("student")))


def is_of(sheet: Worksheet, nb: NotebookNode) -> bool:
    """Whether a notebook belongs to the set of this sheet: it says so; or it says nothing, and holds one of the sheet's cells or
    the name of one of its answers."""
    if name := origin(nb).set_name:
        return name == sheet.problem_set.name
    found, keys = cells_by_id(nb), {prompt.key for prompt in sheet.prompts}
    asked = {f"{key}{end}" for key in keys for end in ("", "_text", "_answer", "_plot")}
    if asked & found.keys():
        return True
    sources = "\n".join(str(cell.get("source", "")) for cell in nb.cells)
    names = keys | {prompt.name for prompt in sheet.prompts}
    return any(re.search(rf"\b{re.escape(name)}\b", sources) for name in names)


def other_numbers(theirs: str, ours: str) -> bool:
    """Whether two statements or questions give different numbers, however they are worded, in whatever language, and whatever
    they earn."""
    return _numbers(theirs) != _numbers(ours)


def _numbers(text: str) -> Counter[str]:
    asked = HEAD.sub("", text).replace("{,}", ",")  # a decimal comma in TeX
    return Counter(each.replace(",", ".") for each in NUMBER.findall(asked))


def _word(value: object) -> str:
    return value[:LONGEST] if isinstance(value, str) and value.isprintable() else ""
