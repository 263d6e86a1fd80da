"""Answers that are wrong for one's own numbers and right for somebody else's: listed for the instructor, never punished."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from corollary.answers.answer import Numbers
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.formula.ball import Undefined
from corollary.formula.value import Text
from corollary.grading.closeness import within
from corollary.grading.replay import replay
from corollary.grading.solutions import Solutions
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import at, chapter
from corollary.records.report_model import WITHIN, Shared

LEAST_SPAN = math.log(2)

Truths = Mapping[str, tuple[float, ...]]  # student -> right answer of one part, in SI


def sharing(
    problem_set: ProblemSet,
    solutions: Solutions,
    dealt: Mapping[str, Mapping[str, int]],
    records: Mapping[str, Mapping[str, Any]],
) -> tuple[Shared, ...]:
    """Every pair of students of whom one's wrong answers fit the other's numbers, the least likely by chance first.

    `dealt` says who got which variants; `records` are the marks as kept.
    """
    met: dict[tuple[str, str], dict[str, list[tuple[str, float]]]] = {}
    for problem in problem_set.problems:
        wrong = list(_wrong(problem, records))
        if not wrong:
            continue
        truths = _truths(problem, solutions, dealt, {part.id for _, part, _ in wrong})
        for student, part, values in wrong:
            others = {other: value for other, value in truths.get(part.id, {}).items() if other != student}
            width = _width(truths.get(part.id, {}))
            for other, truth in others.items():
                length = math.hypot(*truth)
                if length > 0 and within(values, truth, WITHIN, length):
                    met.setdefault((student, other), {}).setdefault(problem.code, []).append(
                        (problem.answer_name(part), width)
                    )
    shared = []
    for (student, other), problems in met.items():
        one = math.prod(max(width for _, width in parts) for parts in problems.values())
        chance = -math.expm1((len(dealt) - 1) * math.log1p(-min(one, 1 - 1e-12)))
        shared.append(
            Shared(student, other, tuple(name for parts in problems.values() for name, _ in parts), chance)
        )
    return tuple(sorted(shared, key=lambda one: (one.chance, one.student, one.other)))


def _wrong(
    problem: Problem, records: Mapping[str, Mapping[str, Any]]
) -> Iterator[tuple[str, Part, tuple[float, ...]]]:
    """Every answer in numbers that was marked wrong."""
    for student, record in records.items():
        for part in problem.parts:
            kept = record["parts"].get(problem.answer_name(part))
            if kept is None or kept["verdict"] != "wrong":
                continue
            answer = answer_type(part.kind).read(Text(kept["answer"]), question_of(problem, part))
            if isinstance(answer, Numbers) and not answer.misfit and any(answer.values):
                yield student, part, answer.values


def _truths(
    problem: Problem, solutions: Solutions, dealt: Mapping[str, Mapping[str, int]], parts: set[str]
) -> dict[str, dict[str, tuple[float, ...]]]:
    """The right answers of everybody, by part and student."""
    solution = solutions.of(problem)
    places = {find.part: place for place, find in enumerate(solution.finds) if find.part in parts}
    truths: dict[str, dict[str, tuple[float, ...]]] = {part: {} for part in places}
    for student, row in dealt.items():
        variant = at(problem, row[problem.code]) if problem.code in row else chapter(problem)
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
