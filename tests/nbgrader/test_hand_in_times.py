"""A timestamp.txt that says no time: marked as in time by our command and by nbgrader's, and the instructor reads of it."""

from __future__ import annotations

import pytest

pytest.importorskip("nbgrader")

from nbgrader.api import Gradebook

from corollary.records.files import Course

from .conftest import grade, run


def seconds_late(course: Course) -> dict[str, float]:
    with Gradebook(f"sqlite:///{course.gradebook}") as book:
        return {each.student.id: each.total_seconds_late for each in book.assignment_submissions("words")}


@pytest.mark.whole
def test_our_command_and_nbgraders_make_nobody_late_by_a_guess(marked_course: Course) -> None:
    assert seconds_late(marked_course)["ben"] == 3600
    stamps = {
        each: marked_course.place("submitted", each, "words") / "timestamp.txt" for each in ("ben", "cyd")
    }
    stamps["ben"].write_text("yesterday evening")
    done = grade(marked_course)
    assert (done.status, [each["student"] for each in done.document["changed"]]) == (1, ["ben"])
    assert done.document["students"]["ben"]["late"] == 3600  # nobody agreed
    done = grade(marked_course, "--yes")
    assert done.status == 0
    ben = done.document["students"]["ben"]
    assert (ben["late"], seconds_late(marked_course)["ben"]) == (0.0, 0)
    assert done.document["guessed_times"]["ben"]["found"] == "yesterday evening"
    assert "ben: timestamp.txt held no time but 'yesterday evening'" in done.errors
    report = (marked_course.folder / "reports" / "words.html").read_text(encoding="utf-8")
    assert "yesterday evening" in report
    aside = marked_course.record("times", "words/ben.1.txt")
    assert aside.read_text() == "yesterday evening"
    again = grade(marked_course)
    assert (again.document["graded"], again.document["students"]["ben"]) == (0, ben)

    stamps["cyd"].write_text("4.12. abends")
    autograded = run(marked_course, "nbgrader", "autograde", "words", "--force")
    assert autograded.status == 0, autograded.errors
    assert "cyd: timestamp.txt held no time but '4.12. abends'" in autograded.errors
    assert seconds_late(marked_course) == {"ada": 0, "ben": 0, "cyd": 0}
    assert grade(marked_course).document["graded"] == 0
