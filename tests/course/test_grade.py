"""What nbgrader no longer has is written again, and what stands in the way is said in a sentence."""

from __future__ import annotations

import shutil
import sqlite3
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from .conftest import STUDENTS, grade

SCORES = (
    "select s.student_id, sum(g.auto_score) from submitted_assignment s join submitted_notebook n "
    "on n.assignment_id = s.id join grade g on g.notebook_id = n.id group by 1 order by 1"
)


def scores(course: Path) -> dict[str, float]:
    with sqlite3.connect(course / "gradebook.db") as book:
        return dict(book.execute(SCORES))


def deleted(course: Path) -> None:
    (course / "gradebook.db").unlink()


def emptied(course: Path) -> None:
    (course / "gradebook.db").write_bytes(b"")


def forgetting_ben(course: Path) -> None:
    with sqlite3.connect(course / "gradebook.db") as book:
        book.execute(
            "update grade set auto_score = 0 where notebook_id in (select n.id from submitted_notebook n "
            "join submitted_assignment s on n.assignment_id = s.id where s.student_id = 'ben')"
        )


@pytest.mark.parametrize("harm", [deleted, pytest.param(emptied, marks=pytest.mark.whole), None])
def test_a_gradebook_without_the_marks_is_filled_again(
    harm: Callable[[Path], None] | None, graded: Path, before_grading: Callable[[Path], None]
) -> None:
    (harm or before_grading)(graded)
    done = grade(graded)
    assert done.status == 0, done.errors
    assert (
        "marks restored in the gradebook and autograded/, those given by hand too: ada, ben, cyd"
        in done.errors
    )
    assert scores(graded) == dict.fromkeys(STUDENTS, 5.0)
    again = grade(graded)
    assert (again.document["graded"], again.document["skipped"]) == (0, 3)


def test_feedback_that_was_lost_is_made_again_without_marking(graded: Path) -> None:
    page = graded / "feedback/ada/one/one.html"
    before = page.read_bytes()
    shutil.rmtree(graded / "feedback")
    assert grade(graded).document["graded"] == 0
    assert page.read_bytes() == before


def test_marks_whose_notebook_is_gone_stay_and_are_named(graded: Path) -> None:
    marks = scores(graded)
    shutil.rmtree(graded / "submitted" / "ben")
    done = grade(graded)
    assert (done.status, done.document["gone"], done.document["changed"]) == (0, ["ben"], [])
    assert "no notebook is in submitted/STUDENT/one any more, and its marks are kept: ben;" in done.errors
    assert "corollary extend STUDENT one --excuse" in done.errors
    shutil.rmtree(graded / "submitted")
    done = grade(graded, "--strict")
    assert (done.status, done.document["gone"]) == (1, list(STUDENTS))
    assert scores(graded) == marks


def test_only_those_are_marked_again_whose_scores_are_others(graded: Path) -> None:
    forgetting_ben(graded)
    done = grade(graded)
    assert (done.document["graded"], done.document["skipped"]) == (1, 2)
    assert scores(graded) == dict.fromkeys(STUDENTS, 5.0)


def test_a_dry_run_makes_no_gradebook(graded: Path) -> None:
    deleted(graded)
    assert grade(graded, "--dry-run").status == 0
    assert not (graded / "gradebook.db").exists()


@pytest.mark.whole
@pytest.mark.parametrize("content", ["garbage", "cut in half"])
def test_a_damaged_gradebook_is_named(content: str, graded: Path) -> None:
    book = graded / "gradebook.db"
    whole = book.read_bytes()
    book.write_bytes(b"\x07garbage" * 4000 if content == "garbage" else whole[: len(whole) // 2])
    done = grade(graded)
    assert done.status == 2
    assert done.errors.startswith(f"corollary: {book} cannot be used")
    assert "restore it from a backup" in done.errors
    assert "those given by hand too" in done.errors
    assert done.errors.count("\n") == 1
    book.unlink()
    assert grade(graded).status == 0
    assert scores(graded) == dict.fromkeys(STUDENTS, 5.0)


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("this is ( no python", "SyntaxError"),
        ("raise SystemExit(3)", "SystemExit: 3"),
        ("c.CourseDirectory.course_id = 5", "TraitError"),
        ("import no_such_module", "ModuleNotFoundError"),
        ('c.CourseDirectory.db_url = "no such database"', "ArgumentError"),
        ('c.CourseDirectory.db_url = "nosuch://host/marks"', "NoSuchModuleError"),
    ],
)
def test_a_broken_nbgrader_config_is_named(line: str, why: str, graded: Path) -> None:
    config = graded / "nbgrader_config.py"
    config.write_text(config.read_text() + line + "\n")
    done = grade(graded)
    assert done.status == 2
    assert done.errors.startswith(f"corollary: {config}")
    assert why in done.errors
    assert "correct the file" in done.errors
    assert "Traceback" not in done.errors
