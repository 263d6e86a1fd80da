"""`nbgrader generate_feedback` and formgrader's button in a course of ours: the one feedback page of a student."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

from functools import partial
from typing import Any

from nbconvert.exporters import HTMLExporter
from nbgrader.converters import GenerateFeedback
from nbgrader.converters.base import NbGraderException

from corollary.nbgrader.alone import alone, course_of
from corollary.nbgrader.written_marks import page_now
from corollary.records.files import Course
from corollary.records.manual_marks import read_manual
from corollary.records.marks import stored_record


class FeedbackPage(HTMLExporter):
    """Our page, with the marks as they stand, in the place of nbgrader's; assignments that are none of ours are left to it."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        run = self.parent
        self._course: Course | None = None
        if isinstance(run, GenerateFeedback):
            self._course = course_of(run)
            run.convert_notebooks = partial(alone, run, run.convert_notebooks)

    def from_filename(
        self, filename: str, resources: dict[str, Any] | None = None, **more: Any
    ) -> tuple[Any, Any]:
        about = (resources or {}).get("nbgrader", {})
        course, name, student = self._course, about.get("assignment", ""), about.get("student", "")
        if course is None or stored_record(course, name, student) is None:
            return super().from_filename(filename, resources=resources, **more)
        return _page(course, name, student), {**(resources or {}), "output_extension": ".html"}


def _page(course: Course, name: str, student: str) -> str:
    manual = read_manual(course).by_student(name).get(student, {})
    page = page_now(course, name, student, manual)
    if page is None:
        raise NbGraderException(
            f"the record behind the feedback page of {student} in {name} is lost or damaged; "
            f"run corollary grade {name}, then generate feedback again"
        )
    return page
