"""Marks that persons gave in formgrader or through nbgrader, read from the gradebook, and restored to one that lost them.

The gradebook counts how many entries of our journal it has seen. One that has seen fewer than there are was restored from a
backup, or is new: then the journal is right. Otherwise what the gradebook says is newer, be it a score or its withdrawal.
"""

# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.
# pyright: reportAttributeAccessIssue=false, reportReturnType=false, reportGeneralTypeIssues=false
# pyright: reportUnnecessaryComparison=false, reportArgumentType=false, reportUnknownParameterType=false
# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from corollary.nbgrader.gradebook import has_seen, seen
from corollary.records.files import Course
from corollary.records.manual_marks import (
    GRADEBOOK,
    NOTHING,
    ManualMark,
    ManualMarks,
    OfStudent,
    Place,
    login_name,
    read_manual,
    write_manual,
)
from corollary.records.marks import UNMARKED, PartRecord, Record, graded_sets, stored_record
from corollary.records.outside_changes import OutsideChange, noticed, write_outside
from corollary.records.regrading import CENT

if TYPE_CHECKING:
    from nbgrader.api import Comment, Grade, Gradebook, SubmittedNotebook


@dataclass(frozen=True, slots=True)
class FromGradebook:
    """What stands in the gradebook for one part; `flagged`: nbgrader has a person look at it."""

    mark: ManualMark
    flagged: bool = False


def manual_marks(course: Course, book: Gradebook) -> ManualMarks:
    """What persons gave up to this moment, and what nobody has to agree to. Writes nothing."""
    journal = read_manual(course)
    return journal.and_then(_parted(course, _newer(course, book, journal), journal)[0])


def synchronize(course: Course, book: Gradebook) -> ManualMarks:
    """What persons gave up to this moment, with journal and gradebook brought to say the same; but a score that stood already and
    was changed in the gradebook waits until somebody agrees to it.

    Whoever calls it is the only writer in the course.
    """
    journal = read_manual(course)
    newer, outside = _parted(course, _newer(course, book, journal), journal)
    if _is_older(book, journal):
        given = {name: journal.by_student(name) for name in {place.set_name for place in journal.by_place}}
        for notebook, (name, student) in submitted_notebooks(book, set(given)):
            if not is_blank(notebook) and student in given[name]:
                fill(notebook, given[name][student], stored_record(course, name, student))
    _weigh_lateness(course, book)
    has_seen(book, journal.count + len(newer))
    # The gradebook first: cut short in between it has seen more than there is, and is read again.
    book.db.commit()
    write_manual(course, newer)
    write_outside(course, outside)
    return journal.and_then(newer)


def fill(notebook: SubmittedNotebook, given: OfStudent, record: Record | None = None) -> None:
    """Puts marks into the rows of one submission; what is not among them stays. `record`: the program's own marks, by which it
    is known whether the answer is still the one a mark was given for."""
    for grade in notebook.grades:
        if (mark := given.get(grade.name)) is not None:
            again = False
            if record is not None and grade.name in record.parts:
                mark = mark.out_of_now(record.parts[grade.name].out_of)
                again = bool(record.why_again(grade.name, mark))
            grade.manual_score, grade.extra_credit = mark.score, mark.extra_credit
            grade.needs_manual_grade = again or (mark.score is None and grade.auto_score is None)
    names = {grade.name for grade in notebook.grades}
    written: set[str] = set()
    for comment in sorted(notebook.comments, key=lambda one: one.name):
        part = _part_of(comment.name, names)
        if (mark := given.get(part)) is not None:
            comment.manual_comment = mark.comment if part not in written else None
            written.add(part)


def is_blank(notebook: SubmittedNotebook) -> bool:
    """Whether nbgrader has made the rows of a submission and nobody has written into them yet."""
    grades: Iterable[Grade] = notebook.grades
    comments: Iterable[Comment] = notebook.comments
    given = (each for grade in grades for each in (grade.auto_score, grade.manual_score, grade.extra_credit))
    words = (each for comment in comments for each in (comment.auto_comment, comment.manual_comment))
    return all(each is None for each in (*given, *words))


