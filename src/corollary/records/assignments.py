"""Assignments: whose sheet has which numbers, the editions of problems they were made from, and the deadline each sheet prints."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import msgspec
from msgspec import to_builtins

from corollary.atomic import write_whole
from corollary.problem.dates import written, zone_named
from corollary.problem.diagnostic import Malformed
from corollary.problem.given import decimal_places
from corollary.problem.packed_pictures import packed_file
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.reader import read_problem
from corollary.problem.variant import Variant
from corollary.records.editions import (
    Edition,
    NotSettled,
    Rename,
    Renamed,
    as_handed_out,
    edition_of,
    fingerprint,
    parts_gone,
    proposed,
    settled,
    values_now,
)
from corollary.records.files import Course, NotACourse

FORMAT = 1


class StudentNumbers(msgspec.Struct, frozen=True):
    """One student's numbers in one problem, in the units of its edition (named by its place in the list): exact, as text.

    `index` is the place in the grid that they were drawn from."""

    edition: int
    values: dict[str, str]
    index: int | None = None

    @property
    def exact(self) -> dict[str, Fraction]:
        return {symbol: Fraction(text) for symbol, text in self.values.items()}


Row = dict[str, StudentNumbers]  # by the code that the problem had when it was handed out


class PrintedDate(msgspec.Struct, frozen=True):
    """The deadline as a sheet prints it, in the zone of this name (empty: one that has none)."""

    moment: datetime
    zone: str = ""

    @property
    def when(self) -> datetime:
        moment = self.moment if self.moment.tzinfo is not None else self.moment.replace(tzinfo=UTC)
        zone = zone_named(self.zone) if self.zone else None
        return moment if zone is None else moment.astimezone(zone)


class Assigned(msgspec.Struct):
    """The whole file. `dates` has what each sheet prints: None where it prints no date, nothing where that is not known."""

    editions: list[Edition]
    students: dict[str, Row]
    dates: dict[str, PrintedDate | None] = {}
    format: int = FORMAT

    def edition(self, numbers: StudentNumbers) -> Edition:
        return self.editions[numbers.edition]

    @property
    def in_use(self) -> list[Edition]:
        """The editions that somebody has."""
        places = {numbers.edition for row in self.students.values() for numbers in row.values()}
        return [self.editions[place] for place in sorted(places)]

    def place(self, problem: Problem, weight: float) -> int:
        """The place of today's edition of a problem in the list, where it is put if need be."""
        edition = edition_of(problem, weight)
        if edition not in self.editions:
            self.editions.append(edition)
        return self.editions.index(edition)


def numbers_of(variant: Variant, edition: int) -> StudentNumbers:
    """What is recorded of a variant."""
    return StudentNumbers(
        edition, {symbol: _text(value) for symbol, value in variant.values.items()}, variant.index
    )


def read_numbers(course: Course, set_name: str) -> Assigned | None:
    """The record; None when there is none. Raises NotACourse when it is damaged, or of a newer version."""
    path = _file(course, set_name)
    try:
        found = msgspec.json.decode(path.read_bytes(), type=Assigned)
        for numbers in (numbers for row in found.students.values() for numbers in row.values()):
            if numbers.exact.keys() != found.edition(numbers).units.keys():
                raise ValueError("numbers that do not fit their edition")
    except FileNotFoundError:
        return None
    except (OSError, ValueError, ZeroDivisionError, IndexError) as error:
        raise NotACourse(f"{path} is damaged ({error}); restore it from a backup") from None
    if found.format > FORMAT:
        raise NotACourse(f"{path} was written by a newer version of corollary; install that")
    return found


def write_numbers(course: Course, set_name: str, record: Assigned, problems: Mapping[str, Problem]) -> None:
    """First the files of the problems as they are handed out, by their fingerprints, then the record.

    `problems` are those of today's editions, by fingerprint.
    """
    for statement, problem in problems.items():
        place = _words(course, statement)
        if not place.exists():
            write_whole(place, packed_file(problem.path))
    students = {student: record.students[student] for student in sorted(record.students)}
    dates = {student: record.dates[student] for student in sorted(record.dates)}
    record = msgspec.structs.replace(record, students=students, dates=dates)
    write_whole(_file(course, set_name), msgspec.json.format(msgspec.json.encode(record), indent=1) + b"\n")


def sets_with_numbers(course: Course) -> list[str]:
    """The names of the sets that have a record."""
    return sorted(path.stem for path in _file(course, "any").parent.glob("*.json"))


def words_of(course: Course, edition: Edition) -> Problem | None:
    """The problem as its file was when the edition was handed out; None when that cannot be read any more."""
    try:
        return read_problem(_words(course, edition.statement))
    except (Malformed, OSError):
        return None


