"""Answers that are wrong for one's own numbers and right for somebody else's: listed for the instructor, never punished."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

import msgspec

from corollary.answers.answer import Numbers
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
from corollary.records.assigned import AssignedSheet
from corollary.records.files import Course
from corollary.records.record import Record

WITHIN = (
    0.005  # narrower than any part's tolerance: copied digits agree much better, and chance hits are rarer
)
SHARING = (
    "A wrong answer is taken to fall anywhere, on a logarithmic scale, in the span of the class's right answers to that part; "
    f"it fits another student's when it lies within {WITHIN:.1%} of it. The chance is that of meeting at least one of the "
    "other students so, in one part of each exercise listed (parts of one exercise follow from one another and count once)."
)
# A class whose right answers hardly differ would make every hit look certain; they are taken to span a factor of two.
LEAST_SPAN = math.log(2)


class Shared(msgspec.Struct, frozen=True):
    """Wrong answers of a student that are right for the numbers of `other`, by part, and how likely that is by chance."""

    student: str
    other: str
    parts: tuple[str, ...]
    chance: float


Truths = Mapping[str, tuple[float, ...]]  # student -> right answer of one part, in SI


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
            others = {other: value for other, value in truths.get(part.id, {}).items() if other != student}
            width = _width(truths.get(part.id, {}))
            for other, truth in others.items():
                length = math.hypot(*truth)
                if length > 0 and within(values, truth, WITHIN, length):
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
            if isinstance(answer, Numbers) and not answer.misfit and any(answer.values):
                yield student, part, answer.values


def _truths(
    problem: Problem, solutions: Solutions, assigned: Mapping[str, AssignedSheet], parts: set[str]
) -> dict[str, dict[str, tuple[float, ...]]]:
    """The right answers of everybody, by part and student."""
    solution = solutions.of(problem)
    places = {find.part: place for place, find in enumerate(solution.unknowns) if find.part in parts}
    truths: dict[str, dict[str, tuple[float, ...]]] = {part: {} for part in places}
    for student, sheet in assigned.items():
        variant = sheet.variant(problem)
        if variant is None:
            continue
        try:
            values = replay(solution, variant.exact, until=max(places.values(), default=-1))
        except Undefined:
            continue
        for part, place in places.items():
            truths[part][student] = values[place]
    return truths


def _width(truths: Truths) -> float:
    """The share of the span of the class's right answers that lies within the tolerance of one of them."""
    sizes = [math.hypot(*each) for each in truths.values()]
    sizes = [size for size in sizes if size > 0]
    span = max(math.log(max(sizes) / min(sizes)) if sizes else 0.0, LEAST_SPAN)
    return min(1.0, 2 * WITHIN / span)
