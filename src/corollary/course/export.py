"""A problem set as files for elsewhere: each student's sheet with their numbers, or the marks of all."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from corollary.atomic import write_each_whole
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import SheetPlan, Worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, chapter
from corollary.records.assignments import as_printed, open_record, sheets
from corollary.records.files import Course, students
from corollary.render.exports import Target

NOBODY = Student("")


def sheets_of_course(course: Course, problem_set: ProblemSet) -> list[SheetPlan]:
    """The sheets as they were handed out; empty when the set was never generated. Raises NotACourse."""
    record = open_record(course, problem_set)
    assigned = sheets(course, problem_set, record)
    return [
        SheetPlan(as_printed(problem_set, record, student.id), student, tuple(assigned[student.id].variants))
        for student in students(course)
        if student.id in assigned
    ]


def sheets_for(problem_set: ProblemSet, solutions: Solutions, owners: Sequence[Student]) -> list[SheetPlan]:
    """Sheets without a course: distinct numbers that follow from the owners' ids alone, the same each time.

    Raises NotDerivable and NoVariant.
    """
    assigned: dict[str, list[Variant]] = {owner.id: [] for owner in owners}
    used: dict[str, set[int]] = {problem.code: set() for problem in problem_set.problems}
    for owner in owners:
        for problem in problem_set.problems_of(b"", owner.id):
            variant = solutions.assign_variant(problem, b"", owner.id, used[problem.code]).variant
            used[problem.code] |= set() if variant.index is None else {variant.index}
            assigned[owner.id].append(replace(variant, problem=problem))
    return [SheetPlan(problem_set, owner, tuple(assigned[owner.id])) for owner in owners]


def chapters_sheet(problem_set: ProblemSet) -> SheetPlan:
    """The sheet with the chapter's own numbers, which is nobody's."""
    return SheetPlan(problem_set, NOBODY, tuple(map(chapter, problem_set.problems)))


def sheet_files(
    target: Target, problem_set: ProblemSet, sheets: Sequence[Worksheet], solutions: Solutions | None
) -> dict[str, bytes]:
    """The files that a target for worksheets or for whole sets makes, by name; `solutions` adds the worked ones."""
    if target.problem_set is not None:
        return dict(target.problem_set(problem_set, sheets))
    if target.worksheet is None:
        raise TypeError("the target is neither for worksheets nor for whole sets")
    files: dict[str, bytes] = {}
    for sheet in sheets:
        worked = {} if solutions is None else _worked(solutions, sheet)
        owner = f"-{sheet.student.id}" if sheet.student.id else ""
        name = f"{problem_set.name}{owner}.{target.ending}"
        files[name] = target.worksheet(sheet, worked).encode("utf-8", "replace")
    return files


def _worked(solutions: Solutions, sheet: Worksheet) -> dict[str, str]:
    return {each.problem.code: solutions.worked_solution(each.variant) for each in sheet.exercises}


def write_files(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Writes them below the folder, and says where they are."""
    placed = {folder / name: content for name, content in files.items()}
    write_each_whole(placed)
    return list(placed)


def owners(count: int) -> Iterable[Student]:
    """Whoever is to get one of so many variants."""
    return (Student(str(number), "Variant", str(number)) for number in range(1, count + 1))
