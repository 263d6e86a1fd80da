"""Rules for a part that are one change from its derivation and that no solution lists."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.formula.ast import Expr, names, substitute
from corollary.formula.plain_text import text
from corollary.grading.advice import steps_to
from corollary.grading.one_change import OneChange, changes
from corollary.units.unit import PURE, Dimension


@dataclass(frozen=True, slots=True)
class UnlistedRule:
    """A rule `in words`, the formulas that it exchanges in the step of the unknowns `named`, and what it makes of the part:
    `trees`, in givens and in what other parts ask for. `draft` is a line for the solution, to be looked at by its author."""

    words: str
    formula: str
    message: str
    draft: str
    trees: tuple[Expr, ...]


def as_derived(solution: Solution, part: str) -> tuple[Expr, ...] | None:
    """The part by the derivation, in givens and in what other parts ask for; None where it is simulated."""
    asked = solution.answer(part)
    return (
        None if asked is None or not isinstance(asked.local, ClosedForms) else _composed(solution, asked, {})
    )


def rules_near(solution: Solution, part: str) -> list[UnlistedRule]:
    """First by a change in the steps that lead to the part from the parts before it, then by one in its formula in givens."""
    asked = solution.answer(part)
    if asked is None:
        return []
    found: list[UnlistedRule] = []
    parts = {find.part for find in solution.unknowns if find.part}
    for step in steps_to(solution, asked, parts):
        if isinstance(step.local, ClosedForms):
            for change in _changes(solution, step, step.local.trees):
                if (trees := _composed(solution, asked, {step.names: change.trees})) is not None:
                    found.append(_rule(step, change, trees))
    if asked.in_givens is not None:
        found += [_rule(asked, each, each.trees) for each in _changes(solution, asked, asked.in_givens)]
    return found


def _composed(
    solution: Solution, asked: Unknown, instead: Mapping[tuple[str, ...], tuple[Expr, ...]]
) -> tuple[Expr, ...] | None:
    """The formulas of `asked`, those of steps that nobody asks for put in; some exchanged."""
    meaning: dict[str, Expr] = {}
    for find in solution.unknowns:
        local = find.local.trees if isinstance(find.local, ClosedForms) else None
        own = instead.get(find.names, local)
        if find is asked:
            return None if own is None else tuple(substitute(tree, meaning) for tree in own)
        if own is not None and not find.part:
            meaning |= zip(find.names, (substitute(tree, meaning) for tree in own), strict=True)
    return None


def _changes(solution: Solution, step: Unknown, trees: tuple[Expr, ...]) -> list[OneChange]:
    kinds: dict[str, tuple[Dimension, bool]] = {}
    for given in solution.problem.givens:
        if not given.words:
            kinds[given.symbol] = given.unit.dimension, bool(given.unit.pi)
    measured = [name for name, (dimension, _) in kinds.items() if dimension != PURE.dimension]
    for find in solution.unknowns:
        if find is step:
            break
        for name, dimension in zip(find.names, find.dimensions, strict=True):
            if dimension != PURE.dimension:
                kinds[name] = dimension, False
    used = frozenset[str]().union(*map(names, trees)) & kinds.keys()
    alike = {
        name: [other for other in kinds if other != name and kinds[other] == kinds[name]] for name in used
    }
    return changes(trees, alike, measured)


def _rule(step: Unknown, change: OneChange, trees: tuple[Expr, ...]) -> UnlistedRule:
    equations = [f"{name} = {text(tree)}" for name, tree in zip(step.names, change.trees, strict=True)]
    stated = ", ".join(f"wrong({json.dumps(each)})" for each in equations)
    draft = f"mistake({json.dumps(change.message)}, {stated}{_instead(step.laws)})"
    words = f"{change.words} in {', '.join(step.names)}"
    return UnlistedRule(words, "; ".join(equations), change.message, draft, trees)


def _instead(laws: Sequence[AppliedLaw]) -> str:
    given = [law.name for law in laws]
    return f", instead={json.dumps(given)}" if len(given) > 1 else ""
