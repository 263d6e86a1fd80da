"""The marks of a set as a table: one row a student, one column a part, and the total after lateness."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import COLUMNS, Student
from corollary.records.report_model import Report
from corollary.render.exports import Target
from corollary.render.wording import points


def write_marks(problem_set: ProblemSet, report: Report, roster: Sequence[Student]) -> str:
    """Blank where nothing was handed in, where a part was not asked and where it waits for a person: none of these is a zero.

    Parts that are gone, and that somebody has marks for, stand behind those of today.
    """
    todays = [(problem.code, part.id) for problem in problem_set.problems for part in problem.parts]
    parts = list(dict.fromkeys([*todays, *((row.problem, row.part) for row in report.rows)]))
    earned = {
        (row.student, row.problem, row.part): points(row.points)
        for row in report.rows
        if row.verdict != "unmarked"
    }
    totals = {one.student: one for one in report.handed_in}
    table = io.StringIO()
    rows = csv.writer(table, lineterminator="\n")
    rows.writerow([*COLUMNS, *(f"{code} {part}" for code, part in parts), "total", "out_of"])
    for student in roster:
        total = totals.get(student.id)
        about = (student.id, student.first_name, student.last_name, student.email)
        by_part = (earned.get((student.id, code, part), "") for code, part in parts)
        sums = (points(total.points) if total else "", points((total or problem_set).out_of))
        rows.writerow([*about, *by_part, *sums])
    return table.getvalue()


TARGET = Target(ending="csv", marks=write_marks)
