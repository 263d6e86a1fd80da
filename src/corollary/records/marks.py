"""Marks: records of parts and submissions, the newest of each student, merged with what persons gave."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from types import MappingProxyType
from typing import Any, assert_never

import msgspec

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.atomic import write_each_whole, write_whole
from corollary.grading.mark_record import marked_record
from corollary.grading.part_grades import Marked, NearMiss
from corollary.grading.stopped_cells import StoppedCell, package_state
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import BESIDE, Course
from corollary.records.manual_marks import (
    ManualMark,
    ManualMarks,
    OfStudent,
    append,
    entries,
    journal_place,
    last_lines,
    read_manual,
)
from corollary.version import __version__

RIGHT, WRONG, UNMARKED = (word(verdict) for verdict in (Right(), Wrong(), Unmarked("")))


class Row(msgspec.Struct, frozen=True):
    """One part of one student, points before lateness. `verdict` is its word, `error` the mistake or slip, `why` the rest;
    `by_hand`: a person gave the points."""

    student: str
    problem: str
    part: str
    verdict: str
    points: float
    out_of: float
    error: str = ""
    why: str = ""
    by_hand: bool = False
    rubric: tuple[str, ...] = ()
    again: bool = (
        False  # a person marked it, and is to look again: the answer is another now, or its points are
    )
    near: NearMiss | None = None  # another reading by which an answer that earned nothing would be right

    @property
    def waits(self) -> bool:
        return self.verdict == UNMARKED or self.again

    @property
    def near_miss(self) -> NearMiss | None:
        """The other reading, as long as no person has decided on the answer."""
        return None if self.by_hand and not self.again else self.near


class HandedIn(msgspec.Struct, frozen=True):
    """One submission as a whole: points after lateness; `late` in seconds; `trouble` a sentence, or empty; `notes` tell
    what was noticed."""

    student: str
    name: str
    points: float
    out_of: float
    late: float = 0.0
    late_share: float = 1.0
    trouble: str = ""
    isolation: str = ""
    notes: tuple[str, ...] = ()


class PartRecord(msgspec.Struct, frozen=True):
    """One part as it was marked; a mistake, a slip or a rubric only where the verdict has one, and `manual` only where a
    person gave something (never in the files of the program's own marks). `basis` says what the points go by where the verdict
    does not."""

    verdict: str
    points: float
    out_of: float
    answer: str = ""
    feedback: str = ""
    mistake: str | msgspec.UnsetType = msgspec.UNSET
    slip: str | msgspec.UnsetType = msgspec.UNSET
    rubric: tuple[str, ...] | msgspec.UnsetType = msgspec.UNSET
    manual: ManualMark | msgspec.UnsetType = msgspec.UNSET
    basis: tuple[str, ...] | msgspec.UnsetType = msgspec.UNSET


class Record(msgspec.Struct, frozen=True):
    """How a student's marks in one set came about: answers, verdicts, variants, isolation, and the fingerprint of all that
    they depend on. Parts go by their name in the notebook (X12_5_a); `late` in seconds; `answers` holds a digest of what the
    student wrote for each, `stopped` the cells that did not run to their end, `depends` says what else the marks depend on, by
    name: a digest of each, and when it was handed in."""

    points: float
    out_of: float
    parts: dict[str, PartRecord]
    fingerprint: str
    handed_in: HandedIn
    rows: tuple[Row, ...]
    variants: dict[str, int | None] = {}
    isolation: str = ""
    trouble: str = ""
    late: float = 0.0
    late_share: float = 1.0
    notes: tuple[str, ...] = ()
    version: str = ""
    answers: dict[str, str] = {}
    depends: dict[str, str] = {}
    stopped: tuple[StoppedCell, ...] = ()

    def row(self, part: str) -> Row:
        """The row of a part, which is named as in the notebook. Raises KeyError."""
        return dict(zip(self.parts, self.rows, strict=True))[part]

    def why_again(self, part: str, mark: ManualMark) -> str:
        """Why a person is to look again at what a person gave, `mark` being out of what the part earns now; empty when not."""
        if mark.score is None and not mark.extra_credit:
            return ""
        if self.is_other_answer(part, mark):
            if mark.score is None:
                return f"the answer has changed since a person gave it {mark.extra_credit:g} as extra credit"
            return "the answer has changed since a person marked it"
        out_of = self.parts[part].out_of
        if mark.first is not None:
            score, most = mark.first
            return f"given {score:g} of {most:g}, now out of {out_of:g}"
        if mark.score is not None and mark.score > out_of + 1e-9:
            return f"given {mark.score:g} by hand, but it earns no more than {out_of:g}"
        return ""

    def is_other_answer(self, part: str, mark: ManualMark) -> bool:
        """Whether a person's mark was given for another answer than the one that lies there now."""
        now = self.answers.get(part, "")
        return bool(mark.answer and now) and mark.answer != now


def record_of(
    marked: Marked,
    fingerprint: str,
    answers: Mapping[str, str] = MappingProxyType({}),
    depends: Mapping[str, str] = MappingProxyType({}),
) -> Record:
    """What is recorded of a submission's marks; `answers` is a digest of what was written for each part, `depends` of all else."""
    about = {
        "fingerprint": fingerprint,
        "handed_in": handed_in(marked),
        "rows": rows(marked),
        "answers": dict(answers),
        "depends": _without_packages(depends) | packages_missed(marked.stopped),
    }
    return msgspec.convert(marked_record(marked) | about | {"version": __version__}, Record)


THE_PACKAGE = "the package "
"""The head of the names by which marks depend on packages that were missing."""


def packages_missed(stopped: Iterable[StoppedCell]) -> dict[str, str]:
    """What marks depend on besides: the packages that cells could not import, each with its state then."""
    return {
        f"{THE_PACKAGE}{each.about}": each.state for each in stopped if each.kind == "package" and each.state
    }


def packages_now(record: Record | None, declared: Sequence[str] | None) -> dict[str, str]:
    """The state by now of the packages that were missing when these marks were given."""
    names = [
        name.removeprefix(THE_PACKAGE)
        for name in (record.depends if record else {})
        if name.startswith(THE_PACKAGE)
    ]
    return {f"{THE_PACKAGE}{name}": package_state(name, declared) for name in names}


def _without_packages(depends: Mapping[str, str]) -> dict[str, str]:
    return {name: state for name, state in depends.items() if not name.startswith(THE_PACKAGE)}


def handed_in(marked: Marked) -> HandedIn:
    """The submission as a whole."""
    return HandedIn(
        marked.student.id,
        marked.student.name,
        marked.points,
        marked.out_of,
        marked.late,
        marked.late_share,
        marked.trouble,
        marked.isolation,
        marked.notes,
    )


def rows(marked: Marked) -> tuple[Row, ...]:
    """One row for each part of one submission."""
    return tuple(
        Row(
            marked.student.id,
            grade.variant.problem.code,
            part.part.id,
            word(part.verdict),
            part.points,
            part.out_of,
            *_reasons(part.verdict),
            rubric=part.verdict.rubric if isinstance(part.verdict, Unmarked) else (),
            near=part.near,
        )
        for grade in marked.grades
        for part in grade.parts
    )


def _reasons(verdict: Verdict) -> tuple[str, str]:
    """The mistake or slip, and what else there is to know."""
    match verdict:
        case Right(note):
            return "", note
        case Follows(earlier):
            return "", f"from {', '.join(earlier)}"
        case Mistaken(mistake, earlier):
            return mistake, f"from {', '.join(earlier)}" if earlier else ""
        case Slip(slip):
            return slip, ""
        case Wrong(why) | Unread(why) | Unmarked(why):
            return "", why
        case _:
            assert_never(verdict)


def with_manual(record: Record, given: OfStudent) -> Record:
    """The marks as they stand: what a person gave counts in the place of the program's, and lateness applies to it as well."""
    given = {part: mark for part, mark in out_of_now(given, record).items() if mark.is_given}
    if not given:
        return record
    parts = {name: _part_with(part, given.get(name)) for name, part in record.parts.items()}
    points = round(sum(part.points for part in parts.values()) * record.late_share, 6)
    names = zip(record.rows, record.parts, strict=True)  # rows and parts are of one order
    rows = tuple(_row_with(row, parts[name], record, name) for row, name in names)
    whole = msgspec.structs.replace(record.handed_in, points=points)
    return msgspec.structs.replace(record, points=points, parts=parts, rows=rows, handed_in=whole)


def out_of_now(given: OfStudent, record: Record) -> OfStudent:
    """What a person gave for the parts of a record, out of the points that they earn in it."""
    return {
        part: mark.out_of_now(record.parts[part].out_of)
        for part, mark in given.items()
        if part in record.parts
    }


def changed_by_points(given: OfStudent, record: Record) -> OfStudent:
    """Those of them that are other scores now, for their part earns other points."""
    return {part: mark for part, mark in out_of_now(given, record).items() if mark is not given[part]}


def _part_with(part: PartRecord, mark: ManualMark | None) -> PartRecord:
    if mark is None:
        return part
    score = part.points if mark.score is None else mark.score
    counts = (
        mark.score is not None or part.verdict != UNMARKED
    )  # as in nbgrader: nothing is added to no score
    earned = round(score + ((mark.extra_credit or 0.0) if counts else 0.0), 6)
    verdict = part.verdict if mark.score is None else _verdict_by_hand(part, mark.score)
    return msgspec.structs.replace(part, verdict=verdict, points=earned, manual=mark)


def _verdict_by_hand(part: PartRecord, score: float) -> str:
    """All points are for a right answer; for fewer the program's verdict stands, unless it was that one or none."""
    if score >= part.out_of:
        return RIGHT
    return WRONG if part.verdict in {RIGHT, UNMARKED} else part.verdict


def _row_with(row: Row, part: PartRecord, record: Record, name: str) -> Row:
    if part.manual is msgspec.UNSET:
        return row
    by_hand = part.manual.score is not None
    again = record.why_again(name, part.manual)
    why = again or ("" if by_hand else row.why)
    error = "" if by_hand and part.verdict == RIGHT else row.error
    return msgspec.structs.replace(
        row,
        verdict=part.verdict,
        points=part.points,
        error=error,
        why=why,
        by_hand=by_hand,
        again=bool(again),
    )


class NothingGraded(LookupError):
    """There are no marks yet; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class NewMarks:
    """What is written of one student's marks: the record, the feedback page, and the facts that it is made again from."""

    student: str
    record: Record
    facts: bytes
    page: str


def write_marks(course: Course, problem_set: ProblemSet, several: Sequence[NewMarks]) -> None:
    """The feedback pages and the facts on them, the history's lines and the records, in this order: a record says that
    everything before it is done.

    Cut short anywhere, `settle` and a second run leave one page, one line and one record of each.
    """
    name = problem_set.name
    facts = {page_facts_place(course, name, one.student): one.facts for one in several}
    pages = {feedback_place(course, name, one.student): one.page for one in several}
    write_each_whole({**facts, **pages})
    about = {"at": datetime.now(UTC).isoformat(timespec="seconds"), "together": len(several)}
    lines = [{"student": one.student, **about, **msgspec.to_builtins(one.record)} for one in several]
    append(_history(course, name), lines)
    write_each_whole({_place(course, name, one.student): msgspec.json.encode(one.record) for one in several})


def read_record(course: Course, problem_set: ProblemSet, student: str) -> Record | None:
    """The newest record of a student's marks; None when there is none, or it is damaged (then it is marked again)."""
    return stored_record(course, problem_set.name, student)


def stored_record(course: Course, set_name: str, student: str) -> Record | None:
    """The same, for a set of which only the name is known."""
    try:
        return msgspec.json.decode(_place(course, set_name, student).read_bytes(), type=Record)
    except (OSError, msgspec.DecodeError):
        return None


def graded_sets(course: Course) -> list[str]:
    """The names of the sets of which somebody's marks are recorded."""
    places = course.record("graded", "any").parent.glob("*/")
    return sorted(place.name for place in places)


def check_graded(course: Course, set_name: str) -> None:
    """Raises NothingGraded unless the set was graded, though nobody may have handed in: the report says that."""
    if not report_place(course, set_name).exists() and set_name not in graded_sets(course):
        raise NothingGraded(
            f"no submission of {set_name} is graded in {course.folder}; "
            f"run corollary grade {set_name} --course {course.folder} first"
        )


def read_records(course: Course, problem_set: ProblemSet, students: Iterable[str]) -> dict[str, Record]:
    """The records of those students who have one: the program's own marks."""
    found = {student: read_record(course, problem_set, student) for student in students}
    return {student: record for student, record in found.items() if record is not None}


def read_marks(
    course: Course, problem_set: ProblemSet, students: Iterable[str], manual: ManualMarks | None = None
) -> dict[str, Record]:
    """The marks as they stand, of those students who have any: the program's, merged with what persons gave.

    `manual` is what they gave; what the journal holds when left out.
    """
    given = (read_manual(course) if manual is None else manual).by_student(problem_set.name)
    found = read_records(course, problem_set, students)
    return {student: with_manual(record, given.get(student, {})) for student, record in found.items()}


def history(course: Course, set_name: str) -> Iterator[dict[str, Any]]:
    """Every mark ever given in a set, oldest first: a record as plain data, with its `student` and the moment `at`."""
    return entries(_history(course, set_name))


def settle(course: Course, problem_set: ProblemSet) -> None:
    """Completes what a run that was cut short left undone: its last lines are in the history, and their records not yet written.

    Everything else of those marks was written before their lines, so that they need not be given again.
    """
    path, newest = _history(course, problem_set.name), dict[str, Record]()
    for line in last_lines(path, _together(path)):
        try:
            newest[str(msgspec.json.decode(line)["student"])] = msgspec.json.decode(line, type=Record)
        except (msgspec.DecodeError, KeyError, TypeError):  # cut short: that mark will be given again
            continue
    for student, record in newest.items():
        if read_record(course, problem_set, student) != record:
            _write_record(course, problem_set.name, student, record)


def _together(history: Path) -> int:
    """How many marks were written together with the last one: its line says so, or the one before where it was cut short."""
    lines = last_lines(history, 2)
    for cut_short, line in enumerate(reversed(lines)):
        try:
            return int(msgspec.json.decode(line).get("together", 1)) + cut_short
        except (msgspec.DecodeError, AttributeError, TypeError, ValueError):
            continue
    return len(lines)


def feedback_place(course: Course, set_name: str, student: str) -> Path:
    """A student's feedback page: where nbgrader has it too, so that there is one."""
    return course.place("feedback", student, set_name) / f"{set_name}.html"


def last_change(course: Course, set_name: str) -> float:
    """When a mark was last given, by whomever, in seconds since 1970; 0 for never."""
    places = [_history(course, set_name), journal_place(course)]
    return max((place.stat().st_mtime for place in places if place.exists()), default=0.0)


def report_place(course: Course, set_name: str) -> Path:
    """The report's page."""
    return course.folder / "reports" / f"{set_name}.html"


def page_facts_place(course: Course, set_name: str, student: str) -> Path:
    """What a feedback page says besides the marks, from which it is made again when a person gives some."""
    return course.record("pages", f"{set_name}/{student}.json")


def write_page(course: Course, set_name: str, student: str, page: str) -> None:
    """The feedback page, and beside it what nbgrader's exchanges go by."""
    place = feedback_place(course, set_name, student)
    write_whole(place, page)
    for name in sorted(BESIDE):
        marked = course.place("autograded", student, set_name) / name
        if marked.is_file() and not (place.parent / name).exists():
            write_whole(place.parent / name, marked.read_bytes())


def _write_record(course: Course, set_name: str, student: str, record: Record) -> None:
    write_whole(_place(course, set_name, student), msgspec.json.encode(record))


def _place(course: Course, set_name: str, student: str) -> Path:
    return course.record("graded", f"{set_name}/{student}.json")


def _history(course: Course, set_name: str) -> Path:
    return course.record("history", f"{set_name}.jsonl")
