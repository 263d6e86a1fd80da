"""A student's marks written wherever they stand: gradebook, record, history, feedback page; and the pages made again when a
person gave some."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import msgspec

from corollary.atomic import write_each_whole
from corollary.nbgrader.gradebook import gradebook, has_gradebook
from corollary.nbgrader.graded import GradedSubmission
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.records.manual import ManualMarks, OfStudent, read_manual
from corollary.records.marks import NewMarks, feedback_place, page_facts_place, stored_record, write_marks
from corollary.records.record import with_manual
from corollary.render.feedback_facts import PageFacts, unpacked
from corollary.render.feedback_page import feedback_page

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


def current_manual(course: Course) -> ManualMarks:
    """What persons gave up to this moment, by the gradebook where there is one. Writes nothing."""
    if not has_gradebook(course):
        return read_manual(course)
    from corollary.nbgrader.manual import manual_marks

    with gradebook(course) as book:
        return manual_marks(course, book)


def synchronized(course: Course) -> ManualMarks:
    """The same, recorded; whoever calls it is the only writer in the course."""
    if not has_gradebook(course):
        return read_manual(course)
    from corollary.nbgrader.manual import synchronize

    with gradebook(course) as book:
        return synchronize(course, book)


def write_graded(
    course: Course,
    problem_set: ProblemSet,
    several: Sequence[GradedSubmission],
    manual: Mapping[str, OfStudent],
    book: Gradebook | None,
    *,
    anew: bool = False,
) -> None:
    """Submissions into the gradebook (None: there is none), in one transaction, and the files; their records are written last,
    so that a run cut short does them again.

    `manual` is what persons gave, by student. `anew`: what lies in `autograded/` is no earlier marking."""
    if book is None:
        name = problem_set.name
        write_each_whole(
            {course.notebook("autograded", one.marked.student.id, name): one.notebook for one in several}
        )
    else:
        from corollary.nbgrader.record import record_several

        record_several(course, book, problem_set, several, manual, anew=anew)
    new = [
        NewMarks(student, one.record, one.facts, one.page_with(manual.get(student, {})))
        for one in several
        for student in (one.marked.student.id,)
    ]
    write_marks(course, problem_set, new)


def stale_pages(
    course: Course, set_name: str, manual: ManualMarks, students: Iterable[str]
) -> dict[str, str]:
    """The pages of those to whom a person gave something since theirs was made, as they are to be."""
    entries = manual.by_student(set_name)
    pages = {one: page_now(course, set_name, one, entries[one]) for one in students if one in entries}
    return {
        one: page
        for one, page in pages.items()
        if page is not None and page.encode() != _written(course, set_name, one)
    }


def page_now(course: Course, set_name: str, student: str, manual: OfStudent) -> str | None:
    """The feedback page with the marks as they stand; None where none can be made: the marks are an earlier version's."""
    record, facts = stored_record(course, set_name, student), stored_facts(course, set_name, student)
    if record is None or facts is None:
        return None
    return feedback_page(facts, with_manual(record, manual))


def stored_facts(course: Course, set_name: str, student: str) -> PageFacts | None:
    """What a page is made again from; None when there is nothing, or it is damaged."""
    try:
        return unpacked(page_facts_place(course, set_name, student).read_bytes())
    except (OSError, msgspec.DecodeError):
        return None


def _written(course: Course, set_name: str, student: str) -> bytes:
    try:
        return feedback_place(course, set_name, student).read_bytes()
    except OSError:
        return b""