def _text(value: Fraction) -> str:
    """0.43, or 1/3 where no decimals will do."""
    places = decimal_places(value)
    return (
        f"{round(value * 10**places) / 10**places:.{places}f}"
        if (value * 10**places).denominator == 1 and places < 12 and abs(value) < 10**6
        else str(value)
    )


def _file(course: Course, set_name: str) -> Path:
    return course.record("assigned", f"{set_name}.json")


def _words(course: Course, statement: str) -> Path:
    return course.record("assigned", f"problems/{statement}.md")


@dataclass(frozen=True, slots=True)
class AssignedSheet:
    """What one student was given, as far as the set still has it: a variant of each problem, in the order of the set, or in
    that in which they were dealt where the set is shuffled.

    `removed` are the problems of which something is gone, with the parts that are. `identity` is a text that is another one
    when the numbers are, or what was asked, or what it is called; `numbers` and `names` tell the last from the others.
    """

    variants: tuple[Variant, ...]
    identity: str
    removed: tuple[Variant, ...] = ()
    numbers: str = ""
    names: str = ""

    def variant(self, problem: Problem) -> Variant | None:
        """Of a problem as the set has it today; None when it was never asked."""
        code = problem.as_written.code
        return next((each for each in self.variants if each.problem.as_written.code == code), None)


def is_assigned(course: Course, set_name: str) -> bool:
    """Whether the set was ever generated for this course."""
    return course.record("assigned", f"{set_name}.json").exists()


def read_assigned(course: Course, problem_set: ProblemSet) -> dict[str, AssignedSheet]:
    """Everybody's sheet; empty when the set was never generated. Raises NotACourse when the record is damaged, and NotSettled
    when a name may have changed since."""
    return sheets(course, problem_set, open_record(course, problem_set))


def open_record(course: Course, problem_set: ProblemSet) -> Assigned:
    """The record; an empty one where there is none. Raises NotACourse."""
    return read_numbers(course, problem_set.name) or Assigned([], {})


def save_record(course: Course, problem_set: ProblemSet, record: Assigned) -> None:
    """Writes it, with the words of the problems as they are today. Raises OSError."""
    todays = {edition_of(each, problem_set.weight(each)).statement: each for each in problem_set.problems}
    write_numbers(course, problem_set.name, record, todays)


def pending(course: Course, problem_set: ProblemSet, record: Assigned) -> list[list[Rename]]:
    """The names that look changed and that nobody has been asked about, together those of one edition."""
    known = {edition.code_now for edition in record.editions}
    todays = {each.code: fingerprint(each) for each in problem_set.problems}
    found = [
        proposed(edition, problem_set.problems, known, words_of(course, edition))
        for edition in record.in_use
        if todays.get(edition.code_now) != edition.statement
    ]
    return [renames for renames in found if renames]


def settle(record: Assigned, renames: Sequence[Rename], *, agreed: bool) -> None:
    """Takes the names of today for those of an edition, or records that they are others."""
    edition = renames[0].edition
    record.editions[record.editions.index(edition)] = settled(edition, renames, agreed=agreed)


def sheets(course: Course, problem_set: ProblemSet, record: Assigned) -> dict[str, AssignedSheet]:
    """Everybody's sheet, from the record. Raises NotSettled."""
    for renames in pending(course, problem_set, record):
        raise NotSettled(
            f"{renames[0].sentence}; run corollary generate {problem_set.name} and answer its question before grading"
        )
    problems = [_problem(course, problem_set, edition) for edition in record.editions]
    removed = [
        _removed(course, edition, problem) for edition, problem in zip(record.editions, problems, strict=True)
    ]
    order = {problem.code: place for place, problem in enumerate(problem_set.problems)}
    found: dict[str, AssignedSheet] = {}
    for student, row in record.students.items():
        variants = [
            _variant(problem, record.edition(numbers), numbers)
            for numbers in row.values()
            if (problem := problems[numbers.edition]) is not None
        ]
        if not problem_set.shuffled:
            variants.sort(key=lambda variant: order[variant.problem.as_written.code])
        gone = tuple(
            Variant(
                problem,
                {given.symbol: numbers.exact[given.symbol] for given in problem.givens},
                numbers.index,
            )
            for numbers in row.values()
            if (problem := removed[numbers.edition]) is not None
        )
        found[student] = AssignedSheet(
            tuple(variants),
            _identity(record, student),
            gone,
            _identity(record, student, renamed=False),
            _names(record, student),
        )
    return found


def variant_anywhere(course: Course, problem: Problem, student: str) -> Variant | None:
    """A student's numbers in a problem, whatever set they came in; None when they have none. Raises NotACourse and NotSettled."""
    found: Variant | None = None
    for name in sets_with_numbers(course):
        record = read_numbers(course, name) or Assigned([], {})
        for numbers in record.students.get(student, {}).values():
            edition = record.edition(numbers)
            if edition.code_now == problem.code:
                for rename in proposed(edition, [problem], (), words_of(course, edition)):
                    raise NotSettled(
                        f"{rename.sentence}; run corollary generate {name} and answer its question"
                    )
                found = _variant(as_handed_out(problem, edition, words_of(course, edition)), edition, numbers)
    return found