def lateness_penalty(notebook: SubmittedNotebook, late_share: float) -> float | None:
    """What is taken off late work, whoever gave the points; None where nothing is."""
    return (1 - late_share) * sum(map(_score, notebook.grades)) if late_share < 1 else None


def weigh_lateness(notebook: SubmittedNotebook, late_share: float) -> None:
    """Writes into the gradebook what lateness takes off the scores as they are."""
    notebook.late_submission_penalty = lateness_penalty(notebook, late_share)


def _score(grade: Grade) -> float:
    """As nbgrader counts it; asked of the row itself, whose sum may be of before."""
    given = grade.manual_score if grade.manual_score is not None else grade.auto_score
    return (given or 0.0) + ((grade.extra_credit or 0.0) if given is not None else 0.0)


def _weigh_lateness(course: Course, book: Gradebook) -> None:
    """formgrader knows nothing of the late share: what it takes off is worked out again from the scores as they are."""
    from nbgrader.api import SubmittedNotebook

    late = SubmittedNotebook.late_submission_penalty.isnot(None)
    for notebook in book.db.query(SubmittedNotebook).filter(late):
        submission = notebook.assignment
        record = stored_record(course, submission.assignment.name, submission.student_id)
        if record is not None and record.late_share < 1:
            penalty = lateness_penalty(notebook, record.late_share)
            if abs((penalty or 0.0) - notebook.late_submission_penalty) > 1e-9:
                notebook.late_submission_penalty = penalty


def _newer(course: Course, book: Gradebook, journal: ManualMarks) -> dict[Place, ManualMark]:
    """What the gradebook has and the journal has not, or has otherwise; each with the answer it was given for."""
    older = _is_older(book, journal)
    there = _given(book, set(graded_sets(course)))
    found: dict[Place, ManualMark] = {}
    records = cache(partial(stored_record, course))
    for place, entry in there.items():
        before = journal.by_place.get(place)
        if before is not None and older:
            continue
        record = records(place.set_name, place.student)
        answer, out_of = ("", 0.0) if record is None else _now(record, place.part)
        if before is not None and before.score == entry.mark.score and entry.flagged:
            if not before.equals(entry.mark):  # the score itself is still to be looked at
                about = replace(entry.mark, answer=before.answer, out_of=before.out_of, first=before.first)
                found[place] = about
            continue
        resolved = before is not None and (bool(answer and before.answer != answer) or before.first)
        if before is None or not before.equals(entry.mark) or resolved:
            score = entry.mark.score
            known = score is not None and score <= out_of  # more was given out of something else
            found[place] = replace(entry.mark, answer=answer, out_of=out_of if known else 0.0)
    if older:
        return found
    gone = {place for place, mark in journal.by_place.items() if mark.is_given and place not in there}
    if gone:
        written = {
            key
            for notebook, key in submitted_notebooks(book, {p.set_name for p in gone})
            if not is_blank(notebook)
        }
        found |= {place: NOTHING for place in gone if (place.set_name, place.student) in written}
    return found


def _parted(
    course: Course, newer: Mapping[Place, ManualMark], journal: ManualMarks
) -> tuple[dict[Place, ManualMark], dict[Place, OutsideChange]]:
    """What counts at once, and what would move points that stand: those are asked about."""
    counting: dict[Place, ManualMark] = {}
    outside: dict[Place, OutsideChange] = {}
    records = cache(partial(stored_record, course))
    for place, mark in newer.items():
        before = journal.by_place.get(place, NOTHING)
        by = login_name()
        if before.score is not None and before.score == mark.score:  # its comment or its answer is another
            mark = replace(mark, rubric=before.rubric)
        mark = replace(mark, by=by, source=GRADEBOOK, request=before.request)
        record = records(place.set_name, place.student)
        part = None if record is None else record.parts.get(place.part)
        if record is None or part is None:
            counting[place] = mark
            continue
        stands = before.out_of_now(part.out_of)
        old, new = _points(stands, part), _points(mark, part)
        looked_at_again = bool(before.is_given and record.why_again(place.part, stands))
        if old is None or looked_at_again or (new is not None and abs(new - old) < CENT):
            counting[place] = mark
        else:
            outside[place] = noticed(place, old, new, mark)
    return counting, outside


