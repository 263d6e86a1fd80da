"""What a student found before: the values that may be carried into a later part, in every combination of a consistent student."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

from corollary.derive.solution import Rule
from corollary.formula.ball import Undefined
from corollary.grading.closeness import within
from corollary.grading.key import Key, Truth
from corollary.grading.replay import Values, WhatIf, ancestors, replay

MOST = 6


@dataclass(frozen=True, slots=True)
class Carried:
    """A value for a part: which earlier parts were carried into it, by which route, and what it then is."""

    values: Values
    parts: tuple[str, ...]
    deviation: WhatIf


def carried(key: Key, truth: Truth, answers: Mapping[str, Values]) -> Iterator[Carried]:
    """The part's value for the student's own earlier values: first none carried, then every combination, by every route.

    Values that are right are carried along with the others, so that rounding them is never a fault. A carried value that
    is degenerate, or makes this part so, is left out.
    """
    solution, givens = key.solution, key.variant.exact
    above = ancestors(solution, truth.place)
    right: dict[int, Values] = {}
    off: dict[str, tuple[int, Values]] = {}
    for part, values in answers.items():
        other = key.truths.get(part)
        if other is None or other.place not in above or len(values) != len(other.values):
            continue
        if within(values, other.values, other.tolerance, other.scale):
            right[other.place] = values
        elif usable(values, other):
            off[part] = other.place, values
    rules: list[Rule | None] = [None, *(route.rule for route in solution.finds[truth.place].routes)]
    for count in range(min(len(off), MOST) + 1):
        for parts in combinations(list(off)[-MOST:], count):
            held = dict(off[part] for part in parts)
            for exact in ({}, right) if right else ({},):
                for rule in rules:
                    deviation = WhatIf(exact | held, {truth.place: rule} if rule is not None else {})
                    try:
                        values = replay(solution, givens, deviation, truth.place)[truth.place]
                    except Undefined:
                        continue
                    if any(truth.values) and not any(values):
                        continue
                    yield Carried(values, parts, deviation)


def usable(values: Values, truth: Truth) -> bool:
    """Whether a wrong value may be carried: finite, and not nought where the truth is not."""
    return all(map(math.isfinite, values)) and (any(values) or not any(truth.values))


def size(values: Values, truth: Truth) -> float:
    """What a tolerance is relative to: the length of the value, or the part's own scale where that is nought."""
    return math.hypot(*values) or truth.scale
