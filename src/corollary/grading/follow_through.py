"""What follows from a student's own earlier answers: a part's value along every way that the laws allow."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

from corollary.answers.evaluation import BITS, as_exact, balls, numbers
from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Rule, Solution
from corollary.formula.ast import Name
from corollary.formula.ball import Undefined, precision_of
from corollary.grading.key import Key, Truth
from corollary.grading.replay import WhatIf, ancestors, replay

MOST = 6  # wrong earlier answers combined: 64 choices of them, each by every route
ABSURD = 1050.0  # times too large or too small: a power of ten is still followed, beyond it there is no physics left to follow
COPIED = 1e-9


@dataclass(frozen=True, slots=True)
class Consequence:
    """A value of a part, and which wrong earlier answers it follows from.

    `what_if` is the replay that gave it, for mistakes to be made in it; None where it was found along a way of its own.
    """

    values: Values
    earlier: tuple[str, ...]
    what_if: WhatIf | None


@dataclass(frozen=True, slots=True)
class FromStudent:
    """The student's answers to other parts, of which later ones may be made: right ones, and wrong ones of some use."""

    right: dict[str, Values]
    wrong: dict[str, Values]


def from_student(key: Key, answers: Mapping[str, Values]) -> FromStudent:
    """What may be followed. A degenerate answer is not, for everything would follow from it."""
    right: dict[str, Values] = {}
    wrong: dict[str, Values] = {}
    for part, values in answers.items():
        truth = key.truths.get(part)
        if truth is None or len(values) != len(truth.values):
            continue
        if truth.is_met_by(values):
            right[part] = values
        elif not degenerate(values, truth):
            wrong[part] = values
    return FromStudent(right, wrong)


def consequences(key: Key, truth: Truth, answers: Mapping[str, Values]) -> Iterator[Consequence]:
    """The part's value for the student's own earlier answers: first for none of them, then for every combination.

    First along the author's order, then along the other ways of the derivation. Left out is what makes the part nothing.
    """
    given = from_student(key, answers)
    for each in (*_in_order(key, truth, given), *_by_paths(key, truth, given)):
        if any(each.values) or not any(truth.values):
            yield each


def same_as(solution: Solution, place: int) -> str:
    """The earlier part of which an unknown is the very same by another name; "" where it takes more."""
    owner = {find.names: find for find in solution.unknowns}
    find = solution.unknowns[place]
    while isinstance(find.local, ClosedForms):
        letters = tuple(tree.name for tree in find.local.trees if isinstance(tree, Name))
        if letters not in owner:
            return ""
        find = owner[letters]
        if find.part:
            return find.part
    return ""


def _in_order(key: Key, truth: Truth, given: FromStudent) -> Iterator[Consequence]:
    """Replayed as the author found it. Right answers are held along with the others, so that rounding them is never a fault."""
    solution, givens = key.solution, key.variant.exact
    above = ancestors(solution, truth.place)
    places = {part: key.truths[part].place for part in (*given.right, *given.wrong)}
    right = {places[part]: values for part, values in given.right.items() if places[part] in above}
    wrong = [part for part in given.wrong if places[part] in above]
    rules: list[Rule | None] = [None, *(route.rule for route in solution.unknowns[truth.place].routes)]
    for count in range(min(len(wrong), MOST) + 1):
        for parts in combinations(wrong[-MOST:], count):
            held = {places[part]: given.wrong[part] for part in parts}
            for also in ({}, right) if right else ({},):
                for rule in rules:
                    what_if = WhatIf(also | held, {truth.place: rule} if rule is not None else {})
                    try:
                        values = replay(solution, givens, what_if, truth.place)[truth.place]
                    except Undefined:
                        continue
                    yield Consequence(values, parts, what_if)


def _by_paths(key: Key, truth: Truth, given: FromStudent) -> Iterator[Consequence]:
    """By the formulas of the derivation's other ways, where one of the answers they start from is wrong."""
    if not given.wrong:
        return
    known = given.right | given.wrong
    for path in key.solution.paths.get(key.find(truth).part, ()):
        wrong = tuple(part for part in path.earlier if part in given.wrong)
        if not wrong or not all(part in known for part in path.earlier):
            continue
        own = {
            name: as_exact(value)
            for part in path.earlier
            for name, value in zip(
                key.solution.unknowns[key.truths[part].place].names, known[part], strict=True
            )
        }
        try:
            with precision_of(BITS):
                values = numbers(path.trees, balls(key.variant.exact | own))
        except Undefined:
            continue
        yield Consequence(values, wrong, None)


def degenerate(values: Values, truth: Truth) -> bool:
    """Whether a wrong answer is of no use further on: not finite, zero where the truth is not, or of an absurd size."""
    if not all(map(math.isfinite, values)):
        return True
    size = math.hypot(*values)
    return bool(truth.scale) and not truth.scale / ABSURD <= size <= truth.scale * ABSURD


def copied(values: Values, earlier: Values) -> bool:
    """Whether an answer is another one written down again."""
    return len(values) == len(earlier) and math.dist(values, earlier) <= COPIED * math.hypot(*earlier)
