"""The key of a variant: every answer with certified digits, its tolerance, and what mistakes and earlier slips would give."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from corollary.answers.evaluation import as_exact, number
from corollary.answers.expected import Values
from corollary.derive.solution import SceneOutcome, Solution, Unknown
from corollary.formula.ast import Relation
from corollary.formula.ball import RationalPi, Undefined, certified, holds
from corollary.grading.replay import compute, simulated
from corollary.grading.rounding import LEAST, MOST, noise_of
from corollary.problem.variant import Variant

MARGIN = 1.25  # beyond the largest of a few dozen random roundings there are rarer ones
TINY = 1e-9  # of the length: a component so small is a remainder of the arithmetic


@dataclass(frozen=True, slots=True)
class Truth:
    """The answer to one part: SI values, whether their digits are certified, and what may be off.

    `scale` is what the tolerance is relative to: the length of the answer, or what the problem names where that is zero.
    `uncertain` is how far rounding moves each component (absolute): a smaller component has no sign of its own.
    """

    place: int
    values: Values
    proven: bool
    error: float
    scale: float
    tolerance: float
    noise: float
    uncertain: Values

    @property
    def value(self) -> float | tuple[float, ...]:
        """The number, or one for each component, in SI."""
        return self.values[0] if len(self.values) == 1 else self.values


@dataclass(frozen=True, slots=True)
class Key:
    """Everything a variant can be marked with; `values` are the finds in the solution's order."""

    solution: Solution
    variant: Variant
    values: tuple[Values, ...]
    truths: Mapping[str, Truth]
    choices: Mapping[str, str]

    def __getitem__(self, part: str) -> Truth:
        """The answer to a part that asks for a quantity or a formula."""
        return self.truths[part]

    def find(self, truth: Truth) -> Unknown:
        return self.solution.unknowns[truth.place]


def make_key(solution: Solution, variant: Variant) -> Key:
    """The key of one variant. Raises Undefined when an answer does not exist for these numbers."""
    givens = variant.exact
    values: list[Values] = []
    stated: dict[int, tuple[bool, float]] = {}
    for place, find in enumerate(solution.unknowns):
        try:
            numbers, proven, error = answer(solution, find, variant, values)
        except Undefined as why:
            what = f"part {find.part}" if find.part else ", ".join(find.names)
            raise Undefined(f"{what} has no value for these numbers: {why}") from why
        values.append(numbers)
        stated[place] = proven, error
    noise = noise_of(solution, givens, values)
    truths: dict[str, Truth] = {}
    known = givens | named(solution, values)
    for place, find in enumerate(solution.unknowns):
        if find.part:
            proven, error = stated[place]
            scale = scale_of(find, values[place], known)
            off = MARGIN * noise[place].distance / scale if scale else 0.0
            uncertain = tuple(MARGIN * each + TINY * scale for each in noise[place].components)
            truths[find.part] = Truth(
                place, values[place], proven, error, scale, min(MOST, max(LEAST, off + error)), off, uncertain
            )
    choices = {
        part: option_that_holds(truth.options, givens, part) for part, truth in solution.choices.items()
    }
    return Key(solution, variant, tuple(values), truths, choices)


def answer(
    solution: Solution, find: Unknown, variant: Variant, before: Sequence[Values]
) -> tuple[Values, bool, float]:
    """An unknown's values from its closed form, certified; or from its scene, with the error the run states."""
    if find.in_givens is not None:
        givens = variant.exact
        found = [certified(tree, givens) for tree in find.in_givens]
        return tuple(each.value for each in found), all(each.proven for each in found), 0.0
    known = variant.exact | named(solution, before)
    match find.local:
        case SceneOutcome(scene, settings, observe):
            at = tuple((name, number(tree, known)) for name, tree in settings.items())
            numbers, error = simulated(scene, at, observe)
            return numbers, False, error
        case rule:
            return compute(rule, known), False, 1e-12


def named(solution: Solution, values: Sequence[Values]) -> dict[str, RationalPi]:
    """The unknowns found so far, by their letters, as exact numbers."""
    return {
        name: as_exact(value)
        for find, numbers in zip(solution.unknowns, values, strict=False)
        for name, value in zip(find.names, numbers, strict=True)
        if math.isfinite(value)
    }


def scale_of(find: Unknown, values: Values, known: Mapping[str, RationalPi]) -> float:
    """The length of the answer; where the answer is zero, what the solution names, or the largest given of its dimension."""
    length = math.hypot(*values)
    if length > 0 or find.scale is None:
        return length
    try:
        return abs(number(find.scale, known))
    except Undefined:
        return 0.0


def option_that_holds(
    options: Mapping[str, Relation | bool], givens: Mapping[str, RationalPi], part: str
) -> str:
    """The letter of the one option that holds. Raises Undefined when it is not exactly one."""
    true = [
        letter
        for letter, held in options.items()
        if (held if isinstance(held, bool) else holds(held, givens))
    ]
    if len(true) != 1:
        raise Undefined(f"part {part}: {len(true)} options hold ({', '.join(true)}); exactly one must")
    return true[0]
