"""After marking, what a verdict earns, points or a rubric are changed: marks move as they should, and no notebook is run again."""

from __future__ import annotations

import sqlite3
from functools import partial
from pathlib import Path

import nbformat
import pytest

pytest.importorskip("nbgrader")

from corollary.course.grade import Outcome, grade_set
from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import gradebook
from corollary.records.files import open_course
from corollary.sandbox.runner import Runner

from .changing_bank import ChangingBank, Text

pytestmark = pytest.mark.usefixtures("one_zygote")
QUESTION = "\n## Why {#e .explain points=2}\nWhy?\n"
ANSWER = '        explain("e", "names the momentum", "names the force", answer="It is so."),\n    )\n'


class Course:
    """Ada has all right; Ben's momentum has the wrong sign, and so has the force that follows from it."""

    def __init__(self, folder: Path) -> None:
        self.ball = ChangingBank(folder)
        self.ball.write(Text())
        self.edit("problems/topic/ball0.md", "", QUESTION)
        self.edit("solutions/topic/ball0.py", "    )\n", ANSWER)
        self.edit("solutions/topic/ball0.py", "import derivation,", "import derivation, explain,")
        made = self.ball.generate("ada", "ben")
        self.ball.hand_in(made, "ada")
        given = made.assigned["ben"].variants[0].si
        momentum = -float(given["m"]) * float(given["v"])
        self.ball.hand_in(made, "ben", X1_1_a=repr(momentum), X1_1_c=repr(momentum / float(given["dt"])))
        self.ran = False
        found = self.grade()
        assert self.ran
        assert self.points(found) == {"ada": (3.0, 5.0), "ben": (2.5, 5.0)}
        assert [found.records["ben"].parts[f"X1_1_{part}"].verdict for part in "abc"] == [
            "slip",
            "right",
            "follows",
        ]

    def edit(self, file: str, before: str, after: str) -> None:
        path = self.ball.bank.folder / file
        text = path.read_text()
        assert before in text
        path.write_text(text.replace(before, after) if before else text + after)

    def grade(self, *, regrade: bool = False, dry_run: bool = False, agree: bool = True) -> Outcome:
        self.ran = False

        def begin() -> None:
            self.ran = True

        return grade_set(
            open_course(self.ball.course), self.ball.problem_set, Solutions(self.ball.bank), partial(Runner, require=0),
            jobs=1, regrade=regrade, dry_run=dry_run, begin=begin, ask=lambda changed: agree,
        )  # fmt: skip

    @staticmethod
    def points(found: Outcome) -> dict[str, tuple[float, float]]:
        return {student: (each.points, each.out_of) for student, each in found.records.items()}

    def seen(self) -> dict[str, bytes]:
        """What persons and students see of it."""
        folder = self.ball.course
        files = [each for step in ("autograded", "feedback") for each in (folder / step).rglob("week.*")]
        files += (folder / ".corollary" / "pages").rglob("*.json")
        assert len(files) == 6
        return {str(each): each.read_bytes() for each in files}

    def marked_as_by_a_run(self, regrade: bool) -> dict[str, tuple[float, float]]:
        """The marks without a run; then everything is run, and says the same to the byte."""
        tried = self.grade(regrade=regrade, dry_run=True)
        assert not self.ran
        assert not tried.written
        found = self.grade(regrade=regrade)
        assert not self.ran
        assert found.graded == ("ada", "ben")
        before = self.seen()
        self.grade(regrade=True)
        assert self.ran
        assert self.seen() == before
        return self.points(found)


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return Course(tmp_path)


@pytest.mark.parametrize("regrade", [pytest.param(False, marks=pytest.mark.whole), True])
def test_what_a_verdict_earns(course: Course, regrade: bool) -> None:
    course.edit("problems/sets/week.md", "problems:", "credit: {slip: 0.25, follows: 0.5}\nproblems:")
    assert course.marked_as_by_a_run(regrade) == {"ada": (3.0, 5.0), "ben": (1.75, 5.0)}


def test_the_points_of_a_part(course: Course) -> None:
    course.edit("problems/topic/ball0.md", 'unit="kg*m/s" points=1', 'points=4 unit="kg*m/s"')
    found = course.grade(dry_run=True)
    assert {each.why for each in found.changed} == {"changed: the points or the rubric of X1.1"}
    assert course.marked_as_by_a_run(True) == {"ada": (6.0, 8.0), "ben": (4.0, 8.0)}
    with gradebook(open_course(course.ball.course)) as book:
        cell = book.find_grade_cell("X1_1_a", "week", "week")
        assert cell.max_score == 4.0
    with sqlite3.connect(course.ball.course / "gradebook.db") as scores:
        found_scores = scores.execute(
            "select g.auto_score from grade g join base_cell b on b.id = g.cell_id where b.name = 'X1_1_a'"
        ).fetchall()
    assert sorted(found_scores) == [(2.0,), (4.0,)]


@pytest.mark.whole
def test_nbgrader_has_them_out_of_what_was_agreed_to(course: Course) -> None:
    """Its maximum is one number for everybody: it stays while anybody's mark is out of the points of before."""

    def maxima() -> tuple[float, float]:
        source = nbformat.read(course.ball.course / "source/week/week.ipynb", as_version=4)
        (cell,) = (cell for cell in source.cells if cell.id == "X1_1_a")
        with gradebook(open_course(course.ball.course)) as book:
            return book.find_grade_cell("X1_1_a", "week", "week").max_score, cell.metadata.nbgrader.points

    course.edit("problems/topic/ball0.md", 'unit="kg*m/s" points=1', 'points=4 unit="kg*m/s"')
    made = course.ball.generate("ada", "ben", "cyd")
    assert maxima() == (1.0, 1.0)
    course.ball.hand_in(made, "cyd")
    course.grade(dry_run=True)
    assert maxima() == (1.0, 1.0)
    found = course.grade(agree=False)
    assert (found.held, maxima()) == (("ada", "ben"), (1.0, 1.0))
    assert course.points(found) == {"ada": (3.0, 5.0), "ben": (2.5, 5.0), "cyd": (6.0, 8.0)}
    course.grade()
    assert maxima() == (4.0, 4.0)


@pytest.mark.whole
def test_the_weight_of_a_problem(course: Course) -> None:
    course.edit("problems/sets/week.md", "- X1.1", "- {code: X1.1, weight: 2}")
    assert course.marked_as_by_a_run(True) == {"ada": (6.0, 10.0), "ben": (5.0, 10.0)}


@pytest.mark.whole
def test_a_rubric(course: Course) -> None:
    course.edit("solutions/topic/ball0.py", "names the force", "names the time")
    assert course.marked_as_by_a_run(True) == {"ada": (3.0, 5.0), "ben": (2.5, 5.0)}
    marked = (course.ball.course / "autograded/ben/week/week.ipynb").read_text()
    assert "names the time" in marked
    assert "names the force" not in marked


@pytest.mark.whole
def test_another_law_is_run(course: Course) -> None:
    course.edit("solutions/topic/ball0.py", "Q = m*v^2/2", "Q = 3*m*v^2/2")
    found = course.grade(regrade=True)
    assert course.ran
    assert course.points(found) == {"ada": (2.0, 5.0), "ben": (1.5, 5.0)}
    assert {each.why for each in found.changed} == {"changed: the solution of X1.1"}
