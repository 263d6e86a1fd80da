"""Marks as a table: what is blank, how they are rounded, and that parts add up."""

from __future__ import annotations

import runpy
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.problem.roster import Student
from corollary.records.marks_table import Mark, MarksTable, Notation, every_column, part_columns, set_column

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
ADA, BO, EVE = Student("ada", "Ada", "Lovelace"), Student("bo"), Student("eve")


@pytest.fixture
def graded(tmp_path: Path):
    """Ada in time with one part waiting, Eve the same and late, at half the marks; nothing of Bo."""
    of = SAMPLE["problem_set"](tmp_path)
    return of, SAMPLE["summary"]([SAMPLE["marked"](of), SAMPLE["late"](SAMPLE["marked"](of, "eve"))])


def test_the_mark_of_a_set_is_the_one_of_the_report(graded) -> None:
    of, report = graded
    column = set_column(of, report)
    assert (column.title, column.also, column.out_of) == ("Momentum & impulse", (of.name,), 12)
    table = MarksTable((ADA, BO, EVE), (column,))
    assert [table.cell(each, column) for each in table.students] == ["4.5", "", "2.25"]
    assert table.waiting == ("ada", "eve")
    excused = set_column(of, report, {"ada"})
    assert [MarksTable((ADA,), (excused,)).cell(ADA, excused)] == [""]


def test_parts_are_after_lateness_and_add_up_to_the_set(graded) -> None:
    of, report = graded
    columns = part_columns(of, report)
    assert [column.title for column in columns[:2]] == [
        "Momentum & impulse X12.5 a",
        "Momentum & impulse X12.5 b",
    ]
    whole = set_column(of, report)
    for each in (ADA, EVE):
        points = sum(column.marks[each.id].points for column in columns if each.id in column.marks)
        assert points == pytest.approx(whole.marks[each.id].points)
    (waiting,) = (column for column in columns if column.waiting)
    assert (waiting.title, waiting.waiting, waiting.out_of) == (
        "Momentum & impulse X12.5 e",
        ("ada", "eve"),
        2,
    )
    assert not waiting.marks
    assert sum(column.out_of for column in columns) == of.out_of


def test_every_column_has_parts_before_lateness_the_total_after_it_and_what_it_is_out_of(graded) -> None:
    of, report = graded
    columns = list(every_column(of, report, (ADA, BO, EVE)))
    table = MarksTable((ADA, BO, EVE), tuple(columns))
    assert [column.title for column in columns][-3:] == ["P12.14 b", "total", "out_of"]
    assert [table.cell(EVE, column) for column in columns][:2] == ["1", "1"]
    assert [table.cell(BO, column) for column in columns][-2:] == ["", "12"]


ROUNDED = [
    (2.675, 2, "2.68"),
    (0.125, 2, "0.13"),
    (1.005, 2, "1.01"),
    (4.5, 0, "5"),
    (2.5, 0, "3"),
    (1 / 3 + 1 / 3, 3, "0.667"),
    (10.0, 2, "10"),
    (0.004, 2, "0"),
    (100.0, 0, "100"),
]


@pytest.mark.parametrize(("points", "decimals", "written"), ROUNDED)
def test_half_a_unit_is_rounded_up(points: float, decimals: int, written: str) -> None:
    assert Notation(decimals).written(Mark(points, 100)) == written


def test_marks_are_scaled_each_by_what_it_is_out_of_and_commas_where_they_are_wanted() -> None:
    assert Notation(1, out_of=100).written(Mark(2, 3)) == "66.7"
    assert Notation(1, out_of=100, point=",").written(Mark(4, 6)) == "66,7"
    assert Notation(out_of=10).written(Mark(0, 0)) == "0"


@given(st.floats(0, 1e6), st.integers(0, 4))
def test_what_is_written_is_within_half_a_unit(points: float, decimals: int) -> None:
    assert abs(
        float(Notation(decimals).written(Mark(points, 1e6))) - points
    ) <= 0.5 * 10**-decimals + 1e-8 * (1 + points)


def test_who_has_a_sheet_out_of_other_points_is_named(graded) -> None:
    of, report = graded
    column = set_column(of, report)
    fewer = replace(column, marks={**column.marks, "ada": Mark(4.5, 10.0)})
    assert MarksTable((ADA, EVE), (column,)).out_of_another == ()
    assert MarksTable((ADA, EVE), (fewer,)).out_of_another == ("ada",)
    assert MarksTable((ADA, EVE), (fewer,), Notation(out_of=100)).out_of_another == (), (
        "all are out of a hundred then"
    )
