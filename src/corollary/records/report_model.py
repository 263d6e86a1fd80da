"""The report's data: marks, how each part went, misconceptions met, and what waits for a person."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from statistics import fmean, median
from typing import get_args

import msgspec

from corollary.answers.verdict import Verdict
from corollary.messages import few, visible
from corollary.problem.dates import written
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import name_with_id
from corollary.records.collusion import RARE, SHARING, Shared, read_shared
from corollary.records.deadlines import Deadlines, read_deadlines
from corollary.records.files import Course, students
from corollary.records.manual_marks import ManualMarks
from corollary.records.marks import UNMARKED, HandedIn, Row, read_marks
from corollary.records.near_miss_groups import NearMisses, near_misses, near_misses_record
from corollary.records.outside_changes import OutsideChange, read_outside
from corollary.records.regrade_requests import open_requests
from corollary.records.rubrics import RubricCount, rubric_counts
from corollary.records.stopped_table import StoppedRow, stopped_record, stopped_rows
from corollary.records.submissions import (
    UNUSABLE,
    guessed_time,
    handed_in,
    read_arrivals,
    read_failures,
    submissions,
    unclear,
    why_guessed,
    why_unclear,
    without_owner,
)

WORDS = tuple(verdict.__name__.lower() for verdict in get_args(Verdict))  # from the best to the worst
BY_HAND = "by_hand"


@dataclass(frozen=True, slots=True)
class PartTally:
    """How one part went. `counts` has every verdict's word, and `by_hand` for what a person marked; `share` is the mean share
    of points among marked answers, or None."""

    problem: str
    part: str
    counts: Mapping[str, int]
    share: float | None


@dataclass(frozen=True, slots=True)
class Met:
    """A misconception (`mistaken`) or a generic slip (`slip`) met in one part, and the students in whose work it was."""

    verdict: str
    text: str
    problem: str
    part: str
    students: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Waiting:
    """One answer that waits for a person, and the rubric to mark it by."""

    student: str
    problem: str
    part: str
    why: str
    rubric: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class OpenRequest:
    """A student's request for regrading of one part that nobody has answered; `text` is harmless on a terminal."""

    student: str
    part: str
    text: str
    at: str


@dataclass(frozen=True, slots=True)
class Report:
    """A graded problem set in sum; `missing` are students of the roster who handed in nothing; `shared` proves nothing,
    and `coincidences` are as many more that chance explains; `nobodys` are the files collected of which nobody knows whose they are,
    with the reason; `unusable` says of a student why what was handed in cannot be marked. `excused` need not hand in, and are counted nowhere,
    though their work is marked. `stopped` says which cells stopped, and what to do.
    `rubric` counts the items that persons ticked, `outside` are scores changed in the gradebook that
    nobody has agreed to, `requests` those for regrading that are open. `names` are those of the roster, by id."""

    handed_in: tuple[HandedIn, ...]
    rows: tuple[Row, ...]
    parts: tuple[PartTally, ...]
    met: tuple[Met, ...]
    waiting: tuple[Waiting, ...]
    missing: tuple[str, ...]
    shared: tuple[Shared, ...] = ()
    unusable: tuple[tuple[str, str], ...] = ()
    excused: tuple[str, ...] = ()
    nobodys: tuple[tuple[str, str], ...] = ()
    coincidences: int = 0
    near_misses: tuple[NearMisses, ...] = ()
    stopped: tuple[StoppedRow, ...] = ()
    rubric: tuple[RubricCount, ...] = ()
    outside: tuple[OutsideChange, ...] = ()
    requests: tuple[OpenRequest, ...] = ()
    names: Mapping[str, str] = field(default_factory=dict[str, str])

    def called(self, student: str) -> str:
        """`Ada Lovelace (0101014)`; the id alone where the roster has no name."""
        return name_with_id(self.names.get(student, student), student)

    def some(self, whose: Sequence[str], most: int) -> str:
        """The first by name, and how many more there are."""
        return few([self.called(student) for student in whose[:most]] + list(whose[most:]), most)

    @property
    def noticed(self) -> tuple[HandedIn, ...]:
        """The submissions of which something was noticed, such as an edited statement."""
        return tuple(one for one in self.handed_in if one.notes)

    @property
    def failed(self) -> tuple[HandedIn, ...]:
        """The submissions with which something went wrong as a whole."""
        return tuple(one for one in self.handed_in if one.trouble)

    @property
    def late(self) -> float:
        """The share of submissions that came late."""
        return fmean(one.late > 0 for one in self.handed_in) if self.handed_in else 0.0

    @property
    def late_count(self) -> int:
        return sum(one.late > 0 for one in self.handed_in)

    @property
    def totals(self) -> tuple[float, ...]:
        """What the sheets are out of, each number once: several where those of a pool differ."""
        return tuple(sorted({one.out_of for one in self.handed_in}))

    @property
    def shares(self) -> tuple[float, ...]:
        """Of each sheet what it earned of its own total, 1 for all of it; a sheet out of nothing has none."""
        return tuple(one.points / one.out_of for one in self.handed_in if one.out_of > 0)

    @property
    def mean(self) -> float | None:
        return fmean(one.points for one in self.handed_in) if self.handed_in else None

    @property
    def median(self) -> float | None:
        return median(one.points for one in self.handed_in) if self.handed_in else None

    @property
    def out_of(self) -> float:
        return max((one.out_of for one in self.handed_in), default=0.0)

    @property
    def isolation(self) -> dict[str, int]:
        """How many submissions ran behind which walls."""
        return dict(Counter(one.isolation for one in self.handed_in if one.isolation))


