"""A problem is corrected after it was handed out, and marked: nobody's numbers move, and no marks are lost."""

from __future__ import annotations

import sqlite3
import sys
from pathlib import Path

import pytest
from tests import forked

from corollary.course.export import marks_table, sheets_of_course
from corollary.grading.solutions import Solutions
from corollary.problem.roster import Student
from corollary.records.files import students
from corollary.records.marks_table import MarksTable, Notation, every_column
from corollary.records.regrading import Change
from corollary.render.exports import target

from .changing_bank import ChangingBank, Text, replace

SCORES = (
    "select s.student_id, b.name, g.auto_score, g.needs_manual_grade from submitted_assignment s "
    "join submitted_notebook n on n.assignment_id = s.id join grade g on g.notebook_id = n.id "
    "join base_cell b on b.id = g.cell_id order by 1, 2"
)
RANGE = {
    "m": "value: 0.43, from: 0.36, to: 0.6, step: 0.02, unit: kg",
    "v": "value: 72, from: 36, to: 108, step: 3.6, unit: km/h",
    "dt": "value: 0.1, from: 0.02, to: 0.15, step: 0.01, unit: s",
}


def scores(course: Path) -> dict[tuple[str, str], tuple[float | None, int]]:
    with sqlite3.connect(course / "gradebook.db") as book:
        return {
            (student, cell): (score, waits) for student, cell, score, waits in book.execute(SCORES).fetchall()
        }


@pytest.fixture
def ball(tmp_path: Path) -> ChangingBank:
    """Ada has all right, and Ben one part wrong; both are marked."""
    ball = ChangingBank(tmp_path)
    ball.write(Text())
    made = ball.generate("ada", "ben")
    ball.hand_in(made, "ada")
    ball.hand_in(made, "ben", X1_1_c="1e9")
    outcome = ball.grade(made.course)
    assert {student: record.points for student, record in outcome.records.items()} == {"ada": 3.0, "ben": 2.0}
    return ball


@pytest.mark.whole
def test_another_range_and_another_unit_move_no_marks(ball: ChangingBank) -> None:
    released = {path: path.read_bytes() for path in ball.course.glob("release/*/week/week.ipynb")}
    ball.write(Text(givens=RANGE, words="A heavy ball of {{m}} moves at {{v}} for {{dt}}."))
    made = ball.generate("ada", "ben", "cyd")
    assert {path: path.read_bytes() for path in released} == released
    outcome = ball.grade(made.course)
    assert {student: record.points for student, record in outcome.records.items()} == {"ada": 3.0, "ben": 2.0}
    assert not [record.notes for record in outcome.records.values() if record.notes]
    sheets = {plan.student.id: plan.worksheet() for plan in sheets_of_course(made.course, ball.problem_set)}
    assert sheets["ada"].exercises[0].statement.startswith("A ball of")
    assert sheets["cyd"].exercises[0].statement.startswith("A heavy ball of")


@pytest.mark.whole
def test_a_part_that_is_gone_keeps_its_marks_and_one_that_is_new_is_for_newcomers(ball: ChangingBank) -> None:
    ball.write(Text(parts=("a", "d", "b")))
    made = ball.generate("ada", "ben", "cyd")
    ball.hand_in(made, "cyd", X1_1_d="1e9")
    for _ in range(2):
        outcome = ball.grade(made.course, regrade=True)
        assert {student: (record.points, record.out_of) for student, record in outcome.records.items()} == {
            "ada": (3.0, 3.0),
            "ben": (2.0, 3.0),
            "cyd": (2.0, 3.0),
        }
        assert not outcome.changed
    # Where the true value happens to be a power of ten, 1e9 is one written wrongly.
    assert outcome.records["ben"].parts["X1_1_c"].verdict in ("wrong", "slip")
    assert "X1_1_d" not in outcome.records["ada"].parts
    assert ball.grade(made.course).graded == ()
    found = scores(ball.course)
    assert found["ben", "X1_1_c"] == (0.0, 0)
    assert found["ada", "X1_1_c"] == (1.0, 0)
    assert found["ada", "X1_1_d"] == (None, 0)
    assert found["cyd", "X1_1_d"] == (0.0, 0)
    page = (ball.course / "feedback" / "ben" / "week" / "week.html").read_text()
    assert "Force" in page
    assert "Distance" not in page
    table = target("csv").marks
    assert table is not None
    roster = students(made.course)
    columns = tuple(every_column(ball.problem_set, outcome.report, roster))
    rows = table(MarksTable(roster, columns)).splitlines()
    assert rows[0].endswith("X1.1 a,X1.1 d,X1.1 b,X1.1 c,total,out_of")
    assert rows[1].endswith("1,,1,1,3,3")
    assert rows[3].endswith("1,0,1,,2,3")


@pytest.mark.whole
def test_a_problem_that_is_gone_keeps_its_marks(ball: ChangingBank) -> None:
    ball.write(Text(), Text(code="X1.2", parts=("d",)))
    made = ball.generate("ada", "ben", "cyd")
    ball.hand_in(made, "cyd")
    assert ball.grade(made.course).records["cyd"].points == 4.0
    ball.write(Text(code="X1.2", parts=("d",)))
    outcome = ball.grade(ball.generate("ada", "ben", "cyd").course)
    assert {student: (record.points, record.out_of) for student, record in outcome.records.items()} == {
        "ada": (3.0, 3.0),
        "ben": (2.0, 3.0),
        "cyd": (4.0, 4.0),
    }


