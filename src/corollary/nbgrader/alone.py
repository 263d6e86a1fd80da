"""Whole runs of nbgrader's commands as the only writer in a course; marks that persons gave are recorded first."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import cast

from nbgrader.api import Gradebook
from nbgrader.apps import ExportApp
from nbgrader.converters.base import BaseConverter, NbGraderException
from nbgrader.coursedir import CourseDirectory

from corollary.nbgrader.manual_grades import synchronize
from corollary.nbgrader.written_marks import stale_pages
from corollary.problem.bank import UnknownCode
from corollary.problem.diagnostic import Malformed
from corollary.records.editions import NotSettled
from corollary.records.files import BeingGraded, Course, NotACourse, one_writer, open_course, students
from corollary.records.marks import write_page

REFUSALS = (BeingGraded, NotACourse, UnknownCode, NotSettled, Malformed)


def alone(run: BaseConverter, convert: Callable[[], None]) -> None:
    """Converts, with the course locked; refused before anything is touched when another run has it."""
    place = cast(CourseDirectory, run.coursedir)
    with ExitStack() as held:
        try:
            if (course := course_of(run)) is None:
                convert()
                return
            held.enter_context(one_writer(course))
            everybody = [student.id for student in students(course)]
            with Gradebook(place.db_url, place.course_id) as book:
                manual = synchronize(course, book)
            convert()
        except REFUSALS as error:
            run.log.error(str(error))
            raise NbGraderException(str(error)) from None
        for student, page in stale_pages(course, place.assignment_id, manual, everybody).items():
            write_page(course, place.assignment_id, student, page)


def course_of(run: BaseConverter | ExportApp) -> Course | None:
    """The course of ours that nbgrader works in; None when it is none. Raises NotACourse when its key is damaged."""
    root = Path(cast(CourseDirectory, run.coursedir).root)
    return open_course(root) if (root / ".corollary" / "key").is_file() else None
