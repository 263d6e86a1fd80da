"""Feedback pages on their way back into an LMS, each to the student whose it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from corollary.course.lms_places import NoPlaces, packed, places
from corollary.course.up_to_date import up_to_date
from corollary.nbgrader.written_marks import stored_facts
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, students
from corollary.records.lms_names import LmsName
from corollary.records.manual_marks import read_manual
from corollary.records.marks import feedback_place, stored_record, with_manual
from corollary.render.feedback_notebook import feedback_notebook


@dataclass(frozen=True, slots=True)
class FeedbackFiles:
    """The pages by their names in the archive that `lms` ("moodle" or "canvas") takes back, and whose have no place in it."""

    lms: str
    files: Mapping[str, bytes]
    without: tuple[str, ...]


def feedback_files(course: Course, problem_set: ProblemSet, ids: Path | None = None) -> FeedbackFiles:
    """The pages with what persons gave up to now, for the LMS that `ids`, or else what was collected, comes from.

    Raises NoPlaces, NotACourse and Malformed.
    """
    up_to_date(course, problem_set)
    name, roster = problem_set.name, students(course)
    pages: dict[str, tuple[str, bytes]] = {}
    for student in roster:
        path = feedback_place(course, name, student.id)
        if path.is_file():
            pages[student.id] = (f"{name}-feedback.html", path.read_bytes())
    if not pages:
        raise NoPlaces(
            f"nobody has a feedback page of {name} in {course.folder}: nothing was handed in when it was graded"
        )
    try:
        lms, found = "moodle", places(course, name, roster, "moodle", ids)
    except NoPlaces as error:
        try:
            lms, found = "canvas", places(course, name, roster, "canvas", ids)
        except NoPlaces:
            raise error from None
    if lms == "canvas":
        pages |= _as_handed_in(course, name, found, pages)
    files = packed(lms, found, pages, roster)
    return FeedbackFiles(lms, files, tuple(student for student in pages if student not in found))


def _as_handed_in(
    course: Course, set_name: str, found: Mapping[str, LmsName], pages: Iterable[str]
) -> Iterator[tuple[str, tuple[str, bytes]]]:
    """Notebooks for those who handed one in: Canvas gives a file back under the name of theirs (`display_name`), and a page
    that is called `week1.ipynb` opens nowhere."""
    manual = read_manual(course).by_student(set_name)
    for student in pages:
        record, facts = stored_record(course, set_name, student), stored_facts(course, set_name, student)
        if student in found and found[student].file.endswith(".ipynb") and record and facts:
            text = feedback_notebook(facts, with_manual(record, manual.get(student, {})))
            yield student, (f"{set_name}-feedback.ipynb", text.encode())
