"""Marks in the gradebook, those of several students in one transaction, and the marked notebooks beside it."""

# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.
# pyright: reportAttributeAccessIssue=false, reportReturnType=false

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import nbformat

from corollary.answers.verdict import Unread
from corollary.atomic import write_each_whole, write_whole
from corollary.grading.part_grades import Marked, PartGrade
from corollary.nbgrader.gradebook import NotRegistered, has_seen, seen
from corollary.nbgrader.graded import GradedSubmission
from corollary.nbgrader.manual_grades import fill, is_blank, lateness_penalty
from corollary.nbgrader.marked_notebook import answer_digest, part_grades
from corollary.nbgrader.safe import safe_markdown
from corollary.notebook.locate import answer_id
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.records.manual_marks import OfStudent
from corollary.records.marks import UNMARKED, PartRecord, Record, changed_by_points, out_of_now
from corollary.records.submissions import STAMP, beside, handed_in, own_folder, stamp, stated

if TYPE_CHECKING:
    from nbgrader.api import Assignment, Grade, Gradebook, SubmittedAssignment, SubmittedNotebook


def in_gradebook(
    course: Course, book: Gradebook, problem_set: ProblemSet, records: Mapping[str, Record]
) -> set[str]:
    """Whose marks the gradebook has as they are recorded; it may have been restored from a backup since."""
    from nbgrader.api import Assignment, BaseCell, Grade, SubmittedAssignment, SubmittedNotebook

    name = problem_set.name
    rows = (
        book.db.query(
            SubmittedAssignment.student_id, SubmittedAssignment.timestamp, BaseCell.name, Grade.auto_score
        )
        .select_from(SubmittedAssignment)
        .join(Assignment, Assignment.id == SubmittedAssignment.assignment_id)
        .join(SubmittedNotebook, SubmittedNotebook.assignment_id == SubmittedAssignment.id)
        .join(Grade, Grade.notebook_id == SubmittedNotebook.id)
        .join(BaseCell, BaseCell.id == Grade.cell_id)
        .filter(Assignment.id == book.find_assignment(name).id)
    )
    scores: dict[str, dict[str, float | None]] = {}
    moments: dict[str, datetime | None] = {}
    for student, moment, cell, score in rows:
        scores.setdefault(student, {})[cell] = score
        moments[student] = moment
    return {
        student
        for student, record in records.items()
        if _has_all(scores.get(student, {}), record)
        and moments[student] == _in_utc(handed_in(course, name, student))
    }


def _has_all(scores: Mapping[str, float | None], record: Record) -> bool:
    """Whether the scores are those recorded; a part that the student was not asked has none."""
    recorded = {part: _recorded_score(one) for part, one in record.parts.items()}
    return recorded == {part: scores[part] for part in recorded if part in scores} and not any(
        score for part, score in scores.items() if part not in recorded
    )


def _recorded_score(part: PartRecord) -> float | None:
    return None if part.verdict == UNMARKED else part.points


def _in_utc(when: datetime | None) -> datetime | None:
    """A moment as the gradebook keeps it: UTC, without a zone."""
    return None if when is None else when.astimezone(UTC).replace(tzinfo=None)


def record_several(
    course: Course,
    book: Gradebook,
    problem_set: ProblemSet,
    several: Sequence[GradedSubmission],
    manual: Mapping[str, OfStudent],
    *,
    anew: bool = False,
) -> None:
    """Writes the gradebook first, then the files: cut short in between, the next run finds the old notebooks and writes again.

    `manual` is what persons gave, by student, which a gradebook that has never heard of it is given too. `anew`: what lies in
    `autograded/` is no earlier marking.
    """
    name, files = problem_set.name, dict[Path, str | bytes]()
    followed = 0
    with book.db.no_autoflush:
        for graded in several:
            student = graded.marked.student.id
            text, when = _timestamp(course, name, student)
            given = manual.get(student, {})
            submission = _record(course, book, name, graded, given, anew)
            followed += len(changed_by_points(given, graded.record)) if given else 0
            submission.timestamp = when
            _set_dates(submission, problem_set.due, graded.submission.due)
            files[course.notebook("autograded", student, name)] = graded.notebook
            for file, content in (
                (STAMP, text),
                ("submission_secret.txt", _secret(course, name, student)),
            ):
                if content:  # release_feedback tells by them which hand-in a page is of, and where the student looks for it
                    for step in ("autograded", "feedback"):
                        files[course.place(step, student, name) / file] = content
    if followed and (entries := seen(book)) is not None:
        has_seen(book, entries + followed)
    book.db.commit()
    write_each_whole(files)


def _record(
    course: Course, book: Gradebook, name: str, graded: GradedSubmission, manual: OfStudent, anew: bool
) -> SubmittedAssignment:
    """One student's scores and comments, not yet committed."""
    place = course.notebook("autograded", graded.marked.student.id, name)
    record = graded.record
    now = {**manual, **out_of_now(manual, record)}

    def same(key: str) -> bool:
        """Whether what a person gave stands: for this answer, and out of what the part earns now."""
        mark, answer = now.get(key), graded.answers.get(key, "")
        if mark is not None and key in record.parts and record.why_again(key, mark):
            return False
        if mark is not None and mark.answer:
            return mark.answer == answer
        return not anew and _digest_before(place, key) == answer

    submission = _submission(book, name, graded.marked)
    for each in submission.notebooks:
        if is_blank(each):
            fill(each, now)
        _follow_points(each, manual, now)
        _write_scores(each, graded.marked, same)
    return submission


