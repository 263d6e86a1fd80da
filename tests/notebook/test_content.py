"""Cells without any name are known by what stands in them and around them."""

from __future__ import annotations

import copy

import pytest
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell

from corollary.notebook.content import with_names
from corollary.notebook.locate import cells_by_id, plot_cells, written_text
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import Worksheet


@pytest.fixture
def nameless(ada: Worksheet) -> NotebookNode:
    """Filled in, and then saved by an editor that knows neither metadata nor ids."""
    nb = copy.deepcopy(notebook(ada))
    for cell in nb.cells:
        if cell.metadata["nbgrader"]["solution"]:
            cell.source += f"\n# mine: {cell.id}" if cell.cell_type == "code" else f" mine: {cell.id}"
    for number, cell in enumerate(nb.cells):
        cell.metadata, cell["id"] = NotebookNode(), f"cell-{number}"
    return nb


def recognised(nb: NotebookNode, sheet: Worksheet) -> dict[str, str]:
    """For each answer cell of the sheet the one that was written into it, "" where none is found."""
    found = cells_by_id(with_names(nb, sheet))
    ours = [cell.id for cell in notebook(sheet).cells if cell.metadata["nbgrader"]["solution"]]
    return {
        name: str(found[name].source).rpartition("mine: ")[2].strip() if name in found else ""
        for name in ours
    }


def test_every_answer_is_found_by_the_question_above_it(nameless: NotebookNode, ada: Worksheet):
    found = recognised(nameless, ada)
    assert len(found) > 9
    assert found == {name: name for name in found}
    named = with_names(nameless, ada)
    words = next(prompt for prompt in ada.prompts if prompt.part.answer_type == "explain")
    assert written_text(named, words) is not None
    assert set(plot_cells(named, ada)) == {"X12_5_f", "X12_5_g"}


def test_cells_of_the_students_own_and_changed_blanks_do_no_harm(nameless: NotebookNode, ada: Worksheet):
    for cell in nameless.cells:
        if cell.cell_type == "markdown":
            cell.source = cell.source.replace("\n", " \r\n") + "\n\n"
    nameless.cells.insert(1, new_markdown_cell("my notes"))
    nameless.cells.append(new_code_cell("print(3)"))
    found = recognised(nameless, ada)
    assert found == {name: name for name in found}


def test_a_question_that_was_touched_is_known_by_its_heading(nameless: NotebookNode, ada: Worksheet):
    for cell in nameless.cells:
        if cell.source.startswith("#### "):
            cell.source += " (I understand this one)"
    found = recognised(nameless, ada)
    assert found == {name: name for name in found}


def test_what_has_its_names_stays_as_it_is(ada: Worksheet):
    nb = notebook(ada)
    assert with_names(nb, ada) is nb


def test_answers_without_their_questions_are_nobodys(nameless: NotebookNode, ada: Worksheet):
    nameless.cells = [cell for cell in nameless.cells if "mine: " in cell.source]
    assert set(recognised(nameless, ada).values()) == {""}
