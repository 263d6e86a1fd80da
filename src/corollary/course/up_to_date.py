"""Marks as they stand at this moment, whoever gave them, and everything that is made of them brought up to date."""

from __future__ import annotations

from corollary.atomic import write_whole
from corollary.nbgrader.written_marks import current_manual, stale_pages, synchronized
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import BeingGraded, Course, one_writer, students
from corollary.records.manual_marks import ManualMarks
from corollary.records.marks import check_graded, last_change, report_place, write_page
from corollary.records.report_model import Report, report_of
from corollary.records.settings import read_settings


def up_to_date(course: Course, problem_set: ProblemSet) -> Report:
    """The report with what persons gave up to this moment; feedback pages and the report's page say the same from then on.

    While a grading run writes in the course, nothing is written: it does the same itself. Raises NotACourse, NothingGraded
    before anything is written, and what the gradebook refuses.
    """
    check_graded(course, problem_set.name)
    try:
        with one_writer(course):
            manual = synchronized(course)
            return renewed(course, problem_set, manual)
    except BeingGraded:
        return report_of(course, problem_set, current_manual(course))


def renewed(course: Course, problem_set: ProblemSet, manual: ManualMarks) -> Report:
    """The pages made again of those to whom a person gave something since, and the report's page with them."""
    everybody = [student.id for student in students(course)]
    stale = stale_pages(course, problem_set.name, manual, everybody)
    report = report_of(course, problem_set, manual)
    page = report_place(course, problem_set.name)
    if page.exists() and (stale or last_change(course, problem_set.name) > page.stat().st_mtime):
        from corollary.render.report_page import report_page  # brings matplotlib

        formgrader = read_settings(course.folder).formgrader
        write_whole(page, report_page(report, problem_set, formgrader=formgrader))
    for student, text in stale.items():  # last: cut short before, they are found stale again
        write_page(course, problem_set.name, student, text)
    return report
