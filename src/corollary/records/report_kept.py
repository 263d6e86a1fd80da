"""The report on a set from what is kept of every submission."""

from __future__ import annotations

from corollary.problem.problem_set import ProblemSet
from corollary.records.course import Course, students
from corollary.records.records import kept_sharing, read_record
from corollary.records.report import report
from corollary.records.report_model import HandedIn, Report, Row


def report_of(course: Course, problem_set: ProblemSet) -> Report:
    """The report from the records kept beside the course."""
    order = [(problem.code, part.id) for problem in problem_set.problems for part in problem.parts]
    roster = [student.id for student in students(course)]
    kept = [entry for student in roster if (entry := read_record(course, problem_set, student)) is not None]
    all_rows = [Row(**each) for entry in kept for each in entry["rows"]]
    all_rows.sort(
        key=lambda each: (
            order.index((each.problem, each.part)) if (each.problem, each.part) in order else len(order)
        )
    )
    return report(
        [HandedIn(**entry["handed_in"]) for entry in kept],
        all_rows,
        roster=roster,
        shared=kept_sharing(course, problem_set),
    )
