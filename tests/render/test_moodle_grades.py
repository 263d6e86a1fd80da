"""What Moodle's import is given to know students by, and what is said of marks that it would refuse."""

from __future__ import annotations

import csv
import io

import pytest

from corollary.problem.roster import Student
from corollary.records.marks_table import Column, Mark, MarksTable, Notation
from corollary.render.targets.moodle_grades import write_marks

OLD = tuple(
    Student(name, name.title(), "Doe", f"{name}@example.org", (("ID number", number),))
    for name, number in (("ada", "0101"), ("ben", "0102"), ("cyd", "0103"))
)
NEW = Student("zoe", "Zoe", "Doe", "", (("id", "zoe"),))


def table(*students: Student, points: float = 3, out_of: float | None = None) -> MarksTable:
    column = Column("Week 1", (), 3, {each.id: Mark(points, 3) for each in students})
    return MarksTable(students, (column,), Notation(out_of=out_of))


def test_a_newcomer_without_an_id_number_takes_nobody_elses() -> None:
    made = write_marks(table(*OLD, NEW))
    rows = list(csv.DictReader(io.StringIO(made.text)))
    assert [row["ID number"] for row in rows] == ["0101", "0102", "0103"]
    assert "id" not in rows[0]
    assert made.absent == ("zoe",)
    assert any("without ID number on the roster: zoe" in note for note in made.notes)


@pytest.mark.parametrize(("points", "out_of", "advised"), [(3, 200, True), (3.3, 100, False), (3, 100, None)])
def test_scaling_is_advised_where_it_would_help(points: float, out_of: float, advised: bool | None) -> None:
    notes = " ".join(write_marks(table(*OLD, points=points, out_of=out_of)).notes)
    assert ("Moodle takes no file with a mark above 100" in notes) is (advised is not None)
    assert ("--out-of 100 scales them" in notes) is bool(advised)
    assert ("for extra credit" in notes) is (advised is False)


@pytest.mark.parametrize(("points", "said"), [(3, False), (3.3, True)])
def test_a_mark_above_what_an_assignment_may_be_out_of_is_said(points: float, said: bool) -> None:
    notes = " ".join(write_marks(table(*OLD, points=points)).notes)
    assert ("Moodle 4.5 takes no file" in notes) is said
