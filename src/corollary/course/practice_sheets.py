"""Practice sheets: exercises with fresh numbers that can show the misconceptions a student repeated or met last."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.grading.assign import NoVariant
from corollary.practice.practice import Practice, practice
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant
from corollary.records.assignments import read_numbers, sets_with_numbers
from corollary.records.files import Course
from corollary.records.misconception_history import ONCE, REPEATED, Followed
from corollary.records.misconception_names import Misconception, MisconceptionNames
from corollary.records.term import CourseTerm

MOST = 3  # exercises on a sheet
TURNS = 100  # numbers of an exercise to choose from
SITE_TURNS = 5  # as many as a practice site has of each, when nobody says otherwise

Values = Mapping[str, Fraction]


@dataclass(frozen=True, slots=True)
class PracticeExercise:
    """One exercise on a sheet. `sentence` is what the student read of the mistake, `met` where; `turn` is its number on the page to
    practise on, `variant` is the problem up to the part that can show the mistake."""

    misconception: Misconception
    sentence: str
    met: Mapping[str, tuple[str, ...]]
    variant: Variant
    turn: int


@dataclass(frozen=True, slots=True)
class CandidatePart:
    """A part of a problem that can show a misconception."""

    practice: Practice
    problem: Problem
    part: str


def misconceptions_to_practise(
    term: CourseTerm, followed: Sequence[Followed], names: MisconceptionNames
) -> dict[str, list[tuple[Followed, str]]]:
    """By student: repeated misconceptions, then those met in the last set that the student handed in, each with the sentence that
    the student read of it."""
    last = {
        line.student.id: next(
            (name for name in reversed(term.names) if line.student.id in term.marks[name]), ""
        )
        for line in term.students
    }
    found: dict[str, list[tuple[Followed, str]]] = {}
    for status in (REPEATED, ONCE):
        for each in followed:
            recent = status == REPEATED or last[each.student] in each.met
            if each.status == status and recent and not each.misconception.is_slip:
                found.setdefault(each.student, []).append((each, _sentence(term, each, names)))
    return found


def _sentence(term: CourseTerm, each: Followed, names: MisconceptionNames) -> str:
    for name in reversed(list(each.met)):
        for row in term.marks[name][each.student].rows:
            if row.error and names.named(row.problem, row.verdict, row.error) == each.misconception:
                return row.error
    return each.misconception.name


@dataclass(slots=True)
class PracticeMaker:
    """Chooses exercises. `open_codes` are problems that somebody still works on: nobody practises on these."""

    course: Course
    term: CourseTerm
    names: MisconceptionNames
    open_codes: Collection[str]
    _candidates: dict[Misconception, list[CandidatePart]] = field(
        default_factory=dict[Misconception, list[CandidatePart]]
    )
    _dealt: dict[tuple[str, str], list[Values]] = field(default_factory=dict[tuple[str, str], list[Values]])

    def __post_init__(self) -> None:
        banks: dict[str, Bank] = {}
        for each in self.term.sets:
            if each.bank is not None:
                banks.setdefault(str(each.bank.place), each.bank)
        for bank in banks.values():
            self._add(bank)
        for name in sets_with_numbers(self.course):
            record = read_numbers(self.course, name)
            for student, row in record.students.items() if record else ():
                for numbers in row.values():
                    code = record.edition(numbers).code_now if record else ""
                    self._dealt.setdefault((student, code), []).append(numbers.exact)

    def _add(self, bank: Bank) -> None:
        try:
            posed = practice(bank, left_out=frozenset(self.open_codes))
        except LookupError:  # nothing is left of this bank
            return
        for problem in posed.problems:
            self.names.add(bank, problem)
            if all(given.grid.count == 1 for given in problem.givens):
                continue  # there are no other numbers
            for part in problem.parts:
                for what in self.names.shows.get((problem.code, part.id), ()):
                    self._candidates.setdefault(what, []).append(CandidatePart(posed, problem, part.id))

    def sheet(self, student: str, wanted: Sequence[tuple[Followed, str]]) -> list[PracticeExercise]:
        """At most three exercises, each of another problem; none for a misconception that no problem at hand can show."""
        found: list[PracticeExercise] = []
        for each, sentence in wanted:
            on_sheet = {one.variant.problem.code for one in found}
            for candidate in self._ordered(student, each.misconception):
                if candidate.problem.code in on_sheet:
                    continue
                fresh = self._fresh(student, candidate)
                if fresh is not None:
                    found.append(PracticeExercise(each.misconception, sentence, each.met, *fresh))
                    break
            if len(found) == MOST:
                break
        return found

    def _ordered(self, student: str, what: Misconception) -> list[CandidatePart]:
        """Problems that the student never had first; among these another order for each student."""
        return sorted(
            self._candidates.get(what, ()),
            key=lambda each: (
                (student, each.problem.code) in self._dealt,
                _digest(student, each.problem.code, each.part),
            ),
        )

    def _fresh(self, student: str, candidate: CandidatePart) -> tuple[Variant, int] | None:
        """Numbers that the student does not have in any set; None where the problem has no answer for any of them."""
        had = self._dealt.get((student, candidate.problem.code), [])
        first = _digest(student, candidate.problem.code)
        turns = SITE_TURNS if self.term.rules.practice_site else TURNS
        for turn in ((first + step) % (turns - 1) + 1 for step in range(turns - 1)):
            try:
                variant = candidate.practice.pose(candidate.problem.code, turn).key.variant
            except (NotDerivable, NoVariant, Undefined, LookupError):
                return None
            if dict(variant.values) not in had:
                return _up_to(variant, candidate.part), turn
        return None


def _up_to(variant: Variant, part: str) -> Variant:
    """The problem without the parts behind the one that matters."""
    parts = variant.problem.parts
    at = next(place for place, each in enumerate(parts) if each.id == part)
    if at + 1 == len(parts):
        return variant
    return replace(variant, problem=replace(variant.problem, parts=parts[: at + 1], written=variant.problem))


def _digest(*words: str) -> int:
    return int.from_bytes(hashlib.sha256("/".join(words).encode()).digest()[:4])


def practice_sheets(
    maker: PracticeMaker, wanted: Mapping[str, Sequence[tuple[Followed, str]]]
) -> Iterator[tuple[str, list[PracticeExercise]]]:
    """A sheet for each student who has one, in the order of `wanted`."""
    for student, several in wanted.items():
        if exercises := maker.sheet(student, several):
            yield student, exercises
