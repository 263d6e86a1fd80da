"""The file of what was assigned in a set: every student's numbers, and the editions of the problems they belong to."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import msgspec

from corollary.atomic import write_whole
from corollary.problem.dates import zone_named
from corollary.problem.diagnostic import Malformed
from corollary.problem.given import decimal_places
from corollary.problem.pictures import packed_file
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem
from corollary.problem.variant import Variant
from corollary.records.edition import Edition, edition_of
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
