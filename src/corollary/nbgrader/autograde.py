"""`nbgrader autograde` in a course of ours: the sheet restored, the verdict from outside, the marks kept."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import atexit
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import cache, lru_cache, partial
from pathlib import Path
from typing import Any, cast

import nbformat
from nbconvert.exporters import NotebookExporter
from nbconvert.exporters.exporter import ResourcesDict
from nbformat import NotebookNode
from nbgrader.api import Gradebook, MissingEntry
from nbgrader.converters import Autograde
from nbgrader.converters.base import NbGraderException
from nbgrader.coursedir import CourseDirectory
from nbgrader.preprocessors import AssignLatePenalties, Execute, OverwriteCells, SaveAutoGrades
from traitlets import Integer

from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission, state_by_name, state_of
from corollary.messages import speak
from corollary.nbgrader.alone import alone, course_of
from corollary.nbgrader.graded import GradedSubmission, grade_submission
from corollary.nbgrader.marked_notebook import restored
from corollary.nbgrader.register import follow_points
from corollary.nbgrader.written_marks import write_graded
from corollary.notebook.worksheet import Worksheet
from corollary.problem.bank import Bank
from corollary.records.assignments import is_assigned, read_assigned
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, open_course, students
from corollary.records.manual_marks import read_manual
from corollary.records.origin import set_of
from corollary.records.regrading import dependencies
from corollary.records.settings import read_settings
from corollary.records.submissions import (
    GuessedTime,
    all_guessed,
    fingerprint,
    guessed_time,
    read_submission,
    settle_time,
    submissions,
)
from corollary.sandbox.file import Unreadable, bytes_of
from corollary.sandbox.notebook_file import Notebook
from corollary.sandbox.runner import Runner


class NotOnRoster(LookupError):
    """The student was never given any numbers; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Assignment:
    """One submission, with what is needed to mark it; the variants come from the course's record, never from the notebook."""

    course: Course
    submission: Submission
    context: GradingContext

    @property
    def worksheet(self) -> Worksheet:
        """The student's own sheet."""
        return self.context.worksheet(self.submission)

    @property
    def node(self) -> NotebookNode | None:
        """The notebook as it was handed in; None when it cannot be opened."""
        received = self.submission.notebook
        return received.node if isinstance(received, Notebook) else None


def assignment_of(about: Mapping[str, str]) -> Assignment | None:
    """What nbgrader's resources tell of, in the course around the working folder; None when the set is not of ours.

    Raises NotOnRoster, and what reading the course and the set raises.
    """
    here = Path.cwd()
    name, student = about.get("assignment", ""), about.get("student", "")
    if not name or not (here / ".corollary" / "key").is_file():
        return None
    course = open_course(here)
    if not is_assigned(course, name):
        return None
    if code := read_settings(here).language:
        speak(code)
    bank, problem_set = set_of(course, name)
    assigned = read_assigned(course, problem_set)
    who = next((each for each in students(course) if each.id == student), None)
    if who is None or student not in assigned:
        raise NotOnRoster(
            f"{student} handed in {name} but is not on the roster; add them and generate {name} again"
        )
    path = submissions(course, name).get(student, course.notebook("submitted", student, name))
    state = state_of(problem_set, Solutions(bank))
    terms = read_deadlines(course, problem_set).terms(student, datetime.now(UTC))
    digest = fingerprint(course, name, student, path, assigned[student], state, terms)
    submission = read_submission(course, problem_set, who, path, assigned[student], digest, terms)
    by_name = state_by_name(problem_set, Solutions(bank))
    depends = dependencies(course, name, student, path, assigned[student], terms, by_name)
    submission = replace(submission, depends=depends)
    context = GradingContext(problem_set, _solutions(bank, state), course.key, Runner)
    return Assignment(course, submission, context)


@lru_cache(maxsize=4)
def _solutions(bank: Bank, state: str) -> Solutions:
    """One for each state: a process that lives long must not mark by solutions that have changed."""
    return Solutions(bank)


Converted = tuple[NotebookNode, ResourcesDict]


class OwnSheet(NotebookExporter):
    """Reads a submission as the student's own sheet, whatever became of its metadata, statements and checks; what cannot be
    opened at all is the blank sheet, and is marked as unreadable."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        run = self.parent
        if isinstance(
            run, Autograde
        ):  # which makes its exporter before all else, and has no hook around a whole run
            run.convert_notebooks = partial(alone, run, partial(_with_times, run, run.convert_notebooks))
            run.init_assignment = partial(_without_links, run, run.init_assignment)  # pyright: ignore[reportAttributeAccessIssue]

    def from_filename(
        self, filename: str, resources: dict[str, Any] | None = None, **more: Any
    ) -> tuple[Any, Any]:
        """Without opening what was handed in: it may be a pipe that nothing comes out of, or a link to anywhere."""
        ours = _assignment((resources or {}).get("nbgrader", {}))
        if resources is None or ours is None or not _handed_in(ours, filename):
            return super().from_filename(filename, resources=resources, **more)
        place = Path(filename)
        resources["metadata"] = ResourcesDict(name=place.stem, path=str(place.parent))
        return self.from_notebook_node(restored(ours.worksheet, ours.node), resources=resources, **more)


class OwnNumbers(OverwriteCells):
    """The sheet has the student's own numbers already: the source's, which are the chapter's, must not replace them."""

    def preprocess(self, nb: NotebookNode, resources: ResourcesDict) -> Converted:
        return (
            (nb, resources)
            if _assignment(resources["nbgrader"]) is not None
            else super().preprocess(nb, resources)
        )


