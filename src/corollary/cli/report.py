"""`corollary report`: what an instructor reads."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.cli.terminal import bar, console
from corollary.course.up_to_date import up_to_date
from corollary.nbgrader.written_marks import current_manual, synchronized
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import BeingGraded, Course, find_student, ids_in, one_writer, open_course
from corollary.records.marks import graded_sets
from corollary.records.origin import set_of
from corollary.records.report_model import Report, report_of, report_record
from corollary.records.settings import read_settings

if TYPE_CHECKING:
    from corollary.records.statistics import SetStatistics


def run(
    name: str | None,
    course: Path,
    bank: Path | None,
    as_json: bool,
    output: Path | None,
    statistics: bool,
    csv: Path | None,
    section: str | None = None,
    group: str | None = None,
    student: str | None = None,
) -> int:
    opened = open_course(course)
    if student is not None:
        return _history(opened, student, name or "", as_json)
    if name is None:
        refuse(
            "name the problem set, as in: corollary report week1; or a student: corollary report --student ada"
        )
    place, problem_set = set_of(opened, name, bank)
    only = ids_in(opened, section, group)
    found = up_to_date(opened, problem_set)
    if only is not None:
        found = report_of(opened, problem_set, current_manual(opened), only=only)
    estimates = _statistics(opened, problem_set, place, found) if statistics or csv is not None else None
    if estimates is not None and csv is not None:
        from corollary.problem.csv_table import table_text
        from corollary.records.statistics import statistics_rows

        csv.write_text(table_text(statistics_rows(estimates)), encoding="utf-8")
        say(f"written to {csv}")
    if output is not None:
        from corollary.render.report_page import report_page  # brings the templates

        way = Path(os.path.relpath(opened.folder, output.resolve().parent)).as_posix()
        formgrader = read_settings(opened.folder).formgrader
        output.write_text(
            report_page(found, problem_set, formgrader=formgrader, course=way, statistics=estimates),
            encoding="utf-8",
        )
        say(f"written to {output}")
    if as_json:
        from_all = {} if estimates is None else {"statistics": _record(estimates)}
        answer({**report_record(found), **from_all})
    elif output is None:
        from corollary.render.report_page import terminal

        console().print(terminal(found))
        if estimates is not None:
            from corollary.render.statistics_table import statistics_table

            console().print(statistics_table(estimates))
    return HOLDS


def _history(course: Course, name: str, set_name: str, as_json: bool) -> int:
    """All that was ever given to one student."""
    from corollary.records.student_history import history_record, student_history
    from corollary.render.history_table import history_table

    who = find_student(course, name)
    with suppress(BeingGraded), one_writer(course):
        synchronized(course)
    found = student_history(course, who.id, set_name)
    if set_name and not found:
        refuse(
            f"nothing of {who.id} is marked in {set_name}; sets with marks: {', '.join(graded_sets(course)) or 'none'}"
        )
    if as_json:
        answer(history_record(found, who.id, {who.id: who.name}))
    else:
        console().print(history_table(found, who.name_with_id, read_settings(course.folder).usual.zone))
    return HOLDS


def _record(estimates: SetStatistics) -> dict[str, object]:
    from corollary.records.statistics import statistics_record

    return statistics_record(estimates)


def _statistics(course: Course, problem_set: ProblemSet, bank: Bank, report: Report) -> SetStatistics:
    """Brings numpy, and the derivations of the whole set."""
    from corollary.course.wrong_answers import drawn_keys, drawn_numbers, unlisted
    from corollary.grading.solutions import Solutions
    from corollary.records.statistics import set_statistics

    marked = {row.student for row in report.rows}
    with bar("numbers drawn", len(marked)) as done:
        keys = drawn_keys(course, problem_set, Solutions(bank), marked, done)
    return set_statistics(report, drawn_numbers(keys), unlisted(course, problem_set, keys))
