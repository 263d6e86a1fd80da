"""What became of a sheet on its way is noticed, and an honest notebook is left in peace."""

from __future__ import annotations

import copy
from dataclasses import replace
from datetime import UTC, datetime

import nbformat
import pytest
from nbformat import NotebookNode

from corollary.grading.integrity import elsewhere, notes
from corollary.messages import language, languages
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
    (note,) = notes(ADA, nb)
    assert "made for ben. It was marked with the numbers of your own sheet (ada)" in note
    nb.metadata["corollary"]["student"] = "ada"
    (note,) = notes(ADA, nb)
    assert "from an earlier version of your sheet" in note
    del nb.metadata["corollary"]
    (note,) = notes(ADA, nb)
    assert "have other numbers than your sheet" in note


@pytest.mark.parametrize("named", [True, False])
def test_a_deadline_that_moved_and_a_typo_that_was_mended_accuse_nobody(named: bool) -> None:
    nb = notebook(ADA)
    if not named:
        del nb.metadata["corollary"]
    problem, *others = SET.problems
    first = problem.parts[0]
    worded = replace(
        problem,
        statement=problem.statement.replace("the", "teh", 1),
        parts=(replace(first, title="Worded better", text=first.text + " Look twice."), *problem.parts[1:]),
    )  # fmt: skip
    today = replace(
        SET,
        title="Another title",
        introduction="Read this first.",
        due=datetime(2030, 1, 2, 3, 4, tzinfo=UTC),
        problems=(worded, *others),
    )
    sheet = worksheet(today, Student("ada", "Ada", "Lovelace"), [at(each, 1000) for each in today.problems])
    assert notebook(sheet).cells[0].source != nb.cells[0].source
    assert cell(notebook(sheet), "X12_5_statement").source != cell(nb, "X12_5_statement").source
    assert notes(sheet, nb) == ()


@pytest.mark.parametrize("code", [each for each in languages() if each != "en"])
def test_who_is_marked_in_another_language_than_the_sheet_was_printed_in_is_left_in_peace(code: str) -> None:
    nb = notebook(ADA)
    with language(code):
        sheet, other = paper("ada", 1000), paper("ada", 2000)
        assert cell(notebook(sheet), "X12_5_statement").source != cell(nb, "X12_5_statement").source
        assert notes(sheet, nb) == ()
        assert "X12_5_statement" in notes(other, nb)[0]


@pytest.mark.parametrize("named", [True, False])
def test_other_points_and_a_part_less_accuse_nobody_but_other_numbers_are_still_seen(named: bool) -> None:
    problem, *others = SET.problems
    first, *rest = problem.parts
    dearer = replace(problem, parts=(replace(first, points=first.points + 6.5), *rest[:-1]))
    today = replace(SET, problems=(dearer, *others))

    def sheet(place: int) -> Worksheet:
        return worksheet(today, Student("ada"), [at(each, place) for each in today.problems])

    nb = notebook(ADA)
    if not named:
        del nb.metadata["corollary"]
    for asked, now in [
        ("X12_5_statement", f"*{5 + 6.5 - rest[-1].points:g} points*"),
        ("X12_5_a_text", "(7.5 points)"),
    ]:
        assert now in cell(notebook(sheet(1000)), asked).source
        assert now not in cell(nb, asked).source
    assert notes(sheet(1000), nb) == ()
    (note,) = notes(sheet(2000), nb)
    assert "X12_5_statement" in note


def test_a_notebook_of_another_set_belongs_elsewhere() -> None:
    nb = notebook(ADA)
    assert elsewhere(ADA, nb) == ""
    nb.metadata["corollary"]["set"] = "week_2"
    assert elsewhere(ADA, nb).startswith("The notebook you handed in belongs to week_2, not to momentum_1")
    # an editor that drops the metadata, and a student who copies the answers only, are nobody else's
    del nb.metadata["corollary"]
    assert elsewhere(ADA, nb) == ""
    own = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("X12_5_a = 3")])
    assert elsewhere(ADA, own) == ""
    own.cells[0].source = "answer = 3"
    assert "none of the exercises of momentum_1" in elsewhere(ADA, own)


@pytest.mark.parametrize(
    ("cell_id", "what"),
    [
        ("X12_5_statement", "numbers on your original sheet"),
        ("X12_5_a", "does not change your points"),
        ("setup", "does not change your points"),
    ],
)
def test_an_edited_cell_is_named(cell_id: str, what: str) -> None:
    nb = notebook(ADA)
    cell(nb, cell_id).source += " and more"
    (note,) = notes(ADA, nb)
    assert f"the cell {cell_id}" in note
    assert what in note


def test_a_figure_drawn_anew_in_the_middle_of_a_term_accuses_nobody() -> None:
    nb = notebook(ADA)
    figure = cell(nb, "X12_5_figure")
    figure.source = figure.source.replace("base64,", "base64,PHN2Zz4=")
    figure.metadata["nbgrader"]["checksum"] = checksum(figure)
    assert notes(ADA, nb) == ()
    figure.metadata["nbgrader"]["checksum"] = "another"
    assert "the cell X12_5_figure" in notes(ADA, nb)[0]


@pytest.mark.parametrize("metadata", [{}, {"nbgrader": 7}, {"nbgrader": {"grade_id": ["a"], "checksum": 3}}])
def test_odd_metadata_does_no_harm(metadata: dict) -> None:
    nb = copy.deepcopy(notebook(ADA))
    cell(nb, "X12_5_statement").metadata = nbformat.from_dict(metadata)
    nb.metadata = nbformat.from_dict({"corollary": {"student": {"a": 1}}})
    assert notes(ADA, nb) == ()