def _points(mark: ManualMark, part: PartRecord) -> float | None:
    """What a part earns with this mark; None where it waits."""
    score = mark.score if mark.score is not None else None if part.verdict == UNMARKED else part.points
    return None if score is None else score + (mark.extra_credit or 0.0)


def _now(record: Record, part: str) -> tuple[str, float]:
    """The digest of the answer that lies there, and what the part earns; nothing where it is not known."""
    return record.answers.get(part, ""), record.parts[part].out_of if part in record.parts else 0.0


def _given(book: Gradebook, sets: set[str]) -> dict[Place, FromGradebook]:
    """Every part of these sets for which somebody gave something."""
    from nbgrader.api import Assignment, BaseCell, Comment, Grade, SubmittedAssignment, SubmittedNotebook

    about = (Assignment.name, SubmittedAssignment.student_id, BaseCell.name)

    def rows(
        table: type[Grade] | type[Comment], *columns: object, where: object
    ) -> Iterator[tuple[Any, ...]]:
        yield from (
            book.db.query(*about, *columns)
            .select_from(SubmittedAssignment)
            .join(Assignment, Assignment.id == SubmittedAssignment.assignment_id)
            .join(SubmittedNotebook, SubmittedNotebook.assignment_id == SubmittedAssignment.id)
            .join(table, table.notebook_id == SubmittedNotebook.id)
            .join(BaseCell, BaseCell.id == table.cell_id)
            .filter(Assignment.name.in_(sets))
            .filter(where)
            .order_by(BaseCell.name)
        )

    found: dict[Place, FromGradebook] = {}
    columns = Grade.manual_score, Grade.extra_credit, Grade.needs_manual_grade
    scored = Grade.manual_score.isnot(None) | (Grade.extra_credit > 0)
    for name, student, cell, score, extra, flagged in rows(Grade, *columns, where=scored):
        mark = ManualMark(score, extra or None)
        found[Place(name, student, cell)] = FromGradebook(mark, flagged)
    comments = rows(Comment, Comment.manual_comment, where=Comment.manual_comment.isnot(None))
    parts = _parts(book, sets)
    for name, student, cell, comment in comments:
        if comment.strip():
            place = Place(name, student, _part_of(cell, parts[name]))
            before = found.get(place, FromGradebook(NOTHING))
            words = "\n\n".join(filter(None, (before.mark.comment, comment)))
            found[place] = FromGradebook(replace(before.mark, comment=words), before.flagged)
    return found


def _parts(book: Gradebook, sets: set[str]) -> dict[str, set[str]]:
    """The names of the parts of each set, which are those of its graded cells."""
    return {
        assignment.name: {cell.name for notebook in assignment.notebooks for cell in notebook.grade_cells}
        for assignment in book.assignments
        if assignment.name in sets
    }


def _part_of(cell: str, parts: set[str]) -> str:
    """The part that a comment on a cell is about: points stand on the check below the cell where the answer is written."""
    candidates = (cell, cell.removesuffix("_answer"), cell.removesuffix("_plot"))
    return next((each for each in candidates if each in parts), cell)


def submitted_notebooks(
    book: Gradebook, sets: set[str]
) -> Iterator[tuple[SubmittedNotebook, tuple[str, str]]]:
    """The submissions to these sets, with the names of set and student."""
    for assignment in book.assignments:
        for submission in assignment.submissions if assignment.name in sets else ():
            for notebook in submission.notebooks:
                yield notebook, (assignment.name, submission.student_id)


def notebooks_of(
    book: Gradebook, whose: Iterable[tuple[str, str]]
) -> Iterator[tuple[SubmittedNotebook, tuple[str, str]]]:
    """The submissions of these students, each with the names of set and student; none for who has none."""
    from nbgrader.api import MissingEntry

    for name, student in whose:
        with suppress(MissingEntry):
            for notebook in book.find_submission(name, student).notebooks:
                yield notebook, (name, student)


def _is_older(book: Gradebook, journal: ManualMarks) -> bool:
    """Whether the gradebook lacks entries that the journal has."""
    count = seen(book)
    return count is not None and count < journal.count
