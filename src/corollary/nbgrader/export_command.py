"""`nbgrader export` in a course of ours: nbgrader's own table, once lateness has been taken off what persons gave."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING

from nbgrader.apps import ExportApp
from nbgrader.plugins import CsvExportPlugin

from corollary.nbgrader.alone import course_of
from corollary.nbgrader.manual_grades import synchronize
from corollary.records.files import BeingGraded, one_writer

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


class CurrentMarks(CsvExportPlugin):
    """Scores and lateness as they are at this moment."""

    def export(self, gradebook: Gradebook) -> None:
        app = self.parent
        course = course_of(app) if isinstance(app, ExportApp) else None
        if course is not None:
            with (
                suppress(BeingGraded),
                one_writer(course),
            ):  # a run that is grading brings the gradebook up to date itself
                synchronize(course, gradebook)
        super().export(gradebook)
