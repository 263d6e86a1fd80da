"""What became of a sheet on its way is noticed, and an honest notebook is left in peace."""

from __future__ import annotations

import copy

import nbformat
import pytest
from nbformat import NotebookNode

from corollary.grading.integrity import notes
from corollary.notebook.cells import checksum
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.variant import at

SET = find_set(chapter_bank(), "momentum_1")


def paper(name: str, place: int) -> Worksheet:
    return worksheet(SET, Student(name), [at(problem, place) for problem in SET.problems])


ADA, BEN = paper("ada", 1000), paper("ben", 2000)


def cell(nb: NotebookNode, cell_id: str) -> NotebookNode:
    return next(each for each in nb.cells if each.id == cell_id)


def test_an_honest_notebook_is_left_in_peace() -> None:
    nb = notebook(ADA)
    for each in nb.cells:
        if each.metadata["nbgrader"]["solution"]:
            each.source += "\n# my answer"
        each.source += "  \r\n"
    nb.cells = [each for each in nb.cells if each.id != "check_all"]
    nb.cells.append(nbformat.v4.new_code_cell("mine = 1"))
    assert notes(ADA, nb) == ()


def test_somebody_elses_notebook_is_told_by_name_and_without_its_name() -> None:
    nb = notebook(BEN)
    (said,) = notes(ADA, nb)
    assert "made for ben, not for ada" in said
    nb.metadata["corollary"]["student"] = "ada"
    (said,) = notes(ADA, nb)
    assert "not from this student's sheet" in said
    del nb.metadata["corollary"]
    assert len(notes(ADA, nb)) == 1


@pytest.mark.parametrize(
    ("cell_id", "what"),
    [
        ("X12_5_statement", "numbers that were handed out"),
        ("X12_5_a", "earns nothing"),
        ("setup", "earns nothing"),
    ],
)
def test_an_edited_cell_is_named(cell_id: str, what: str) -> None:
    nb = notebook(ADA)
    cell(nb, cell_id).source += " and more"
    (said,) = notes(ADA, nb)
    assert said.startswith(f"The cell {cell_id} is edited")
    assert what in said


def test_a_figure_drawn_anew_in_the_middle_of_a_term_accuses_nobody() -> None:
    nb = notebook(ADA)
    figure = cell(nb, "X12_5_figure")
    figure.source = figure.source.replace("base64,", "base64,PHN2Zz4=")
    figure.metadata["nbgrader"]["checksum"] = checksum(figure)
    assert notes(ADA, nb) == ()
    figure.metadata["nbgrader"]["checksum"] = "another"
    assert "X12_5_figure is edited" in notes(ADA, nb)[0]


@pytest.mark.parametrize("metadata", [{}, {"nbgrader": 7}, {"nbgrader": {"grade_id": ["a"], "checksum": 3}}])
def test_odd_metadata_does_no_harm(metadata: dict) -> None:
    nb = copy.deepcopy(notebook(ADA))
    cell(nb, "X12_5_statement").metadata = nbformat.from_dict(metadata)
    nb.metadata = nbformat.from_dict({"corollary": {"student": {"a": 1}}})
    assert notes(ADA, nb) == ()
