"""Answers found again in notebooks that were moved about, copied in, and stripped of what they carried."""

from __future__ import annotations

import copy

import pytest
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell

from corollary.notebook.locate import answer_id, cells_by_id, code_to_run, plot_cells, written_text
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import Prompt, Worksheet


@pytest.fixture
def nb(ada: Worksheet):
    return notebook(ada)


def cell(nb, cell_id: str):
    return next(cell for cell in nb.cells if cell.id == cell_id)


@pytest.fixture
def words(ada: Worksheet) -> Prompt:
    return next(prompt for prompt in ada.prompts if prompt.key == "X12_5_e")


def test_an_untouched_explanation_is_no_explanation(nb, words: Prompt):
    assert written_text(nb, words) is None
    cell(nb, "X12_5_e").source = "  \n"
    assert written_text(nb, words) is None
    nb.cells.remove(cell(nb, "X12_5_e"))
    assert written_text(nb, words) is None


def test_an_explanation_is_what_was_written(nb, words: Prompt):
    cell(nb, "X12_5_e").source = "*Your answer here.*\n\nBecause $F = J/\\Delta t$."
    assert written_text(nb, words) == "Because $F = J/\\Delta t$."


def test_a_copied_cell_does_not_replace_the_original(nb):
    original = cell(nb, "X12_5_a_answer")
    double = copy.deepcopy(original)
    double["id"], double.source = "copy", "X12_5_a = 1"
    nb.cells.insert(0, double)
    assert cells_by_id(nb)["X12_5_a_answer"] is original


def test_a_cell_is_found_by_either_of_its_names(nb):
    by_id, by_mark = cell(nb, "X12_5_a_answer"), cell(nb, "X12_5_b_answer")
    del by_id.metadata["nbgrader"]
    by_mark["id"] = "renamed"
    assert cells_by_id(nb)["X12_5_a_answer"] is by_id
    assert cells_by_id(nb)["X12_5_b_answer"] is by_mark


@pytest.mark.parametrize("mark", [None, 3, [], {}, {"grade_id": 3}, {"grade_id": None}])
def test_broken_metadata_is_as_good_as_none(nb, mark: object):
    cell(nb, "X12_5_a_answer").metadata["nbgrader"] = mark
    assert "X12_5_a_answer" in cells_by_id(nb)


def test_what_runs_is_the_students_code_in_the_students_order(nb, ada: Worksheet):
    nb.cells.insert(6, new_code_cell("helper = 3", id="mine"))
    nb.cells.append(new_markdown_cell("notes", id="notes"))
    run = dict(code_to_run(nb, notebook(ada)))
    assert next(iter(run)) == "setup"
    assert len(run["setup"]) < 100
    assert run["mine"] == "helper = 3"
    assert list(run).index("mine") < list(run).index("X12_5_a_answer")
    assert {"X12_5_a", "check_all", "notes", "X12_5_e"}.isdisjoint(run)


def test_our_own_code_is_left_out_even_when_an_editor_dropped_all_names(nb, ada: Worksheet):
    for number, each in enumerate(nb.cells):
        each.metadata, each["id"] = NotebookNode(), f"cell-{number}"
    assert not any("check" in source for _, source in code_to_run(nb, notebook(ada))[1:])


def test_an_answer_written_into_a_check_cell_counts(nb, ada: Worksheet):
    cell(nb, "X12_5_a").source = 'X12_5_a = 8.6\ncheck("X12_5_a")'
    space: dict = {}
    for _, source in code_to_run(nb, notebook(ada)):
        if "plt" not in source:
            exec(source, space)
    assert space["X12_5_a"] == 8.6


def test_plots_are_found_where_the_student_moved_them(nb, ada: Worksheet):
    cell(nb, "X12_5_f_plot")["id"] = "moved"
    assert plot_cells(nb, ada) == {"X12_5_f": "moved", "X12_5_g": "X12_5_g_plot"}


def test_every_answer_cell_named_is_there(nb, ada: Worksheet):
    assert {answer_id(prompt.key, prompt.part) for prompt in ada.prompts} <= cells_by_id(nb).keys()
