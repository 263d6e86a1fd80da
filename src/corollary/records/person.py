"""Names by which the files of a course know one student: id, address, names, numbers of the LMS."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import PurePosixPath

from corollary.problem.roster import Student
from corollary.records.assignments import sets_with_numbers
from corollary.records.files import Course, UnknownStudent, find_student, students
from corollary.records.lms_names import Directory, lms_name
from corollary.records.submissions import numbers_of, read_arrivals

OWN_FOLDERS = ("release", "submitted", "autograded", "feedback")
SHORT = 3  # letters of an id that may be any word or number where it stands in a text
WORDS = re.compile(r"[\s_,;()+]+|(?<=\w)-(?=\w)")
BRACKETED = re.compile(r"\(([^()]+)\)")  # the id behind a name, as in given_out/Lund Ada (ada)
ADDRESS = re.compile(r"[^@\s]+@[^@\s]+\.\w+")
PACKED = re.compile(r"(\.(ipynb|txt|json|zip|html?|pdf|csv|md|eml|tar|gz|tgz|xz))+$", re.IGNORECASE)


@dataclass(frozen=True)
class Person:
    """One student, with the rest of the course that tells them from others. `numbers` are "moodle 17" and the like, each with its
    student; `strangers` are those of files that were taken from nobody."""

    student: Student
    roster: tuple[Student, ...]
    numbers: dict[str, str]
    sets: tuple[str, ...]
    everybody: frozenset[str]
    strangers: frozenset[str] = frozenset()

    @property
    def id(self) -> str:
        return self.student.id

    @cached_property
    def directory(self) -> Directory:
        roster = self.roster if self.student in self.roster else (*self.roster, self.student)
        return Directory(roster, self.numbers)

    @cached_property
    def namesakes(self) -> tuple[str, ...]:
        """The ids of others on the roster who have the same name."""
        name = self.student.name.casefold()
        return tuple(each.id for each in self.roster if each.id != self.id and each.name.casefold() == name)

    @cached_property
    def full_names(self) -> tuple[str, ...]:
        """Each way in which first and last name are written together; none where one of them is missing, or where a namesake is on
        the roster: by the name alone nothing is this student's."""
        first, last = self.student.first_name, self.student.last_name
        if self.namesakes:
            return ()
        return (f"{first} {last}", f"{last} {first}", f"{last}, {first}") if first and last else ()

    @cached_property
    def other_ids(self) -> frozenset[str]:
        """The ids of an LMS and the address, which are nobody else's."""
        return frozenset({self.student.email, *(value for _, value in self.student.ids)} - {"", self.id})

    @cached_property
    def own_number(self) -> frozenset[str]:
        """The numbers of the LMS, as "moodle 17"."""
        return frozenset(number for number, student in self.numbers.items() if student == self.id)

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """A mention in a text: id, address, an id of an LMS, or the whole name; numbers and ids of two letters are none."""
        ids = _any_of({self.id, *self.other_ids})
        names = _any_of(self.full_names)  # an LMS puts a _ behind them, and v_max is no student
        return re.compile(
            rf"(?<![\w@.-])(?:{ids})(?![\w@]|[.-]\w)|(?<![^\W_]|[@.-])(?:{names})(?![^\W_]|@|[.-]\w)"
        )

    def is_named_by(self, value: object) -> bool:
        """True if a field of a record holds nothing but a name of this student."""
        return self.is_identified_by(value) or value in self.full_names

    def is_identified_by(self, value: object) -> bool:
        """True if a field holds what nobody else has: the id, the address, an id or number of the LMS."""
        return isinstance(value, str) and value in {self.id, *self.other_ids, *self.own_number}

    def is_another(self, value: str) -> bool:
        """True if a field of an id or an address holds somebody else's."""
        return self.is_of_another(value) or (
            value not in self.other_ids and ADDRESS.fullmatch(value) is not None
        )

    def is_of_another(self, value: str) -> bool:
        """True for the id or address of somebody else whom the course knows."""
        return (value in self.everybody and value != self.id) or (
            value in self._others and value not in self.other_ids
        )

    @cached_property
    def _others(self) -> frozenset[str]:
        theirs = (each for each in self.roster if each.id != self.id)
        return frozenset(
            value for each in theirs for value in (each.email, *(value for _, value in each.ids)) if value
        )

    @cached_property
    def others_names(self) -> frozenset[str]:
        """The names, as the roster writes them, of those who have another name."""
        name = self.student.name.casefold()
        return frozenset(
            each.name for each in self.roster if each.name.casefold() != name and " " in each.name
        )

    def owns_path(self, parts: Sequence[str]) -> bool | None:
        """True if the first name in a path that is a student's is this one's, False if another's, None if there is none."""
        for part in parts:
            if (found := lms_name([part])) is not None:
                if found.key in self.strangers:
                    return False
                whose = self.directory.of_lms(found)
                if whose is not None or found.name:
                    return whose == self.id or (whose is None and found.name in self.full_names)
            if (whose := self._whose(part)) is not None:
                return whose == self.id
        return None

    def _whose(self, part: str) -> str | None:
        if part in self.everybody:
            return part
        stem = PACKED.sub("", part)
        first = stem.partition("+")[0].partition(".")[0]
        for whole in (stem, first):
            if whole in self.everybody:
                return whole
        for name in self.sets:
            stem = stem.replace(name, " ")
        if (bracketed := BRACKETED.search(stem)) and bracketed[1] in self.everybody:
            return bracketed[1]
        met = {word for word in WORDS.split(stem) if len(word) >= SHORT and word in self.everybody}
        if len(met) == 1:
            return met.pop()
        return self.directory.by_name(stem.strip(" _-")) or self.directory.of_parts([stem], "")


