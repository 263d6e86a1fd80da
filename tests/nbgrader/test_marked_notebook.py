"""What formgrader shows of a student: the answers and what to mark them by, and not whose they are."""

from __future__ import annotations

import re

import nbformat
import pytest

from corollary.records.files import Course

from .conftest import STUDENTS, grade, hand_in, run

pytestmark = pytest.mark.whole
RUBRIC = "Says that a floor that moves away takes energy from the ball"


def test_no_name_and_the_rubric_below_the_answer(marked_course: Course) -> None:
    for student in STUDENTS[:2]:
        text = marked_course.notebook("autograded", student.id, "words").read_text(encoding="utf-8")
        assert not any(word in text for word in ("Lovelace", "Boole", f'"{student.id}"'))
        cells = [cell.id for cell in nbformat.reads(text, as_version=4).cells]
        assert cells[cells.index("X12_11_c") + 1] == "X12_11_c_rubric"
        assert RUBRIC in text


def test_a_neighbours_notebook_names_nobody_to_the_marker(marked_course: Course) -> None:
    hand_in(marked_course, STUDENTS[1])
    mine, other = (marked_course.notebook("submitted", one.id, "words") for one in STUDENTS[:2])
    mine.write_bytes(other.read_bytes())
    assert grade(marked_course).status == 0
    text = marked_course.notebook("autograded", "ada", "words").read_text(encoding="utf-8")
    assert "The report has notes on this notebook" in text
    assert not re.search(r"\b(ada|ben|Boole)\b", text)


def test_the_rubric_is_in_the_report_and_for_students_only_where_the_set_says_so(
    marked_course: Course,
) -> None:
    page = marked_course.place("feedback", "ada", "words") / "words.html"
    assert RUBRIC not in page.read_text(encoding="utf-8")
    waiting = run(marked_course, "corollary", "report", "words", "--course", ".", "--json").document[
        "waiting"
    ]
    assert any(RUBRIC in item for item in waiting[0]["rubric"])
    assert RUBRIC in (marked_course.folder / "reports/words.html").read_text(encoding="utf-8")
    of = marked_course.folder.parent / "words.md"
    of.write_text(of.read_text().replace("credit:", "rubric: yes\ncredit:"))
    assert grade(marked_course).status == 0
    assert RUBRIC in page.read_text(encoding="utf-8")
    of.write_text(of.read_text().replace("due: 2026-03-02", "due: 2099-03-02"))
    assert grade(marked_course, "--yes").status == 0
    assert RUBRIC not in page.read_text(encoding="utf-8"), "no key before it is due"
