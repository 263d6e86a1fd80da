"""The marks of a course in one or several sets, as a table and as the file that an LMS takes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from corollary.course.up_to_date import up_to_date
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import read_assigned
from corollary.records.deadlines import read_deadlines
from corollary.records.editions import NotSettled
from corollary.records.files import Course, students
from corollary.records.lms_file import FilledIn, fill_in
from corollary.records.marks_table import (
    Column,
    MarksTable,
    Notation,
    every_column,
    part_columns,
    set_column,
)
from corollary.render.exports import MarksText, Target

By = Literal["sets", "parts", "every"]


@dataclass(frozen=True, slots=True)
class Template:
    """A file that the LMS exported, and the headings of the columns to fill in where their titles do not say."""

    path: Path
    headings: Sequence[str] = ()


def marks_table(course: Course, sets: Sequence[ProblemSet], by: By, notation: Notation) -> MarksTable:
    """The marks as they stand, for everybody on the roster; excused students have none. Raises NothingGraded and NotACourse."""
    roster = students(course)
    columns: list[Column] = []
    for problem_set in sets:
        report = up_to_date(course, problem_set)
        deadlines = read_deadlines(course, problem_set)
        excused = {each.id for each in roster if deadlines.excused(each.id)}
        if by == "sets":
            columns.append(set_column(problem_set, report, excused))
        elif by == "parts":
            columns += part_columns(problem_set, report, excused)
        else:
            columns += every_column(problem_set, report, roster, excused, _out_of(course, problem_set))
    return MarksTable(roster, tuple(columns), notation)


def _out_of(course: Course, problem_set: ProblemSet) -> dict[str, float]:
    """What each student's own sheet is out of; nothing while a name is to be settled."""
    try:
        sheets = read_assigned(course, problem_set)
    except NotSettled:
        return {}
    return {
        student: sum(
            part.points * problem_set.weight(variant.problem)
            for variant in sheet.variants
            for part in variant.problem.parts
        )
        for student, sheet in sheets.items()
    }


def marks_file(target: Target, table: MarksTable, template: Template | None) -> FilledIn:
    """The file's content, with what is to be said of it. Raises Malformed for a template that cannot be filled in."""
    if template is not None:
        return fill_in(template.path, table, template.headings)
    if target.marks is None:
        raise TypeError("the target is not for marks")
    made = target.marks(table)
    if isinstance(made, str):
        made = MarksText(made)
    return FilledIn(made.text.encode(), (), made.absent, made.notes)