def _set_dates(submission: SubmittedAssignment, due: datetime | None, own: datetime | None) -> None:
    """The date of the set as it is now, and what the student has beyond it: formgrader shows both."""
    submission.assignment.duedate = _in_utc(due)
    submission.extension = own - due if own is not None and due is not None and own > due else None


def _submission(book: Gradebook, name: str, marked: Marked) -> SubmittedAssignment:
    """The student's submission in the gradebook, with a row for every cell. nbgrader's own add_submission would commit it
    before there are any marks in it."""
    from nbgrader.api import Comment, Grade, MissingEntry, Student, SubmittedAssignment, SubmittedNotebook

    try:
        return book.find_submission(name, marked.student.id)
    except MissingEntry:
        assignment = _assignment(book, name)
    student = book.db.merge(Student(id=marked.student.id))
    with book.db.no_autoflush:
        submission = SubmittedAssignment(assignment=assignment, student=student)
        for notebook in assignment.notebooks:
            theirs = SubmittedNotebook(notebook=notebook, assignment=submission)
            for cell in notebook.grade_cells:
                Grade(cell=cell, notebook=theirs)
            for cell in notebook.solution_cells:
                Comment(cell=cell, notebook=theirs)
        book.db.add(submission)
    return submission


def _assignment(book: Gradebook, name: str) -> Assignment:
    from nbgrader.api import MissingEntry

    try:
        return book.find_assignment(name)
    except MissingEntry:
        raise NotRegistered(
            f"the gradebook does not know {name}; make it with corollary generate {name}"
        ) from None


def _write_scores(notebook: SubmittedNotebook, marked: Marked, same: Callable[[str], bool]) -> None:
    """`same` says of a part whether its answer is the one a person may have given a score for."""
    parts = dict(part_grades(marked))
    answered = {answer_id(key, part.part): part for key, part in parts.items()}
    for grade in notebook.grades:
        part = parts.get(grade.name)
        grade.auto_score = None if part is None or part.waits else part.points
        grade.needs_manual_grade = _needs_person(grade, part, marked, same)
    for comment in notebook.comments:
        part = answered.get(comment.name)
        comment.auto_comment = safe_markdown(part.feedback) if part is not None and part.feedback else None
    notebook.late_submission_penalty = lateness_penalty(notebook, marked.late_share)


def _follow_points(notebook: SubmittedNotebook, before: OfStudent, now: OfStudent) -> None:
    """Scores of which the share stands where their part earns other points; one that a person gave meanwhile is left."""
    for grade in notebook.grades:
        if grade.name in before and grade.manual_score == before[grade.name].score:
            grade.manual_score = now[grade.name].score


def _needs_person(grade: Grade, part: PartGrade | None, marked: Marked, same: Callable[[str], bool]) -> bool:
    """A score that a person gave stands as long as the answer it was given for; for another answer it is shown again.

    No answer from a notebook that could not be run to its end is no points and a flag: the machine may be to blame.
    """
    if grade.manual_score is None:  # pyright: ignore[reportUnnecessaryComparison]
        if part is None:  # added after the student's sheet was handed out, or gone before it was marked
            return False
        if float(grade.extra_credit or 0) > 0 and not same(grade.name):  # pyright: ignore[reportArgumentType]
            return True
        return part.waits or (bool(marked.trouble) and isinstance(part.verdict, Unread))
    return not same(grade.name)


def _digest_before(place: Path, key: str) -> str:
    """A digest of what the student wrote for a part in the marked notebook that lies there; nothing when there is none."""
    try:
        return answer_digest(nbformat.read(place, as_version=4), key)
    # no notebook yet, or one that somebody broke: as if there were none
    except (OSError, ValueError, AttributeError, KeyError):
        return ""


def _timestamp(course: Course, name: str, student: str) -> tuple[str, datetime | None]:
    """The text of timestamp.txt, and the moment as the gradebook keeps it (UTC, no zone).

    formgrader takes a submission for graded only when the file in `submitted/` says the very moment the gradebook has, and
    release_feedback fails without one: one that nbgrader does not understand as we do is written again. One that says no time
    was set aside before, with a guess in its place, or cannot be: it stays as it is.
    """
    when = handed_in(course, name, student)
    if when is None:
        return "", None
    moment = _in_utc(when)
    text = _stamped(beside(course, name, student, STAMP), moment)
    if text is None:
        text = stamp(when)
        # A folder that is a link or a file, or closed, takes none: it is reported as unreadable already, and must not stop the
        # marking of all the others.
        with suppress(OSError):
            place = own_folder(course, name, student)
            if place is not None and stated(course, name, student) is not None:
                write_whole(place / STAMP, text)
    return text, moment


def _stamped(content: bytes, moment: datetime | None) -> str | None:
    """The text of a timestamp.txt that means this moment to nbgrader too; None when it is missing or means anything else."""
    from nbgrader.utils import parse_utc

    try:
        text = content.decode("utf-8").strip()
        return text if text and parse_utc(text) == moment else None
    except (
        OSError,
        ValueError,
        OverflowError,
        TypeError,
        Warning,
    ):  # dateutil raises a warning for some zones
        return None


def _secret(course: Course, name: str, student: str) -> bytes:
    """What nbgrader's exchange finds the student's feedback by, where it was used."""
    return beside(course, name, student, "submission_secret.txt")