def find_person(course: Course, name: str) -> Person:
    """Whoever the roster or, after they left it, a record of the course knows by this name. Raises UnknownStudent, NotACourse."""
    try:
        return person_of(course, find_student(course, name))
    except UnknownStudent:
        if name not in set(_in_records(course)):
            raise
        return person_of(course, Student(name))


def person_of(course: Course, student: Student) -> Person:
    """The same of a student who is known. Raises UnknownStudent for an id that a folder of the course has, too."""
    roster, sets = students(course), _sets(course)
    if student.id in {*sets, *OWN_FOLDERS, "source"}:
        raise UnknownStudent(
            f"{student.id} is the name of a set or of a folder of the course, too: its files cannot be told apart from the student's; "
            "rename the set, then run this again"
        )
    numbers, refused = dict[str, str](), set[str]()
    for each in sets:
        arrivals = read_arrivals(course, each)
        numbers |= numbers_of(arrivals)
        refused |= {one.number for one in arrivals if one.number and not one.student}
    everybody = frozenset(_in_records(course)) | {each.id for each in (*roster, student)}
    return Person(student, roster, numbers, tuple(sets), everybody, frozenset(refused - numbers.keys()))


def _any_of(words: Iterable[str]) -> str:
    """A pattern of the words that are long enough to mean somebody."""
    several = sorted((word for word in words if len(word) >= SHORT), key=len, reverse=True)
    return "|".join(map(re.escape, several)) or r"(?!)"


def _sets(course: Course) -> list[str]:
    found = {*sets_with_numbers(course)}
    for kind in ("collected", "graded", "origin", "history", "sharing"):
        found |= {PurePosixPath(path.name).stem for path in course.record(kind, "any").parent.glob("*")}
    return sorted(found, key=len, reverse=True)


def _in_records(course: Course) -> Iterable[str]:
    """The ids that a folder or a record has, also of those who have left the roster."""
    sets = set(_sets(course))
    for step in OWN_FOLDERS:
        for place in (course.folder / step).glob("*/"):
            if place.name not in sets:
                yield place.name
    for place in course.record("graded", "any").parent.glob("*/*.json"):
        yield place.stem