def _problem(course: Course, problem_set: ProblemSet, edition: Edition) -> Problem | None:
    """The problem as it was handed out; None when the set no longer has it."""
    today = next((each for each in problem_set.problems if each.code == edition.code_now), None)
    if today is None:
        return None
    same = as_handed_out(today, edition, None)
    return same if same is today else as_handed_out(today, edition, words_of(course, edition))


def _removed(course: Course, edition: Edition, problem: Problem | None) -> Problem | None:
    """The problem with those parts that it was handed out with and has no longer; None when it has them all."""
    have = {part.label for part in problem.parts} if problem is not None else set[str]()
    if all(part.id in have for part in edition.parts):
        return None
    return parts_gone(edition, have, words_of(course, edition))


def _variant(problem: Problem, edition: Edition, numbers: StudentNumbers) -> Variant:
    return Variant(problem, values_now(problem, edition, numbers.exact), numbers.index)


def _identity(record: Assigned, student: str, *, renamed: bool = True) -> str:
    """The numbers, parts and units of a sheet as text; names changed since only when `renamed`."""
    row = record.students[student]
    editions = [record.edition(numbers) for numbers in row.values()]
    return json.dumps(
        [
            [
                edition.code,
                numbers.values,
                edition.units,
                [part.id for part in edition.parts],
                to_builtins(edition.renamed if renamed else Renamed()),
            ]
            for edition, numbers in zip(editions, row.values(), strict=True)
        ],
        sort_keys=True,
    )


def _names(record: Assigned, student: str) -> str:
    """What is called otherwise than on the student's sheet; empty when nothing is."""
    editions = [record.edition(numbers) for numbers in record.students[student].values()]
    found = {
        edition.code: to_builtins(edition.renamed) for edition in editions if edition.renamed != Renamed()
    }
    return json.dumps(found, sort_keys=True) if found else ""


def printed_date(due: datetime | None) -> PrintedDate | None:
    """What is recorded of a sheet made today."""
    return None if due is None else PrintedDate(due, getattr(due.tzinfo, "key", None) or "")


def printed_dates(course: Course, problem_set: ProblemSet) -> dict[str, datetime]:
    """What the sheets print, by student; nobody whose sheet prints none, or of whom it is not known. Raises NotACourse."""
    record = read_numbers(course, problem_set.name) or Assigned([], {})
    return {student: date.when for student, date in record.dates.items() if date is not None}


def as_printed(problem_set: ProblemSet, record: Assigned, student: str) -> ProblemSet:
    """The set with the date that a student's sheet prints; with that of today where it is not known."""
    if student not in record.dates:
        return problem_set
    date = record.dates[student]
    return replace(problem_set, due=None if date is None else date.when)


def otherwise_dated(problem_set: ProblemSet, record: Assigned) -> set[str]:
    """Whose sheet prints another moment than that of today, or none."""
    return {student for student in record.students if _is_other(problem_set.due, record, student)}


def date_corrections(problem_set: ProblemSet, record: Assigned) -> Iterator[tuple[str, tuple[str, ...]]]:
    """A sentence on every date that sheets print and the set no longer has, with whose sheets these are."""
    due, whose = problem_set.due, dict[str, list[str]]()
    today = "has no date now" if due is None else f"is due {written(due)} now"
    for student in sorted(otherwise_dated(problem_set, record)):
        date = record.dates[student]
        if date is None:
            sentence = f"{today}, and these sheets print no date: the new date counts"
        elif due is None:
            sentence = f"{today}, and these sheets print {written(date.when)}: nobody is late any more"
        elif due.timestamp() < date.when.timestamp():
            sentence = (
                f"{today}, and these sheets print {written(date.when)}, which counts "
                "until they are replaced (--renew)"
            )
        else:
            sentence = f"{today}, and these sheets print {written(date.when)}: the later date counts"
        whose.setdefault(sentence, []).append(student)
    for sentence, students in whose.items():
        yield sentence, tuple(students)


def held_codes(record: Assigned, but: Collection[str] = ()) -> list[list[str]]:
    """The codes of the problems that each student has, as they are called now; of all `but` some."""
    return [
        [record.edition(numbers).code_now for numbers in row.values()]
        for student, row in record.students.items()
        if student not in but
    ]


def _is_other(due: datetime | None, record: Assigned, student: str) -> bool:
    if student not in record.dates:
        return False
    date = record.dates[student]
    if due is None or date is None:
        return (due is None) != (date is None)
    return date.when.timestamp() != due.timestamp()