def report_of(
    course: Course,
    problem_set: ProblemSet,
    manual: ManualMarks | None = None,
    failures: Mapping[str, str] | None = None,
    only: Collection[str] | None = None,
) -> Report:
    """The report from the records of a course, its rows in the order of the set's parts; `manual` is what persons gave (what
    the journal holds when left out); `failures` says over whose work this program failed, and how (at the last grading when left
    out). With `only`, the report is on these students. Raises NotACourse."""
    parts = [(problem.code, part.id) for problem in problem_set.problems for part in problem.parts]
    places = {part: place for place, part in enumerate(parts)}
    everybody = students(course)
    roster = [student.id for student in everybody if only is None or student.id in only]
    deadlines = read_deadlines(course, problem_set)
    excused = [student for student in roster if deadlines.excused(student)]
    roster = [student for student in roster if student not in excused]
    by_student = read_marks(course, problem_set, roster, manual)
    records = list(by_student.values())
    rows = [row for record in records for row in record.rows]
    rows.sort(key=lambda row: places.get((row.problem, row.part), len(places)))
    shared = [each for each in read_shared(course, problem_set) if only is None or each.student in only]
    name, known = problem_set.name, set(roster)
    unusable = {
        student: why_unclear(name, names)
        for student, names in unclear(course, name).items()
        if student in known
    }
    marked = {each.handed_in.student for each in records if not each.trouble}
    failed = read_failures(course, name) if failures is None else failures
    for student, what in failed.items():
        if student in marked:  # of one answer, which waits for a person
            continue
        unusable[student] = f"corollary failed on this file, so mark it by hand ({visible(what)})"
    there, arrivals = submissions(course, name), read_arrivals(course, name)
    for each in arrivals:  # what was collected and could not be put where it is marked
        if each.outcome == UNUSABLE and each.student in known and each.student not in there:
            unusable[each.student] = visible(f"{each.file}: {each.why}")
    found = report(
        [_with_date(course, name, _with_guess(course, name, each.handed_in), deadlines) for each in records],
        rows,
        roster=roster,
        shared=shared,
        unusable=unusable,
        excused=excused,
        nobodys=[(visible(each.file), visible(each.why)) for each in without_owner(arrivals)],
        names={student.id: student.name for student in everybody},
    )
    return replace(
        found,
        rubric=rubric_counts(by_student),
        outside=tuple(each for each in read_outside(course, name).values() if each.student in known),
        requests=tuple(
            OpenRequest(student, part, visible(each.text), each.at)
            for (student, part), each in open_requests(course, name).items()
            if student in known
        ),
        stopped=stopped_rows(records, name),
    )


def _with_guess(course: Course, name: str, one: HandedIn) -> HandedIn:
    """What was noticed, with a guessed time."""
    guess = guessed_time(course, name, one.student)
    sentence = "" if guess is None else visible(why_guessed(name, one.student, guess))
    return msgspec.structs.replace(one, notes=(*one.notes, sentence)) if sentence else one


