"""The problem that a command is about, and its numbers: the problem's own, a student's, those assigned in a course, or a variant's."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.ending import refuse
from corollary.problem.bank import Bank, home
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant, at, chapter, size


def chosen_problem(bank: Path | None, course: Path | None, code: str) -> tuple[Bank, Problem]:
    """The problem and its bank: the one named, else one that sets of the course were dealt from, else as without a course.

    Raises UnknownCode, Malformed and NotACourse.
    """
    if course is not None and bank is None:
        from corollary.records.files import open_course
        from corollary.records.origin import home_in_course

        if (found := home_in_course(open_course(course), code)) is not None:
            return found
    return home(bank, code)


def chosen_variant(
    place: Bank, problem: Problem, student: str | None, course: Path | None, variant: int | None = None
) -> Variant:
    """Those of a student in a course are the ones dealt there. Ends the command where a course has none for a student."""
    if variant is not None:
        return at(problem, variant)
    if student is None:
        return chapter(problem)
    if course is None:
        from corollary.grading.solutions import Solutions  # needed for the answers only

        return Solutions(place).assign_variant(problem, b"", student, ()).variant
    from corollary.records.assignments import variant_anywhere
    from corollary.records.files import find_student, open_course

    opened = open_course(course)
    found = variant_anywhere(opened, problem, find_student(opened, student).id)
    if found is None and size(problem) > 1:
        refuse(
            f"{student} has no sheet with {problem.code} in {course}; generate a set with this problem first"
        )
    return found or chapter(problem)
