"""A term: every student's result in every set of a course, totals, who misses what, and who falls behind."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime

import msgspec

from corollary.messages import did_you_mean
from corollary.problem.bank import Bank, UnknownCode
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assignments import read_numbers, sets_with_numbers
from corollary.records.deadlines import Deadlines, read_deadlines, read_extensions
from corollary.records.files import Course, NotACourse, students
from corollary.records.manual_marks import ManualMarks, OfStudent
from corollary.records.marks import UNMARKED, Record, graded_sets, stored_record, with_manual
from corollary.records.origin import set_of
from corollary.records.submissions import UNUSABLE, read_arrivals
from corollary.records.term_rules import TermRules
from corollary.records.term_totals import (
    EXCUSED,
    MARKED,
    MISSING,
    NO_SHEET,
    OPEN,
    UNGRADED,
    WAITS,
    SetResult,
    TermTotal,
    term_total,
)


class PartMark(msgspec.Struct, frozen=True):
    """One part of one student as it is recorded, as far as a term needs it."""

    problem: str
    part: str
    verdict: str
    points: float
    out_of: float
    error: str = ""
    again: bool = False

    @property
    def waits(self) -> bool:
        return self.verdict == UNMARKED or self.again


class SetMark(msgspec.Struct, frozen=True):
    """A record of marks, as far as a term needs it: a thousand of a dozen sets are read in a second."""

    points: float
    out_of: float
    rows: tuple[PartMark, ...]
    late: float = 0.0
    late_share: float = 1.0
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class TermSet:
    """A set of the term: its weight, its deadline for everybody, and whether any of it was graded. `problem_set` and `bank` are None
    where its file is lost."""

    name: str
    title: str
    weight: float
    due: datetime | None
    is_graded: bool
    problem_set: ProblemSet | None
    bank: Bank | None


@dataclass(frozen=True, slots=True)
class StudentTerm:
    """One student's term: a result for each set, the total, and why the student falls behind (nothing: does not)."""

    student: Student
    results: tuple[SetResult, ...]
    total: TermTotal
    missing: tuple[str, ...]
    behind: tuple[str, ...]

    @property
    def waiting(self) -> int:
        return sum(each.waiting for each in self.results)


@dataclass(frozen=True, slots=True)
class CourseTerm:
    """`marks` are those of each student by set; `notes` are sentences on what could not be read."""

    rules: TermRules
    sets: tuple[TermSet, ...]
    students: tuple[StudentTerm, ...]
    marks: Mapping[str, Mapping[str, SetMark]]
    notes: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(each.name for each in self.sets)


def read_term(
    course: Course,
    rules: TermRules,
    manual: ManualMarks,
    now: datetime,
    only: Collection[str] | None = None,
) -> CourseTerm:
    """The term of those on the roster (with `only`, of these). Raises NotACourse and UnknownCode."""
    roster = [each for each in students(course) if only is None or each.id in only]
    notes, graded = list[str](), set(graded_sets(course))
    found, results, marks = list[TermSet](), list[list[SetResult]](), dict[str, dict[str, SetMark]]()
    for name, bank, problem_set in _sets(course, rules, notes):
        marks[name] = _marks(course, name, roster, manual.by_student(name))
        deadlines = _deadlines(course, name, problem_set)
        is_graded = name in graded
        record = read_numbers(course, name)
        arrivals = read_arrivals(course, name)
        unusable = {each.student: each.why for each in arrivals if each.outcome == UNUSABLE}
        of_set = _OfSet(
            course,
            name,
            deadlines,
            frozenset(record.students if record else ()),
            is_graded,
            marks[name],
            unusable,
            now,
        )
        results.append([of_set.result(each.id) for each in roster])
        points = max((each.out_of for each in marks[name].values()), default=0.0) or _points(problem_set)
        weight = points if rules.by_points else rules.weights.get(name, 1.0)
        title = problem_set.title if problem_set is not None else name
        found.append(TermSet(name, title, weight, deadlines.due, is_graded, problem_set, bank))
    weights = [each.weight for each in found]
    people = [
        _student_term(student, [column[place] for column in results], found, weights, rules)
        for place, student in enumerate(roster)
    ]
    return CourseTerm(rules, tuple(found), tuple(people), marks, tuple(notes))


_Found = tuple[str, Bank | None, ProblemSet | None]