def _with_date(course: Course, name: str, one: HandedIn, deadlines: Deadlines) -> HandedIn:
    """What was noticed, with a date that counts because the sheet prints it, where that makes a difference."""
    given, own = deadlines.given(one.student), deadlines.of(one.student)
    when = handed_in(course, name, one.student)
    if given is None or own is None or own == given or when is None or when.timestamp() <= given.timestamp():
        return one
    sentence = f"handed in after {written(given)}, but the sheet prints {written(own)}, which counts"
    return msgspec.structs.replace(one, notes=(*one.notes, sentence))


def report(
    handed: Sequence[HandedIn],
    rows: Sequence[Row],
    *,
    roster: Iterable[str] = (),
    shared: Sequence[Shared] = (),
    unusable: Mapping[str, str] | None = None,
    excused: Sequence[str] = (),
    nobodys: Sequence[tuple[str, str]] = (),
    names: Mapping[str, str] | None = None,
) -> Report:
    """The report on rows as they are recorded; parts in the order of their first row. `roster` holds all students' ids."""
    by_part: dict[tuple[str, str], list[Row]] = {}
    met: dict[tuple[str, str, str, str], dict[str, None]] = {}
    for row in rows:
        by_part.setdefault((row.problem, row.part), []).append(row)
        if row.error:
            met.setdefault((row.verdict, row.error, row.problem, row.part), {})[row.student] = None
    found = [Met(*what, tuple(whose)) for what, whose in met.items()]
    came = {one.student for one in handed}
    rare = tuple(one for one in shared if one.chance < RARE)
    return Report(
        tuple(handed),
        tuple(rows),
        tuple(_tally(problem, part, its) for (problem, part), its in by_part.items()),
        tuple(sorted(found, key=lambda one: (-len(one.students), one.verdict, one.problem, one.part))),
        tuple(Waiting(row.student, row.problem, row.part, row.why, row.rubric) for row in rows if row.waits),
        tuple(student for student in roster if student not in came and student not in (unusable or {})),
        rare,
        tuple((unusable or {}).items()),
        tuple(excused),
        tuple(nobodys),
        len(shared) - len(rare),
        near_misses(rows),
        names=names or {},
    )


def is_unfinished(rows: Iterable[Row]) -> bool:
    """True for a part of which every answer still waits for a person, though blank ones are marked by themselves."""
    verdicts = {BY_HAND if row.by_hand else row.verdict for row in rows}
    return UNMARKED in verdicts and verdicts <= {UNMARKED, "unread"}


def _tally(problem: str, part: str, rows: Sequence[Row]) -> PartTally:
    """A part of which every answer still waits has no share."""
    counts = Counter(BY_HAND if row.by_hand else row.verdict for row in rows)
    marked = (
        [] if is_unfinished(rows) else [row for row in rows if row.verdict != UNMARKED and row.out_of > 0]
    )
    shares = [row.points / row.out_of for row in marked]
    return PartTally(
        problem, part, {word: counts[word] for word in (*WORDS, BY_HAND)}, fmean(shares) if shares else None
    )


def report_record(report: Report) -> dict[str, object]:
    """The report as plain data for one JSON document."""
    return {
        "handed_in": len(report.handed_in),
        "missing": list(report.missing),
        "excused": list(report.excused),
        "mean": report.mean,
        "median": report.median,
        "out_of": report.out_of,
        "late": report.late,
        "students": {one.student: msgspec.structs.asdict(one) for one in report.handed_in},
        "parts": [{**asdict(part), "counts": dict(part.counts)} for part in report.parts],
        "misconceptions": [{**asdict(met), "count": len(met.students)} for met in report.met],
        "waiting": [asdict(one) for one in report.waiting],
        "stopped": list(map(stopped_record, report.stopped)),
        "near_misses": list(map(near_misses_record, report.near_misses)),
        "rubric": [{**asdict(one), "count": len(one.students)} for one in report.rubric],
        "outside": [msgspec.to_builtins(one) for one in report.outside],
        "requests": [asdict(one) for one in report.requests],
        "unusable": [{"student": student, "why": why} for student, why in report.unusable],
        "nobodys": [{"file": file, "why": why} for file, why in report.nobodys],
        "failed": [{"student": one.student, "why": one.trouble} for one in report.failed],
        "noticed": [{"student": one.student, "notes": list(one.notes)} for one in report.noticed],
        "sharing": [msgspec.structs.asdict(one) for one in report.shared],
        "sharing_model": SHARING,
        "coincidences": report.coincidences,
        "isolation": report.isolation,
    }