@pytest.mark.whole
def test_a_part_that_was_never_marked_is_counted_for_nobody(ball: ChangingBank) -> None:
    made = ball.generate("ada", "ben", "cyd")
    ball.hand_in(made, "cyd", X1_1_c="1e9")
    ball.write(Text(parts=("a", "b")))
    record = ball.grade(made.course).records["cyd"]
    assert (record.points, record.out_of) == (2.0, 2.0)


@pytest.mark.whole
def test_numbers_that_break_a_condition_of_today_are_marked_as_before(ball: ChangingBank) -> None:
    ball.write(replace(Text(), conditions=("m > 0", "m > 100 kg")))
    from corollary.records.files import open_course

    outcome = ball.grade(open_course(ball.course))
    assert {student: record.points for student, record in outcome.records.items()} == {"ada": 3.0, "ben": 2.0}


def test_points_are_those_of_today(ball: ChangingBank) -> None:
    from corollary.records.files import open_course

    ball.write(Text(points=2))
    outcome = ball.grade(open_course(ball.course))
    assert {student: record.points for student, record in outcome.records.items()} == {"ada": 6.0, "ben": 4.0}


def test_who_is_shown_a_sheet_is_shown_the_one_that_was_handed_out(ball: ChangingBank) -> None:
    from corollary.records.assignments import variant_anywhere
    from corollary.records.files import open_course

    before = variant_anywhere(open_course(ball.course), ball.problem_set.problems[0], "ada")
    ball.write(Text(givens=RANGE, parts=("a", "d")))
    variant = variant_anywhere(open_course(ball.course), ball.problem_set.problems[0], "ada")
    assert variant is not None
    assert before is not None
    assert variant.si == before.si
    assert "(a) Momentum" in Solutions(ball.bank).worked_solution(variant)
    assert Student("ada") in students(open_course(ball.course))


@pytest.mark.whole
def test_points_that_a_part_is_out_of_do_not_move_unseen(ball: ChangingBank) -> None:
    """Nobody's points change, and 0 of 3 would be 0 of 6: asked about like any other mark."""
    made = ball.generate("ada", "ben")
    ball.hand_in(made, "ben", X1_1_a="1e9", X1_1_b="1e9", X1_1_c="1e9")
    (made.course.folder / "submitted/ada/week/week.ipynb").unlink()
    assert ball.grade(made.course).records["ben"].out_of == 3.0
    ball.write(Text(points=2))
    shown: list[Change] = []
    refused = ball.grade(made.course, ask=lambda changed: bool(shown.extend(changed)))
    assert (refused.held, refused.graded, refused.written) == (("ben",), (), False)
    assert (refused.records["ben"].points, refused.records["ben"].out_of) == (0.0, 3.0)
    (change,) = shown
    assert (change.by, change.out_of_before, change.out_of) == (0.0, 3.0, 6.0)
    assert [(part.part, part.out_of_before, part.out_of) for part in change.parts] == [
        (f"X1_1_{part}", 1.0, 2.0) for part in "abc"
    ]
    agreed = ball.grade(made.course, ask=lambda changed: True)
    assert (agreed.records["ben"].points, agreed.records["ben"].out_of) == (0.0, 6.0)


@pytest.mark.whole
def test_who_has_an_older_sheet_and_has_not_handed_in_has_the_points_of_that_sheet(
    ball: ChangingBank,
) -> None:
    ball.generate("ada", "ben", "cyd")
    ball.write(Text(parts=("a", "b", "c", "d")))
    made = ball.generate("ada", "ben", "cyd", "dan")
    ball.grade(made.course)
    table = marks_table(made.course, [ball.problem_set], "every", Notation())
    out_of = table.columns[-1]
    assert out_of.title == "out_of"
    assert {each.id: table.cell(each, out_of) for each in table.students} == {
        "ada": "3",
        "ben": "3",
        "cyd": "3",
        "dan": "4",
    }


@pytest.mark.whole
def test_nbgraders_autograde_in_a_corrected_course_gives_the_same_marks(ball: ChangingBank) -> None:
    """A part is gone, one is new, one is renamed, and all are worth more: who has which sheet is known to nbgrader, too."""
    ball.write(Text(parts=("a", "d", "b"), givens=RANGE, points=2))
    made = ball.generate("ada", "ben", "cyd")
    ball.hand_in(made, "cyd", X1_1_d="1e9")
    done = forked.run(
        [Path(sys.executable).with_name("nbgrader"), "autograde", "week", "--force"],
        cwd=ball.course,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    with sqlite3.connect(ball.course / "gradebook.db") as book:
        maxima = book.execute(
            "select max_score from grade_cells g join base_cell b on b.id = g.id where b.name = 'X1_1_a'"
        )
        assert maxima.fetchall() == [(2.0,)]
    found = scores(ball.course)
    assert {key: score for key, (score, _) in found.items()} == {
        ("ada", "X1_1_a"): 2.0,
        ("ada", "X1_1_b"): 2.0,
        ("ada", "X1_1_c"): 1.0,
        ("ada", "X1_1_d"): None,
        ("ben", "X1_1_a"): 2.0,
        ("ben", "X1_1_b"): 2.0,
        ("ben", "X1_1_c"): 0.0,
        ("ben", "X1_1_d"): None,
        ("cyd", "X1_1_a"): 2.0,
        ("cyd", "X1_1_b"): 2.0,
        ("cyd", "X1_1_c"): None,
        ("cyd", "X1_1_d"): 0.0,
    }
    assert not any(waits for _, waits in found.values())
    again = ball.grade(made.course)
    assert (again.graded, again.changed) == ((), ()), "our own command has nothing left to do"
    assert {student: (record.points, record.out_of) for student, record in again.records.items()} == {
        "ada": (5.0, 5.0),
        "ben": (4.0, 5.0),
        "cyd": (4.0, 6.0),
    }
    assert scores(ball.course) == found