def _sets(course: Course, rules: TermRules, notes: list[str]) -> Sequence[_Found]:
    """The sets that count, in their order: that of the settings, else by their dates. Raises UnknownCode."""
    have = sets_with_numbers(course)
    for name in (*rules.sets, *rules.weights):
        if name not in have:
            hint = did_you_mean(name, have)
            raise UnknownCode(
                f"corollary.toml: [term] names {name}, and {course.folder} has no set of that name{hint}; "
                f"it has {', '.join(have) or 'none yet'}"
            )
    found: list[_Found] = []
    for name in rules.sets or have:
        try:
            found.append((name, *set_of(course, name)))
        except (UnknownCode, NotACourse, Malformed) as error:
            notes.append(
                f"{name}: its file cannot be read, so its date and its misconceptions are left out ({error})"
            )
            found.append((name, None, None))
    if rules.sets:
        return found
    return sorted(found, key=lambda each: _when(course, each[0], each[2]))


def _when(course: Course, name: str, problem_set: ProblemSet | None) -> tuple[float, str]:
    """By the deadline; by when it was generated where there is none."""
    if problem_set is not None and problem_set.due is not None:
        return problem_set.due.timestamp(), name
    return course.record("assigned", f"{name}.json").stat().st_mtime, name


def _deadlines(course: Course, name: str, problem_set: ProblemSet | None) -> Deadlines:
    if problem_set is not None:
        return read_deadlines(course, problem_set)
    return Deadlines(None, "no", read_extensions(course, name))


def _points(problem_set: ProblemSet | None) -> float:
    if problem_set is None:
        return 0.0
    return sum(map(problem_set.points, problem_set.problems))


def _marks(
    course: Course, name: str, roster: Sequence[Student], given: Mapping[str, OfStudent]
) -> dict[str, SetMark]:
    """The marks as they stand, by student; nothing for who has none."""
    found: dict[str, SetMark] = {}
    decoder = msgspec.json.Decoder(SetMark)
    for student in roster:
        own = given.get(student.id)
        try:
            if own:
                record = stored_record(course, name, student.id)
                if record is not None:
                    found[student.id] = _as_set_mark(with_manual(record, own))
            else:
                place = course.record("graded", f"{name}/{student.id}.json")
                found[student.id] = decoder.decode(place.read_bytes())
        except (OSError, msgspec.DecodeError):  # none, or damaged: then it is graded again
            continue
    return found


def _as_set_mark(record: Record) -> SetMark:
    rows = tuple(
        PartMark(each.problem, each.part, each.verdict, each.points, each.out_of, each.error, each.again)
        for each in record.rows
    )
    return SetMark(record.points, record.out_of, rows, record.late, record.late_share, record.trouble)


@dataclass(frozen=True, slots=True)
class _OfSet:
    """What decides a student's result in one set."""

    course: Course
    name: str
    deadlines: Deadlines
    dealt: frozenset[str]
    is_graded: bool
    marks: Mapping[str, SetMark]
    unusable: Mapping[str, str]
    now: datetime

    def result(self, student: str) -> SetResult:
        if self.deadlines.excused(student):
            return SetResult(EXCUSED)
        if student in self.marks:
            return _of_mark(self.marks[student])
        if student in self.unusable or self.course.place("submitted", student, self.name).is_dir():
            return SetResult(UNGRADED, 0.0, 1.0, trouble=self.unusable.get(student, ""))
        if student not in self.dealt:
            return SetResult(NO_SHEET)
        due = self.deadlines.of(student)
        is_over = self.is_graded if due is None else self.now > due
        return SetResult(MISSING if is_over else OPEN)


def _of_mark(mark: SetMark) -> SetResult:
    """The share of the own sheet; what waits for a person may earn nothing, or all of its points."""
    waiting = [row for row in mark.rows if row.waits]
    low = mark.points - mark.late_share * sum(row.points for row in waiting)
    high = low + mark.late_share * sum(max(row.out_of, row.points) for row in waiting)
    out_of = mark.out_of
    shares = (low / out_of, high / out_of) if out_of > 0 else (0.0, 0.0)
    state = WAITS if waiting else MARKED
    return SetResult(
        state, *shares, mark.points, out_of, len(waiting), late=mark.late > 0, trouble=mark.trouble
    )


def _student_term(
    student: Student,
    results: Sequence[SetResult],
    sets: Sequence[TermSet],
    weights: Sequence[float],
    rules: TermRules,
) -> StudentTerm:
    total = term_total(results, weights, rules)
    missing = tuple(
        one.name for one, each in zip(sets, results, strict=True) if each.state == MISSING and one.weight > 0
    )
    return StudentTerm(student, tuple(results), total, missing, tuple(_behind(total, missing, rules)))


def _behind(total: TermTotal, missing: Sequence[str], rules: TermRules) -> list[str]:
    """Why a student falls behind; nothing where the student does not. What waits for a person counts in the student's favour."""
    found: list[str] = []
    if len(missing) >= rules.missing:
        count = "1 set" if len(missing) == 1 else f"{len(missing)} sets"
        found.append(f"{count} not handed in")
    if total.high is not None and 100 * total.high < rules.below - 1e-9:
        found.append(f"total below {rules.below:g} %")
    return found
