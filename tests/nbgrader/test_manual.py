"""What a person gives through nbgrader is in every page, table and total at once, and is lost to no command and no accident."""

from __future__ import annotations

import csv
import re
import shutil
import sqlite3
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from nbgrader.api import Gradebook

from corollary.records.files import Course

from .conftest import STUDENTS, grade, hand_in, run

pytestmark = pytest.mark.whole
ADA, BEN, _ = STUDENTS
PART = "X12_11_c"


def book_of(course: Course) -> Gradebook:
    return Gradebook(f"sqlite:///{course.gradebook}", "course")


def give(
    course: Course, student: str, score: float | None, comment: str | None = None, extra: float | None = None
) -> None:
    """As formgrader's handlers write it."""
    with book_of(course) as book:
        grade = book.find_grade(PART, "words", "words", student)
        grade.manual_score, grade.extra_credit = score, extra
        grade.needs_manual_grade = score is None and grade.auto_score is None
        book.find_comment(PART, "words", "words", student).manual_comment = comment
        book.db.commit()


def in_gradebook(course: Course, student: str) -> tuple[float | None, str | None, bool]:
    with book_of(course) as book:
        grade = book.find_grade(PART, "words", "words", student)
        return (
            grade.manual_score,
            book.find_comment(PART, "words", "words", student).manual_comment,
            grade.needs_manual_grade,
        )


def page(course: Course, student: str) -> str:
    (found,) = course.place("feedback", student, "words").glob("*.html")
    return found.read_text(encoding="utf-8")


def table(course: Course) -> dict[str, dict[str, str]]:
    done = run(course, "corollary", "export", "words", "--to", "csv", "--course", ".", "-o", "out")
    assert done.status == 0, done.errors
    with (course.folder / "out/words.csv").open(encoding="utf-8") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def report(course: Course) -> dict:
    return run(course, "corollary", "report", "words", "--course", ".", "--json").document


@pytest.fixture
def given(marked_course: Course) -> Course:
    """Both points for ada with a comment, one and another as extra credit for ben, who came late."""
    give(marked_course, "ada", 2.0, "Well <b>argued</b>.")
    give(marked_course, "ben", 1.0, extra=1.0)
    return marked_course


def test_before_a_person_looks_the_part_waits(marked_course: Course) -> None:
    assert {each["student"] for each in report(marked_course)["waiting"]} == {"ada", "ben"}
    assert table(marked_course)["ada"]["X12.11 c"] == ""
    feedback = page(marked_course, "ada")
    assert "Waits for your teacher" in feedback
    assert ">– / 2<" in feedback
    assert ">0 / 2<" not in feedback, "nobody has given no points yet"


def test_the_report_and_the_tables_have_it_at_once(given: Course) -> None:
    before = table(given)
    assert (before["ada"]["X12.11 c"], before["ben"]["X12.11 c"]) == ("2", "2")
    found = report(given)
    assert found["waiting"] == []
    assert [part["counts"]["by_hand"] for part in found["parts"]] == [0, 0, 2]
    out_of = found["out_of"]
    assert found["students"]["ada"]["points"] == out_of
    assert found["students"]["ben"]["points"] == out_of / 2, (
        "the late share is taken off what a person gave, too"
    )
    assert before["ben"]["total"] == f"{out_of / 2:g}"
    assert "by hand" in (given.folder / "reports/words.html").read_text()


@pytest.mark.parametrize(
    "command",
    [
        ("corollary", "report", "words", "--course", "."),
        ("corollary", "grade", "words", "--course", "."),
        ("corollary", "grade", "words", "--course", ".", "--regrade"),
        ("nbgrader", "autograde", "words"),
        ("nbgrader", "generate_feedback", "words"),
    ],
    ids=" ".join,
)
def test_the_one_page_says_what_the_person_said(given: Course, command: tuple[str, ...]) -> None:
    done = run(given, *command)
    assert done.status == 0, done.errors
    ours = page(given, "ada")
    assert "Marked by your teacher" in ours
    assert "Well &lt;b&gt;argued&lt;/b&gt;." in ours
    assert "Waits for your teacher" not in ours
    assert "Waits for your teacher" not in page(given, "ben")
    assert in_gradebook(given, "ada")[:2] == (2.0, "Well <b>argued</b>.")
    assert run(given, "nbgrader", "generate_feedback", "words").status == 0
    assert page(given, "ada") == ours
    assert table(given)["ada"]["X12.11 c"] == "2"


def test_nbgraders_own_table_takes_lateness_off_it(given: Course) -> None:
    assert run(given, "nbgrader", "export").status == 0
    with (given.folder / "grades.csv").open(encoding="utf-8") as file:
        rows = {row["student_id"]: row for row in csv.DictReader(file)}
    assert float(rows["ben"]["late_submission_penalty"]) == float(rows["ben"]["raw_score"]) / 2
    totals = report(given)["students"]
    assert {one: float(rows[one]["score"]) for one in totals} == {
        one: totals[one]["points"] for one in totals
    }


