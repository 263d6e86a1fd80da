"""The notebook a student gets: whole, readable, known to nbgrader, and running without corollary."""

from __future__ import annotations

import base64
import re
from dataclasses import replace

import nbformat
import pytest
from nbclient import NotebookClient

from corollary.notebook.cells import checksum
from corollary.notebook.notebook import file_text, notebook, picture
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import at, chapter


@pytest.fixture(scope="module")
def nb(ada: Worksheet):
    return notebook(ada)


def cell(nb, cell_id: str):
    return next(cell for cell in nb.cells if cell.id == cell_id)


def test_it_is_a_valid_notebook_and_reads_back_the_same(nb):
    nbformat.validate(nb)
    again = nbformat.reads(file_text(nb), as_version=4)
    assert again == nb
    assert again.metadata.kernelspec.name == "python3"
    assert again.metadata.corollary == {"set": "week_1", "student": "ada"}


def test_the_same_sheet_gives_the_same_file(ada: Worksheet):
    assert file_text(notebook(ada)) == file_text(notebook(ada))


def test_nbgrader_accepts_every_cell_and_its_checksum(nb):
    pytest.importorskip("nbgrader")
    from nbgrader.nbgraderformat import MetadataValidator
    from nbgrader.utils import compute_checksum

    MetadataValidator().validate_nb(nb)
    marked = [cell for cell in nb.cells if "checksum" in cell.metadata.nbgrader]
    assert len(marked) > 20
    for each in marked:
        assert compute_checksum(each) == each.metadata.nbgrader.checksum == checksum(each)


def test_each_part_has_its_cells_in_order(nb):
    ids = [cell.id for cell in nb.cells]
    assert ids[:5] == ["title", "how_to_answer", "setup", "X12_5_statement", "X12_5_figure"]
    assert [each for each in ids if each.startswith("X12_5_f")][1:] == [
        "X12_5_f_text",
        "X12_5_f_answer",
        "X12_5_f_plot",
        "X12_5_f",
    ]
    assert [each for each in ids if each.startswith("X12_5_g")] == ["X12_5_g_text", "X12_5_g_plot", "X12_5_g"]
    assert [each for each in ids if each.startswith("X12_5_e")] == ["X12_5_e_text", "X12_5_e"]
    assert ids[-2:] == ["closing", "check_all"]


def test_the_points_stand_on_the_graded_cells_weights_included(nb, ada: Worksheet):
    points = {cell.id: cell.metadata.nbgrader.points for cell in nb.cells if cell.metadata.nbgrader.grade}
    assert points == {prompt.key: prompt.out_of for prompt in ada.prompts}
    assert points["E12_3_1s_a"] == 2
    assert "19 points" in cell(nb, "title").source


def test_only_answers_can_be_edited(nb):
    for each in nb.cells:
        answer = each.metadata.nbgrader.solution
        assert answer is not each.metadata.nbgrader.locked
        assert each.metadata.get("editable", True) is answer
    assert cell(nb, "X12_5_e").metadata.nbgrader.grade
    assert cell(nb, "setup").metadata.jupyter.source_hidden is True


def test_the_title_names_the_student_and_the_date(nb):
    assert "Ada Lovelace" in cell(nb, "title").source
    assert re.search(r"due \w+ \d+ December 2026, \d\d:\d\d \S+", cell(nb, "title").source)
    assert "Your numbers are your own." in cell(nb, "title").source


def test_the_numbers_are_the_students_own(nb, problem_set: ProblemSet):
    other = notebook(
        worksheet(problem_set, Student("bob"), [at(problem, 12) for problem in problem_set.problems])
    )
    ours, theirs = cell(nb, "X12_5_statement").source, cell(other, "X12_5_statement").source
    assert ours != theirs
    assert [c.id for c in nb.cells] == [c.id for c in other.cells]
    assert "{{" not in ours


def test_the_figure_travels_with_the_notebook(nb):
    found = re.fullmatch(
        r'<img alt="([^"]*)" src="data:image/svg\+xml;base64,([^"]*)">', cell(nb, "X12_5_figure").source
    )
    assert found is not None
    assert found[1] == "A ball of mass 0.30 kg (at rest)."
    assert base64.b64decode(found[2]).decode().startswith("<svg")


def test_a_picture_cannot_break_out_of_its_markdown():
    assert picture("<svg/>", "a [b]\nc").startswith("![a (b) c](data:")