class JudgedOutside(Execute):
    """Runs what was handed in behind our walls and judges it outside of them; nothing a notebook prints is a mark."""

    require_isolation = Integer(1, help="Refuse to run notebooks below this isolation level (0 to 3).").tag(
        config=True
    )

    def preprocess(self, nb: NotebookNode, resources: ResourcesDict, *more: Any, **others: Any) -> Converted:
        ours = _assignment(resources["nbgrader"])
        if ours is None:
            nb, stock = super().preprocess(nb, resources, *more, **others)
            return nb, cast(ResourcesDict, stock)
        try:
            graded = grade_submission(ours.context, _runner(self.require_isolation), ours.submission)
            if graded.marked.machine_failed:
                raise NbGraderException(
                    f"this machine failed, and nothing is recorded: {graded.marked.trouble}"
                )
        except Exception:
            _flag(resources["nbgrader"])
            raise
        resources["corollary"] = ours, graded
        return nbformat.reads(graded.notebook, as_version=4), resources


class RecordMarks(SaveAutoGrades):
    """The marks as the judge gave them, in one transaction; with the history, the record and the feedback page."""

    def preprocess(self, nb: NotebookNode, resources: ResourcesDict) -> Converted:
        judged: tuple[Assignment, GradedSubmission] | None = resources.get("corollary")
        if judged is None:
            return super().preprocess(nb, resources)
        ours, graded = judged
        course, problem_set = ours.course, ours.context.problem_set
        name = problem_set.name
        given = read_manual(course).by_student(name)
        with Gradebook(resources["nbgrader"]["db_url"]) as book:
            write_graded(course, problem_set, [graded], given, book, anew=True)
        return nb, resources


class LatenessInMarks(AssignLatePenalties):
    """What the set says of late work is in the marks already."""

    def preprocess(self, nb: NotebookNode, resources: ResourcesDict) -> Converted:
        return (nb, resources) if "corollary" in resources else super().preprocess(nb, resources)


def _assignment(about: Mapping[str, str]) -> Assignment | None:
    """None for an assignment that is none of ours; what stands in the way is flagged and raised."""
    try:
        return assignment_of(about)
    except Exception:
        _flag(about)
        raise


def _with_times(run: Autograde, convert: Callable[[], None]) -> None:
    """nbgrader cannot go on where a timestamp.txt says no time: ours are settled first."""
    course, name = course_of(run), cast(CourseDirectory, run.coursedir).assignment_id
    if course is not None and is_assigned(course, name):
        deadlines, now = read_deadlines(course, set_of(course, name)[1]), datetime.now(UTC)
        guessed: dict[str, GuessedTime] = {}
        for student in submissions(course, name):
            settle_time(course, name, student, deadlines.terms(student, now))
            if (guess := guessed_time(course, name, student)) is not None:
                guessed[student] = guess
        for line in all_guessed(name, guessed):
            run.log.warning("%s", line)
    convert()
    if course is not None and is_assigned(course, name):
        follow_points(course, set_of(course, name)[1])


def _without_links(run: Autograde, init: Callable[[str, str], None], assignment: str, student: str) -> None:
    """Lets nbgrader copy what lies beside a notebook, but for what is no file of the student's: it would follow a link to the
    course's key, and wait for ever for what comes out of a pipe."""
    coursedir = cast(CourseDirectory, run.coursedir)
    root = Path(coursedir.root)
    if not (root / ".corollary" / "key").is_file():
        return init(assignment, student)
    submitted = root / "submitted"
    place = submitted / student / assignment
    strange = [
        Path(folder) / name
        for folder, _, names in os.walk(place)
        for name in names
        if not name.endswith(".ipynb")
        and isinstance(bytes_of(Path(folder) / name, within=submitted), Unreadable)
    ]
    if (place / "timestamp.txt") in strange:
        why = f"{student}: timestamp.txt is a link or no file; delete it, and autograde again"
        run.log.error(why)
        raise NbGraderException(why)
    ignored = coursedir.ignore
    for each in strange:
        run.log.warning("%s is a link or no file, and is not copied", each)
    coursedir.ignore = [*ignored, *{each.name for each in strange}]
    try:
        init(assignment, student)
    finally:
        coursedir.ignore = ignored


@cache
def _runner(require: int) -> Runner:
    """One warm process for the whole command."""
    runner = Runner(require=require)
    runner.__enter__()
    atexit.register(runner.__exit__, None, None, None)
    return runner


def _handed_in(ours: Assignment, name: str) -> bool:
    """Whether the file is what was handed in, wherever it leads; nbgrader reads its own copy in `autograded/` with the same
    classes."""
    place = ours.course.place("submitted", ours.submission.student.id, ours.context.problem_set.name)
    return Path(name).parent.resolve() == place.resolve()


def _flag(about: Mapping[str, str]) -> None:
    """No marks, and a person to look: what cannot be marked must not look as if it had been."""
    with Gradebook(about["db_url"]) as book:
        try:
            submission = book.find_submission(about["assignment"], about["student"])
        except MissingEntry:
            return
        for notebook in submission.notebooks:
            for grade in notebook.grades:
                grade.auto_score, grade.needs_manual_grade = None, True
        book.db.commit()
