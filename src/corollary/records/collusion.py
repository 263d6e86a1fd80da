"""Answers that are wrong for one's own numbers and right for somebody else's: listed for the instructor, never punished."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import msgspec

from corollary.answers.answer import Answer, Entries, Numbers
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.answers.tolerance import within
from corollary.atomic import write_whole
from corollary.formula.ball import Undefined
from corollary.formula.value import Text
from corollary.grading.replay import replay
from corollary.grading.solutions import Solutions
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import AssignedSheet
from corollary.records.files import Course
from corollary.records.marks import Record

WITHIN = (
    0.005  # narrower than any part's tolerance: copied digits agree much better, and chance hits are rarer
)
RARE = 0.05  # what is likelier than this is no news in a class
SHARING = (
    "A wrong answer is taken to fall anywhere, on a logarithmic scale, in the span of the class's right answers to that part; "
    f"it fits another student's when it lies within {100 * WITHIN:.1f} % of it. The chance is that of meeting at least one of the "
    "other students so, in one part of each exercise listed (parts of one exercise follow from one another and count once). "
    "Of a table or a list any entry may fit, each of its own size: so many chances are added up. "
    f"What chance makes as likely as {100 * RARE:.0f} % is only counted."
)
# A class whose right answers hardly differ would make every hit look certain; they are taken to span a factor of two.
WHOLE = (
    "value",
    "integer",
    "vector",
)  # answer types that are one thing: a vector is as near as its length says
LEAST_SPAN = math.log(2)


class Shared(msgspec.Struct, frozen=True):
    """Wrong answers of a student that are right for the numbers of `other`, by part, and how likely that is by chance."""

    student: str
    other: str
    parts: tuple[str, ...]
    chance: float


Truths = Mapping[str, tuple[float, ...]]  # student -> right answer of one part, in SI


@dataclass(frozen=True, slots=True)
class Compared:
    """What of a wrong answer is compared as one: a number or a vector whole (`places` is empty), or one entry of a table or a
    list, with those of the right entries that it may be meant for."""

    values: tuple[float, ...]
    places: tuple[int, ...] = ()

    def fits(self, truth: Sequence[float]) -> bool:
        """Whether it is right for somebody with these right answers."""
        meant = [(truth[place],) for place in self.places if place < len(truth)] if self.places else [truth]
        return any(any(each) and within(self.values, each, WITHIN, math.hypot(*each)) for each in meant)

    def truths(self, theirs: Truths) -> list[float]:
        """How large everybody's right answers are that it is compared with."""
        if not self.places:
            return [math.hypot(*each) for each in theirs.values()]
        return [abs(each[place]) for each in theirs.values() for place in self.places if place < len(each)]


def _compared(part: Part, values: tuple[float, ...], own: Sequence[float]) -> Iterator[Compared]:
    """The pieces of a wrong answer that are not right by themselves, and not nothing."""
    if part.answer_type in WHOLE:
        yield Compared(values)
        return
    for place, value in enumerate(values):
        # The order of a list says nothing; an entry of a table stands where it belongs.
        piece = Compared((value,), (place,) if part.rows else tuple(range(len(part.components) or len(own))))
        if value and not piece.fits(own):
            yield piece


def find_shared(
    problem_set: ProblemSet,
    solutions: Solutions,
    assigned: Mapping[str, AssignedSheet],
    records: Mapping[str, Record],
) -> tuple[Shared, ...]:
    """Every pair of students of whom one's wrong answers fit the other's numbers, the least likely by chance first.

    `assigned` are everybody's sheets; `records` are everybody's marks.
    """
    met: dict[tuple[str, str], dict[str, list[tuple[str, float]]]] = {}
    for problem in problem_set.problems:
        wrong = list(_wrong(problem, assigned, records))
        if not wrong:
            continue
        truths = _truths(problem, solutions, assigned, {part.id for _, part, _ in wrong})
        for student, part, values in wrong:
            theirs = truths.get(part.id, {})
            pieces = list(_compared(part, values, theirs.get(student, ())))
            width = min(1.0, sum(_width(each.truths(theirs)) for each in pieces))
            for other, truth in theirs.items():
                if other != student and any(each.fits(truth) for each in pieces):
                    met.setdefault((student, other), {}).setdefault(problem.code, []).append(
                        (problem.answer_name(part), width)
                    )
    shared: list[Shared] = []
    for (student, other), problems in met.items():
        one = math.prod(max(width for _, width in parts) for parts in problems.values())
        chance = -math.expm1((len(assigned) - 1) * math.log1p(-min(one, 1 - 1e-12)))
        shared.append(
            Shared(student, other, tuple(name for parts in problems.values() for name, _ in parts), chance)
        )
    return tuple(sorted(shared, key=lambda one: (one.chance, one.student, one.other)))


def write_shared(course: Course, problem_set: ProblemSet, shared: Iterable[Shared]) -> None:
    """Records what was found at the last grading."""
    write_whole(course.record("sharing", f"{problem_set.name}.json"), msgspec.json.encode(list(shared)))


def read_shared(course: Course, problem_set: ProblemSet) -> tuple[Shared, ...]:
    """Empty when nothing was found, or nothing graded yet."""
    try:
        found = course.record("sharing", f"{problem_set.name}.json").read_bytes()
        return msgspec.json.decode(found, type=tuple[Shared, ...])
    except (OSError, msgspec.DecodeError):  # none, or damaged: found again at the next grading
        return ()


def _wrong(
    problem: Problem, assigned: Mapping[str, AssignedSheet], records: Mapping[str, Record]
) -> Iterator[tuple[str, Part, tuple[float, ...]]]:
    """Every answer in numbers that was marked wrong, read as it was asked."""
    for student, record in records.items():
        variant = assigned[student].variant(problem) if student in assigned else None
        if variant is None:
            continue
        for part in variant.problem.parts:
            marked = record.parts.get(variant.problem.answer_name(part))
            if marked is None or marked.verdict != "wrong":
                continue
            answer = answer_type(part.answer_type).read(
                Text(marked.answer), question_of(variant.problem, part)
            )
            if any(values := _values(answer)):
                yield student, part, values


def _values(answer: Answer) -> tuple[float, ...]:
    """Its numbers in SI; of a table one for each entry, 0 for what is none or in a unit of something else. Else nothing."""
    match answer:
        case Numbers(values=values, misfit=""):
            return values
        case Entries(entries):
            return tuple(sum(_values(each)) for each in entries)
        case _:
            return ()


def _truths(
    problem: Problem, solutions: Solutions, assigned: Mapping[str, AssignedSheet], parts: set[str]
) -> dict[str, dict[str, tuple[float, ...]]]:
    """The right answers of everybody, by part and student."""
    whole = solutions.of(problem)
    truths = {find.part: dict[str, tuple[float, ...]]() for find in whole.unknowns if find.part in parts}
    for student, sheet in assigned.items():
        variant = sheet.variant(problem)
        if variant is None:
            continue
        try:
            solution = whole.at(variant.exact)
            places = {find.part: place for place, find in enumerate(solution.unknowns) if find.part in truths}
            values = replay(solution, variant.exact, until=max(places.values(), default=-1))
        except Undefined:
            continue
        for part, place in places.items():
            truths[part][student] = values[place]
    return truths


def _width(sizes: Iterable[float]) -> float:
    """The share of the span of the class's right answers that lies within the tolerance of one of them."""
    sizes = [size for size in sizes if size > 0]
    span = max(math.log(max(sizes) / min(sizes)) if sizes else 0.0, LEAST_SPAN)
    return min(1.0, 2 * WITHIN / span)