def test_the_chapters_own_sheet_names_nobody(problem_set: ProblemSet):
    nb = notebook(worksheet(problem_set, Student(""), [chapter(problem) for problem in problem_set.problems]))
    assert "****" not in cell(nb, "title").source
    assert cell(nb, "title").source.count("**") == 0


def test_it_runs_in_a_real_kernel_from_top_to_bottom(ada: Worksheet):
    nb = notebook(ada)
    cell(nb, "X12_5_a_answer").source = 'X12_5_a = "8,6 Ns"'
    cell(nb, "X12_5_f_answer").source = "def force(t, dt, J):\n    return J/dt"
    NotebookClient(nb, timeout=60, kernel_name="python3").execute()
    said = {
        each.id: "".join(output.text for output in each.outputs if output.output_type == "stream")
        for each in nb.cells
        if each.cell_type == "code"
    }
    assert said["X12_5_a"] == "X12_5_a: read as 8.6 N s (2 figures)\n"
    assert said["X12_5_f"] == "X12_5_f: force(t, dt, J) is there\n"
    assert said["check_all"].count("\n") == sum(
        prompt.part.answer_type != "explain" for prompt in ada.prompts
    )
    assert not any(output.output_type == "error" for each in nb.cells for output in each.get("outputs", []))


def test_two_cells_of_one_name_are_refused_by_the_name(ada: Worksheet):
    """The second of them would take the first one's answer."""
    with pytest.raises(ValueError, match=r"two cells of week_1 would be called .*; rename one of the parts"):
        notebook(replace(ada, exercises=(*ada.exercises, ada.exercises[0])))


def test_a_check_without_the_cell_that_defines_it_says_which_to_run(ada: Worksheet):
    """As after a restart: by the last line of its error, so that nbgrader takes it for no success."""
    checks = [cell for cell in notebook(ada).cells if "check(" in cell.source and cell.id != "setup"]
    assert len(checks) > 5
    for cell in (each for each in checks if each.cell_type == "code"):
        with pytest.raises(AssertionError, match="Run the folded cell above first"):
            exec(cell.source, {})
        called: list[tuple[str, ...]] = []
        exec(cell.source, {"check": lambda *names, into=called: into.append(names)})
        assert len(called) == 1


def run_by_hand(ada: Worksheet, typed: list[tuple[str, str]]) -> list[str]:
    """What a real kernel prints for cells run one after the other: a cell of the sheet by its id, with the text that it is given."""
    nb = notebook(ada)
    client = NotebookClient(nb, timeout=60, kernel_name="python3", allow_errors=True)
    said: list[str] = []
    with client.setup_kernel():
        for name, source in typed:
            place = next(place for place, each in enumerate(nb.cells) if each.id == name)
            nb.cells[place].source = source or nb.cells[place].source
            client.execute_cell(nb.cells[place], place)
            out = nb.cells[place].outputs
            said.append("".join(each.get("text", "") or f"{each.get('evalue', '')}" for each in out))
    return said


def test_check_speaks_of_the_cell_as_it_was_run_last(ada: Worksheet):
    answer, check = "X12_5_a_answer", ("X12_5_a", "")
    said = run_by_hand(
        ada,
        [
            check,  # as after a restart
            ("setup", ""),
            check,
            (answer, 'X12_5_a = "8.6 N s"'),
            check,
            (answer, "X12_5_a = 9.3 kg m/s"),
            check,
            (answer, 'X12_5_a = float("9,3")'),
            check,
            (answer, 'X12_5_a = "9.3 N s"\nprint(undefined)'),
            check,
            (answer, 'X12_5_a = "9,4 N s"'),
            check,
        ],
    )
    assert "Run the folded cell above first" in said[0]
    assert "no answer yet: run the cell with your answer first" in said[2]
    assert "read as 8.6 N s" in said[4]
    assert 'in quotes: X12_5_a = "9.3 kg m/s"' in said[6]
    assert "no answer yet: its cell stopped with an error; correct it and run it again" in said[8]
    assert "read as 9.3 N s" in said[10]  # bound before the error, as it is when it is marked
    assert "read as 9.4 N s" in said[12]


def test_the_letters_of_a_formula_are_listed_where_a_number_is_asked_for(ada: Worksheet):
    nb = notebook(ada)
    assert "*A number may also be given as a formula of `v0`.*" in cell(nb, "E12_3_1s_statement").source
    assert "A number may also" not in cell(nb, "X12_5_statement").source  # part (c) lists them
    assert "Letters: `m` (mass of the ball)" in cell(nb, "X12_5_c_text").source
