"""A plain `nbgrader autograde` in a course of ours gives the marks of `corollary grade`, whatever became of a notebook."""

from __future__ import annotations

import json
import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from tests import forked

pytest.importorskip("nbgrader")

from corollary.atomic import write_whole
from corollary.course.demo.players import PLAYERS, Hand
from corollary.course.demo.stage import hand_in
from corollary.course.generate import generate
from corollary.course.grade import grade_set
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import file_text
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.records.assignments import read_assigned
from corollary.records.files import Course, one_writer, open_course
from corollary.records.marks import history, read_record
from corollary.sandbox.runner import Runner

pytestmark = pytest.mark.whole
BIN = Path(sys.executable).parent
SET = "momentum_1"
ALL = bool(os.environ.get("COROLLARY_ALL_OF_NBGRADERS_TESTS"))
GRADES = (
    "select s.student_id, b.name, round(g.auto_score, 2), g.needs_manual_grade, round(n.late_submission_penalty, 2) "
    "from submitted_assignment s join submitted_notebook n on n.assignment_id = s.id join grade g on g.notebook_id = n.id "
    "join base_cell b on b.id = g.cell_id order by 1, 2"
)
COMMENTS = (
    "select s.student_id, b.name, c.auto_comment from submitted_assignment s join submitted_notebook n on n.assignment_id = s.id "
    "join comment c on c.notebook_id = n.id join base_cell b on b.id = c.cell_id order by 1, 2"
)


def rows(course: Course, query: str) -> list[tuple]:
    with sqlite3.connect(course.gradebook) as book:
        return book.execute(query).fetchall()


def vandalised(path: Path) -> None:
    """What editors and students do: metadata lost, forged and doubled, statements and points edited, tags that skip cells."""
    nb = nbformat.read(path, as_version=4)
    by_id = {cell.id: cell for cell in nb.cells}
    by_id["X12_5_statement"].source = "A ball of mass 1 kg gets the speed 1 m/s."
    by_id["X12_5_a"].metadata["nbgrader"] |= {"points": 1000, "locked": False}
    by_id["X12_5_b"].metadata["nbgrader"] = {"schema_version": 99}
    by_id["X12_5_c"].metadata["nbgrader"] = "gone"
    by_id["X12_7_a_text"].metadata = nbformat.from_dict({})
    by_id["X12_8_a"].metadata["tags"] = ["skip-execution"]
    nb.cells.append(nbformat.from_dict(dict(by_id["X12_10_a"]) | {"id": "copied"}))
    write_whole(path, json.dumps(nb))


@pytest.fixture(scope="module")
def solutions() -> Solutions:
    return Solutions(chapter_bank())


@pytest.fixture(scope="module")
def problem_set(solutions: Solutions) -> ProblemSet:
    return find_set(solutions.bank, SET)


@pytest.fixture(scope="module")
def courses(
    solutions: Solutions, problem_set: ProblemSet, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Course, Course, str]:
    """The demonstration's class handed in twice: marked by us, and by nbgrader's own command; and what that command said."""
    folder = tmp_path_factory.mktemp("class")
    players = [
        player for player in PLAYERS if player.student.id != "kim"
    ]  # whose endless loop takes its time, twice
    made = generate(folder / "ours", problem_set, [player.student for player in players], solutions)
    for player in players:
        row = read_assigned(made.course, problem_set)[player.student.id]
        paper = worksheet(problem_set, player.student, row.variants)
        hand: Hand = player.hand(
            paper, {each.problem.code: solutions.key(each.variant) for each in paper.exercises}
        )
        hand_in(made.course, problem_set, paper, hand)
    vandalised(made.course.notebook("submitted", "chen", SET))
    write_whole(made.course.notebook("submitted", "zoe", SET), file_text(nbformat.v4.new_notebook()))
    subprocess.run(["cp", "-a", str(folder / "ours"), str(folder / "theirs")], check=True)
    grade_set(made.course, problem_set, solutions, Runner)
    done = forked.run([BIN / "nbgrader", "autograde", SET], cwd=folder / "theirs", timeout=300)
    assert done.returncode == 1, "zoe is on no roster, and that is said"
    return made.course, open_course(folder / "theirs"), done.stdout + done.stderr


