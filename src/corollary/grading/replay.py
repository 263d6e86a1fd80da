"""A solution replayed on numbers: by the rules, with a student's own earlier values, with a mistake, or rounded at every step."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from corollary.answers.evaluation import BITS, Letters, ball_of, balls, number
from corollary.answers.expected import Values
from corollary.answers.tolerance import ROUNDING_NOISE
from corollary.derive.numbered_list import rule_at, values_of_rule
from corollary.derive.solution import ClosedForms, Numbering, Rule, SceneOutcome, Solution, Unknown, once
from corollary.formula.ast import names
from corollary.formula.ball import Ball, Undefined, precision_of
from corollary.scenes.run import BadSetting, GuardFailed, Run, components

STABLE = 1e-3  # of a value: more than the last bits of what it is made of move it


@dataclass(frozen=True, slots=True)
class WhatIf:
    """What is done differently: unknowns whose values are held (by place), rules exchanged (by place), and a rounding."""

    held: Mapping[int, Values] = field(default_factory=dict[int, Values])
    rules: Mapping[int, Rule] = field(default_factory=dict[int, Rule])
    rounding: Callable[[float], float] | None = None


BY_THE_RULES = WhatIf()


def replay(
    solution: Solution,
    givens: Letters,
    what_if: WhatIf = BY_THE_RULES,
    until: int | None = None,
) -> list[Values]:
    """The value of each find, in order, up to and with the place `until`. Raises Undefined where a value does not exist."""
    values = balls(givens)
    found: list[Values] = []
    with precision_of(BITS):
        for place, find in enumerate(solution.unknowns):
            answer, rule = what_if.held.get(place), what_if.rules.get(place, find.local)
            if answer is None:
                as_formula = isinstance(rule, ClosedForms)
                answer = values_of_rule(rule, values) if as_formula else compute(rule, values)
                if what_if.rounding is not None and as_formula:
                    answer = tuple(map(what_if.rounding, answer))
            for name, value in zip(find.names, answer, strict=find.numbering is None):
                values[name] = ball_of(value)
            found.append(answer)
            if place == until:
                break
    return found


def without_noise(solution: Solution, givens: Letters, what_if: WhatIf, place: int, scale: float) -> Values:
    """The value of the find at a place, 0 for what is left of the `scale` where doubles cancel. Raises Undefined.

    What is tiny for another reason, as an energy without its c², moves no more than the doubles on the way to it do.
    """
    values = replay(solution, givens, what_if, place)[place]
    if all(abs(value) > ROUNDING_NOISE * scale or not value for value in values):
        return values
    above = replay(solution, givens, replace(what_if, rounding=_next_double), place)[place]
    return tuple(
        0.0 if abs(value) <= ROUNDING_NOISE * scale and abs(moved - value) > STABLE * abs(value) else value
        for value, moved in zip(values, above, strict=True)
    )


def _next_double(value: float) -> float:
    return math.nextafter(value, math.inf)


def exchanged(
    solution: Solution, known: Mapping[str, Ball], place: int, rule: Rule, until: int
) -> tuple[float, ...]:
    """What the find at `until` becomes when the rule of an earlier one (or its own) is exchanged, from all values as they are:
    only what is made of it is worked out again. Raises Undefined where a value does not exist."""
    values, answer = dict(known), tuple[float, ...]()
    with precision_of(BITS):
        for at in range(place, until + 1):
            if at == place or place in ancestors(solution, at):
                find = solution.unknowns[at]
                by = rule if at == place else find.local
                answer = values_of_rule(by, values) if isinstance(by, ClosedForms) else compute(by, values)
                values |= zip(find.names, map(ball_of, answer), strict=find.numbering is None)
    return answer


def compute(rule: Rule, values: Letters) -> Values:
    """What a rule gives for these values. Raises Undefined."""
    match rule:
        case ClosedForms(numbering=Numbering()):
            return rule_at(rule, balls(values))
        case ClosedForms(trees):
            return tuple(number(tree, values) for tree in trees)
        case SceneOutcome(scene, settings, observe, runs, bank):
            at = tuple(number(tree, values) for tree in settings.values())
            if runs is None:
                return simulated(scene, tuple(zip(settings, at, strict=True)), observe, bank).values
            if at not in runs:
                runs[at] = simulated(scene, tuple(zip(settings, at, strict=True)), observe, bank).values
            return runs[at]


@dataclass(frozen=True, slots=True)
class Answered:
    """An unknown's values (SI); `errors` are absolute, zero where `certified`; `bound` says that they are proven. `why` there is no
    value: then they are not numbers."""

    values: Values
    certified: bool
    errors: Values
    bound: bool
    why: str = ""


@lru_cache(maxsize=4096)
def simulated(scene: str, settings: tuple[tuple[str, float], ...], observe: str, bank: str) -> Answered:
    """The observed value, and the error that the run states for it; `bank` is the folder of the bank whose scene it is.

    Raises Undefined when the scene refuses, NotDerivable for a fault of its code.
    """
    outcome = _run(scene, settings, bank)
    if observe not in outcome.measured:
        raise Undefined(
            " ".join(outcome.warnings)
            or f"scene {scene} does not observe {observe}; it observes {', '.join(outcome.observed)}"
        )
    seen = outcome.measured[observe]
    return Answered(components(seen.value), False, components(seen.error), seen.error_is == "bound")


@lru_cache(maxsize=256)  # several finds observe one run, one after the other
def _run(scene: str, settings: tuple[tuple[str, float], ...], bank: str) -> Run:
    try:
        from corollary.derive.ready_scenes import run  # only here: most answers need none
    except ModuleNotFoundError:  # in a browser
        raise Undefined("there are no scenes here") from None
    try:
        return run(scene, dict(settings), tolerance=1e-12, bank=Path(bank) if bank else None)
    except (BadSetting, GuardFailed) as error:
        raise Undefined(str(error)) from None


def forget_scenes() -> None:
    """Load ready-made scenes anew and play them again when they are next asked for: their files may have changed."""
    from corollary.derive.ready_scenes import forget  # only here, as above

    forget()
    for cached in (simulated, _run):
        cached.cache_clear()


@once
def ancestors(solution: Solution, place: int) -> frozenset[int]:
    """The places of all finds that a find is made of, by any of its routes."""
    owner = {name: at for at, find in enumerate(solution.unknowns) for name in find.names}
    seen: set[int] = set()
    todo = [place]
    while todo:
        for name in uses(solution.unknowns[todo.pop()]):
            at = owner.get(name)
            if at is not None and at not in seen:
                seen.add(at)
                todo.append(at)
    return frozenset(seen)


def uses(find: Unknown) -> frozenset[str]:
    """Every letter that the rules of a find mention."""
    rules = (find.local, *(route.rule for route in find.routes), *(wrong.rule for wrong in find.mistakes))
    return frozenset[str]().union(*map(letters_of, rules))


def letters_of(rule: Rule) -> frozenset[str]:
    """Every letter that a rule mentions."""
    trees = rule.trees if isinstance(rule, ClosedForms) else rule.settings.values()
    return names(*trees)


def steps_to(solution: Solution, asked: Unknown, known: Set[str]) -> list[Unknown]:
    """The step that answers the part, and those that lead to it from the givens and from the parts that are `known`; from the
    last back."""
    homes = {name: find for find in solution.unknowns for name in find.names}
    found, left = list[Unknown](), [asked]
    while left:
        step = left.pop()
        if all(step is not each for each in found):
            found.append(step)
            before = (homes[name] for name in sorted(letters_of(step.local)) if name in homes)
            left += [each for each in before if each.part not in known]
    return found
