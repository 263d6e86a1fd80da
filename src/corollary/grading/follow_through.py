"""What follows from a student's own earlier answers: a part's value for every consistent choice of them, by every route."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

from corollary.answers.expected import Values
from corollary.answers.tolerance import within
from corollary.derive.solution import Rule
from corollary.formula.ball import Undefined
from corollary.grading.key import Key, Truth
from corollary.grading.replay import WhatIf, ancestors, replay

MOST = 6  # wrong earlier answers combined: 64 choices of them, each by every route


@dataclass(frozen=True, slots=True)
class Consequence:
    """A value of a part: which wrong earlier answers it follows from, and the replay that gave it."""

    values: Values
    earlier: tuple[str, ...]
    what_if: WhatIf


def consequences(key: Key, truth: Truth, answers: Mapping[str, Values]) -> Iterator[Consequence]:
    """The part's value for the student's own earlier answers: first for none of them, then for every combination.

    Answers that are right are held along with the others, so that rounding them is never a fault. A degenerate answer is
    not followed, nor one that makes this part so: everything would follow from it.
    """
    solution, givens = key.solution, key.variant.exact
    above = ancestors(solution, truth.place)
    right: dict[int, Values] = {}
    wrong: dict[str, tuple[int, Values]] = {}
    for part, values in answers.items():
        other = key.truths.get(part)
        if other is None or other.place not in above or len(values) != len(other.values):
            continue
        if within(values, other.values, other.tolerance, other.scale):
            right[other.place] = values
        elif not degenerate(values, other):
            wrong[part] = other.place, values
    rules: list[Rule | None] = [None, *(route.rule for route in solution.unknowns[truth.place].routes)]
    for count in range(min(len(wrong), MOST) + 1):
        for parts in combinations(list(wrong)[-MOST:], count):
            held = dict(wrong[part] for part in parts)
            for also in ({}, right) if right else ({},):
                for rule in rules:
                    what_if = WhatIf(also | held, {truth.place: rule} if rule is not None else {})
                    try:
                        values = replay(solution, givens, what_if, truth.place)[truth.place]
                    except Undefined:
                        continue
                    if any(truth.values) and not any(values):
                        continue
                    yield Consequence(values, parts, what_if)


def degenerate(values: Values, truth: Truth) -> bool:
    """Whether a wrong answer is of no use further on: not finite, or zero where the truth is not."""
    return not all(map(math.isfinite, values)) or (not any(values) and any(truth.values))