def test_the_same_scores_to_the_cent(courses: tuple[Course, Course, str]) -> None:
    ours, theirs, _ = courses
    given = [row for row in rows(theirs, GRADES) if row[0] != "zoe"]
    assert given == rows(ours, GRADES)
    assert len({row[0] for row in given}) == len(PLAYERS) - 1
    assert [row for row in rows(theirs, COMMENTS) if row[0] != "zoe"] == rows(ours, COMMENTS)


def test_who_is_on_no_roster_gets_no_marks_and_a_flag_and_stops_nobody(
    courses: tuple[Course, Course, str],
) -> None:
    _, theirs, said = courses
    assert "zoe handed in momentum_1 but is not on the roster" in said
    assert {(row[2], row[3]) for row in rows(theirs, GRADES) if row[0] == "zoe"} == {(None, 1)}


def test_a_notebook_that_could_not_be_run_has_no_marks_and_a_flag(
    courses: tuple[Course, Course, str],
) -> None:
    for course in courses[:2]:
        assert {(row[2], row[3]) for row in rows(course, GRADES) if row[0] == "nils"} >= {(0.0, 1)}
        assert all(row[3] for row in rows(course, GRADES) if row[0] == "nils")


def test_a_statement_is_restored_with_the_students_own_numbers(courses: tuple[Course, Course, str]) -> None:
    ours, theirs, _ = courses
    handed_out = {
        cell.id: cell.source
        for cell in nbformat.read(theirs.notebook("release", "chen", SET), as_version=4).cells
    }
    for course in (ours, theirs):
        cells = {
            cell.id: cell
            for cell in nbformat.read(course.notebook("autograded", "chen", SET), as_version=4).cells
        }
        assert cells["X12_5_statement"].source == handed_out["X12_5_statement"]
        assert cells["X12_5_a"].metadata["nbgrader"]["points"] == 1
        assert "The report has notes" in cells["remark_0"].source


def test_how_a_mark_came_about_is_kept_either_way(
    courses: tuple[Course, Course, str], solutions: Solutions, problem_set: ProblemSet
) -> None:
    ours, theirs, _ = courses
    assert sorted(each["student"] for each in history(theirs, SET)) == sorted(
        each["student"] for each in history(ours, SET)
    )
    assert read_record(theirs, problem_set, "chen") == read_record(ours, problem_set, "chen")
    again = grade_set(theirs, problem_set, solutions, Runner)
    assert again.graded == ()
    assert again.strangers == ("zoe",)


def test_nbgrader_waits_its_turn_while_another_run_is_writing(courses: tuple[Course, Course, str]) -> None:
    _, theirs, _ = courses
    place = theirs.notebook("autograded", "chen", SET)
    before, marks = place.read_bytes(), rows(theirs, GRADES)
    with one_writer(theirs):
        done = forked.run(
            [BIN / "nbgrader", "autograde", SET, "--student", "chen", "--force"],
            cwd=theirs.folder,
            timeout=300,
        )
    assert done.returncode == 1
    assert "another corollary command is running in" in done.stdout + done.stderr
    assert (place.read_bytes(), rows(theirs, GRADES)) == (before, marks)


def test_a_marked_notebook_that_was_thrown_away_is_made_again(
    courses: tuple[Course, Course, str], solutions: Solutions, problem_set: ProblemSet
) -> None:
    ours, _, _ = courses
    place, marks = ours.notebook("autograded", "chen", SET), rows(ours, GRADES)
    place.unlink()
    assert grade_set(ours, problem_set, solutions, Runner).graded == ("chen",)
    assert (place.exists(), rows(ours, GRADES)) == (True, marks)


@pytest.mark.parametrize("words", [
    ["nbgrader.tests.preprocessors.test_overwritecells", *([] if ALL else ["-k", "overwrite_points"])],
    pytest.param(["nbgrader.tests.apps.test_nbgrader_autograde"], marks=pytest.mark.skipif(not ALL, reason="takes some minutes")),
])  # fmt: skip
def test_nbgraders_own_tests_pass_with_our_classes_in_place(words: list[str], tmp_path: Path) -> None:
    """All of them with COROLLARY_ALL_OF_NBGRADERS_TESTS=1 (some minutes); one otherwise."""
    plugin = Path(__file__).parent / "upstream"
    environment = os.environ | {"PATH": f"{BIN}:{os.environ['PATH']}", "PYTHONPATH": str(plugin)}
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "our_classes", "-p", "no:cacheprovider", "--pyargs", *words],
        cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=1200, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-3000:]
    assert " passed" in done.stdout
