"""Marks given by hand when the points of their part change: the share stands, it is agreed to, and a person looks again."""

from __future__ import annotations

import csv
import json
import shutil
import sqlite3
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from nbgrader.api import Gradebook

from corollary.problem.bank import chapter_bank
from corollary.records.files import Course

from .conftest import STUDENTS, Done, grade, hand_in, run

pytestmark = pytest.mark.whole
PART = "X12_11_c"
FILE = "problems/collisions/stopping_a_ball.md"


@pytest.fixture
def bank(marked_course: Course, tmp_path: Path) -> Path:
    """The problem in a bank of the course's own; all of ada's 2 points for her explanation, 1.5 of them for ben's."""
    bank, chapter = tmp_path / "bank", chapter_bank().folder
    for file in (FILE, "solutions/collisions/stopping_a_ball.md"):
        (bank / file).parent.mkdir(parents=True)
        shutil.copy(chapter / file, bank / file)
    origin = marked_course.folder / ".corollary/origin/words.json"
    origin.write_text(json.dumps(json.loads(origin.read_text()) | {"bank": str(bank)}))
    assert mark(marked_course, "--set", "ada/X12.11c=2", "--set", "ben/X12.11c=1.5").status == 0
    return bank


def mark(course: Course, *words: object) -> Done:
    return run(course, "corollary", "mark", "words", "--course", ".", *words)


def now_out_of(bank: Path, points: float) -> None:
    problem = bank / FILE
    before, heading, after = problem.read_text(encoding="utf-8").partition("## Explain")
    line, _, rest = after.partition("\n")
    words = [f"points={points:g}}}" if word.startswith("points=") else word for word in line.split(" ")]
    problem.write_text(f"{before}{heading}{' '.join(words)}\n{rest}", encoding="utf-8")


def part_of(course: Course, student: str) -> dict:
    return grade(course).document["students"][student]["parts"][PART]


def in_gradebook(course: Course) -> dict[str, tuple[float | None, int]]:
    with sqlite3.connect(course.gradebook) as book:
        found = book.execute(
            "select s.student_id, g.manual_score, g.needs_manual_grade from submitted_assignment s "
            "join submitted_notebook n on n.assignment_id = s.id join grade g on g.notebook_id = n.id "
            "join base_cell b on b.id = g.cell_id where b.name = ?",
            (PART,),
        )
        return {student: (score, waits) for student, score, waits in found}


def waiting(course: Course) -> dict[str, str]:
    parts = mark(course, "--json").document["parts"]
    return {
        student: group["why"] for part in parts for group in part["groups"] for student in group["students"]
    }


def test_the_share_stands_when_agreed_to_and_a_person_looks_again(marked_course: Course, bank: Path) -> None:
    now_out_of(bank, 4)
    refused = run(marked_course, "corollary", "grade", "words", "--course", ".")
    assert refused.status == 1
    assert "by hand, 2 of 2 to 4 of 4 (+2; mark it again)" in " ".join(refused.out.split())
    assert "right to" not in refused.out
    assert in_gradebook(marked_course)["ada"] == (2.0, 0)
    done = grade(marked_course, "--yes")
    assert done.status == 0, done.errors
    parts = {s: done.document["students"][s]["parts"][PART] for s in ("ada", "ben")}
    assert [(part["points"], part["out_of"]) for part in parts.values()] == [(4.0, 4.0), (3.0, 4.0)]
    assert in_gradebook(marked_course) == {"ada": (4.0, 1), "ben": (3.0, 1), "cyd": (None, 0)}
    assert waiting(marked_course) == {
        "ada": "given 2 of 2, now out of 4",
        "ben": "given 1.5 of 2, now out of 4",
    }
    assert grade(marked_course).document["graded"] == 0
    assert mark(marked_course, "--set", "ada/X12.11c=3.5").status == 0
    with Gradebook(
        f"sqlite:///{marked_course.gradebook}", "course"
    ) as book:  # as formgrader takes the same score
        book.find_grade(PART, "words", "words", "ben").needs_manual_grade = False
        book.db.commit()
    assert waiting(marked_course) == {}
    assert [part_of(marked_course, student)["points"] for student in ("ada", "ben")] == [3.5, 3.0]


def test_fewer_points_make_no_mark_more_than_full_and_more_give_it_back(
    marked_course: Course, bank: Path
) -> None:
    now_out_of(bank, 1)
    assert grade(marked_course, "--yes").status == 0
    assert [part_of(marked_course, student)["points"] for student in ("ada", "ben")] == [1.0, 0.75]
    done = run(marked_course, "corollary", "export", "words", "--to", "csv", "--course", ".", "-o", "out")
    assert done.status == 0, done.errors
    with (marked_course.folder / "out/words.csv").open(encoding="utf-8") as file:
        assert {row["id"]: row["X12.11 c"] for row in csv.DictReader(file)}["ada"] == "1"
    marked_course.gradebook.unlink()
    assert grade(marked_course, "--yes").status == 0
    assert in_gradebook(marked_course)["ben"] == (0.75, 1)
    now_out_of(bank, 2)
    assert grade(marked_course, "--yes").status == 0
    assert waiting(marked_course) == {}
    assert in_gradebook(marked_course)["ben"] == (1.5, 0)


def test_extra_credit_is_as_it_was_given(marked_course: Course, bank: Path) -> None:
    with Gradebook(f"sqlite:///{marked_course.gradebook}", "course") as book:
        book.find_grade(PART, "words", "words", "ada").extra_credit = 0.5
        book.db.commit()
    now_out_of(bank, 4)
    assert grade(marked_course, "--yes").status == 0
    assert part_of(marked_course, "ada")["points"] == 4.5


def test_extra_credit_on_a_new_answer_is_shown_again(marked_course: Course) -> None:
    with Gradebook(f"sqlite:///{marked_course.gradebook}", "course") as book:
        book.find_grade("X12_11_a", "words", "words", "ada").extra_credit = 0.5
        book.db.commit()
    assert grade(marked_course, "--yes").status == 0
    assert mark(marked_course, "--set", "ada/X12.11c=2", "--set", "ben/X12.11c=2").status == 0
    assert waiting(marked_course) == {}
    hand_in(marked_course, STUDENTS[0], X12_11_a_answer="X12_11_a = 1e9")
    assert grade(marked_course).status == 0
    why = waiting(marked_course)["ada"]
    page = (marked_course.place("feedback", "ada", "words") / "words.html").read_text(encoding="utf-8")
    assert "your total can still change" in page
    assert "can only rise" not in page
    assert page.count("This was given for an earlier answer of yours") == 1
    assert why.startswith(
        "The answer has changed since a person gave it 0.5 as extra credit. Marked by the program: "
    )
    assert mark(marked_course, "--set", "ada/X12.11a=").status == 0
    assert waiting(marked_course) == {}
    assert (
        grade(marked_course).document["students"]["ada"]["parts"]["X12_11_a"]["manual"]["extra_credit"] == 0.5
    )