def test_what_is_withdrawn_is_gone_everywhere(given: Course) -> None:
    assert grade(given).status == 0
    give(given, "ada", None)
    (change,) = report(given)["outside"]
    assert (change["student"], change["before"], change["after"]) == ("ada", 2.0, None)
    assert table(given)["ada"]["X12.11 c"] == "2", "nothing moves until somebody agrees"
    done = grade(given)
    assert (done.status, "changed in the gradebook" in done.errors) == (1, True), done.errors
    assert grade(given, "--yes").status == 0
    assert report(given)["outside"] == []
    assert {each["student"] for each in report(given)["waiting"]} == {"ada"}
    assert table(given)["ada"]["X12.11 c"] == ""
    assert "Waits for your teacher" in page(given, "ada")
    assert grade(given).status == 0
    assert in_gradebook(given, "ada") == (None, None, True)


def deleted(course: Course, backup: Path) -> None:
    course.gradebook.unlink()


def restored(course: Course, backup: Path) -> None:
    shutil.copy(backup, course.gradebook)


@pytest.mark.parametrize("accident", [deleted, restored])
def test_a_gradebook_that_was_lost_gets_back_what_persons_gave(
    marked_course: Course, tmp_path: Path, accident: Callable[[Course, Path], None]
) -> None:
    backup = tmp_path / "yesterday.db"
    shutil.copy(marked_course.gradebook, backup)
    give(marked_course, "ada", 2.0, "Well argued.")
    assert table(marked_course)["ada"]["X12.11 c"] == "2"
    accident(marked_course, backup)
    assert table(marked_course)["ada"]["X12.11 c"] == "2"
    assert grade(marked_course).status == 0
    assert in_gradebook(marked_course, "ada") == (2.0, "Well argued.", False)
    assert in_gradebook(marked_course, "ben") == (None, None, True)
    give(marked_course, "ada", 1.0)
    assert table(marked_course)["ada"]["X12.11 c"] == "2"
    assert grade(marked_course, "--yes").status == 0
    assert table(marked_course)["ada"]["X12.11 c"] == "1", "from then on the gradebook is believed again"


def test_without_nbgraders_file_the_journal_is_the_record(given: Course) -> None:
    assert grade(given).status == 0
    given.gradebook.unlink()
    (given.folder / "nbgrader_config.py").unlink()
    assert table(given)["ada"]["X12.11 c"] == "2"


def test_another_answer_is_shown_to_the_person_again(given: Course) -> None:
    assert grade(given).status == 0
    hand_in(given, ADA, X12_11_c="The floor is a spring.")
    assert grade(given).status == 0
    assert in_gradebook(given, "ada") == (2.0, "Well <b>argued</b>.", True)
    found = report(given)
    assert [(one["student"], one["why"]) for one in found["waiting"]] == [
        ("ada", "the answer has changed since a person marked it")
    ]
    assert found["students"]["ada"]["points"] == found["out_of"], "until then it stands"
    row = table(given)["ada"]
    parts = [float(points) for name, points in row.items() if name.startswith("X12.11")]
    assert row["X12.11 c"] == "2"
    assert sum(parts) == float(row["total"]) == found["out_of"], "and so in every table"
    exported = run(
        given, "corollary", "export", "words", "--to", "csv", "--columns", "parts", "--course", ".", "--json"
    )
    assert (exported.document["waiting"], exported.document["again"]) == ([], ["ada"])
    assert "1 student with a new answer to what a person had marked" in exported.errors
    assert "wait for marking" not in exported.errors
    (file,) = exported.document["files"]
    with (given.folder / file).open(encoding="utf-8") as lines:
        ada = next(row for row in csv.reader(lines) if "ada" in row)
    assert sum(float(cell) for cell in ada if re.fullmatch(r"[\d.]+", cell)) == found["out_of"]
    give(given, "ada", 2.0, "Well <b>argued</b>.")  # formgrader's Resolve
    assert report(given)["waiting"] == []
    assert grade(given, "--regrade").status == 0
    assert in_gradebook(given, "ada")[2] is False


def test_nbgraders_autograde_shows_only_another_answer_again(given: Course) -> None:
    hand_in(given, BEN, X12_11_c="The floor is a spring.")
    done = run(given, "nbgrader", "autograde", "words", "--force")
    assert done.status == 0, done.errors
    assert in_gradebook(given, "ada")[2] is False
    assert in_gradebook(given, "ben") == (1.0, None, True)


def test_a_set_whose_place_is_lost_is_a_sentence_in_nbgrader_too(marked_course: Course) -> None:
    (marked_course.folder / ".corollary/origin/words.json").unlink()
    done = run(marked_course, "nbgrader", "autograde", "words")
    assert done.status == 1
    assert "origin/words.json is lost" in done.errors
    assert "Traceback" not in done.errors


def test_the_gradebook_is_an_ordinary_one_still(given: Course) -> None:
    assert grade(given).status == 0
    done = run(given, "nbgrader", "db", "upgrade")
    assert done.status == 0, done.errors
    with sqlite3.connect(given.gradebook) as book:
        assert book.execute("pragma integrity_check").fetchone() == ("ok",)
