"""Marks that a person gives through us: into the gradebook where there is one, and into the journal."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.nbgrader.gradebook import gradebook, has_gradebook, has_seen
from corollary.records.files import Course
from corollary.records.manual import ManualMark, ManualMarks, Place, read_manual, write_manual


def give(course: Course, given: Mapping[Place, ManualMark]) -> ManualMarks:
    """Everything that persons gave, these marks last. Whoever calls it is the only writer and has synchronized the course."""
    journal = read_manual(course)
    if has_gradebook(course):
        from corollary.nbgrader.manual import fill, submitted_notebooks, weigh_lateness
        from corollary.records.marks import stored_record

        with gradebook(course) as book:
            for notebook, (name, student) in submitted_notebooks(book, {place.set_name for place in given}):
                marks = {p.part: m for p, m in given.items() if (p.set_name, p.student) == (name, student)}
                record = stored_record(course, name, student)
                if marks and record is not None:
                    fill(notebook, marks, record)
                    weigh_lateness(notebook, record.late_share)
            has_seen(book, journal.count + len(given))
            book.db.commit()
    write_manual(course, given)
    return journal.and_then(given)
