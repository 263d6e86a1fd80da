"""Sheets for elsewhere: the course's own numbers where there is one, distinct ones that stay the same where there is none."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.course.export import chapters_sheet, owners, sheet_files, sheets_for, sheets_of_course
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.problem.variant import at
from corollary.records.assignments import Assigned, numbers_of, save_record
from corollary.records.files import create_course
from corollary.render.exports import target

from .small_class import SET

SOLUTIONS = Solutions(chapter_bank())


@pytest.fixture
def small(tmp_path: Path) -> ProblemSet:
    (tmp_path / "small.md").write_text(SET)
    return find_set(SOLUTIONS.bank, str(tmp_path / "small.md"))


def test_a_course_keeps_its_numbers_and_who_has_none_gets_no_sheet(small: ProblemSet, tmp_path: Path) -> None:
    course = create_course(tmp_path / "course", [Student("ada"), Student("ben"), Student("new")])
    assert sheets_of_course(course, small) == []
    record, kick = Assigned([], {}), small.problems[0]
    for student, index in (("ada", 817), ("ben", 3)):
        record.students[student] = {kick.code: numbers_of(at(kick, index), record.place(kick, 1.0))}
    save_record(course, small, record)
    sheets = [plan.worksheet() for plan in sheets_of_course(course, small)]
    assert [(sheet.student.id, sheet.exercises[0].variant.index) for sheet in sheets] == [
        ("ada", 817),
        ("ben", 3),
    ]
    files = sheet_files(target("md"), small, sheets, None)
    assert sorted(files) == ["small-ada.md", "small-ben.md"]
    assert b"Worked solution" not in files["small-ada.md"]
    assert b"Worked solution" in sheet_files(target("md"), small, sheets, SOLUTIONS)["small-ada.md"]


def test_variants_are_distinct_and_the_same_again(small: ProblemSet) -> None:
    def indices() -> list[int | None]:
        sheets = sheets_for(small, SOLUTIONS, tuple(owners(5)))
        return [sheet.variants[0].index for sheet in sheets]

    assert len(set(indices())) == 5
    assert indices() == indices()


def test_without_anybody_there_is_one_sheet_with_the_chapters_numbers(small: ProblemSet) -> None:
    sheet = chapters_sheet(small).worksheet()
    assert sheet.exercises[0].variant.index is None
    assert list(sheet_files(target("ipynb"), small, [sheet], None)) == ["small.ipynb"]
