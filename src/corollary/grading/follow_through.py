"""Consequences of a student's own earlier answers: a part's value along every way that the laws allow."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import combinations, islice

from corollary.answers.evaluation import BITS, as_exact, balls, numbers
from corollary.answers.expected import FollowThrough, Values
from corollary.derive.solution import ClosedForms, Rule, Solution, Way
from corollary.formula.ast import Expr, Name, Sum, children, negated, replace_child
from corollary.formula.ball import Undefined, precision_of
from corollary.grading.key import Key, Truth
from corollary.grading.mistakes import slips_of_input, wrong_values
from corollary.grading.replay import WhatIf, ancestors, replay, without_noise

MOST = 6  # wrong earlier answers combined: 64 choices of them, each by every route
ABSURD = 1050.0  # times too large or too small: a power of ten is still followed, beyond it there is no physics left to follow
COPIED = 1e-9
MOST_TURNED = 16  # terms of a formula: of a longer one the first
CANCELLED = 1e-13  # of the part: what two doubles leave of each other


@dataclass(frozen=True, slots=True)
class AsWritten:
    """What is known of an earlier answer beside its values: half of the last figure of each (SI; 0: not rounded), and whether its
    error has a name, so that it was worked out: a known misconception, a slip, or what follows from another."""

    halves: Values = ()
    named: bool = False


@dataclass(frozen=True, slots=True)
class FromStudent:
    """The student's answers to other parts, of which later ones may be made: right ones, and wrong ones of some use; and how
    they were written."""

    right: dict[str, Values]
    wrong: dict[str, Values]
    written: Mapping[str, AsWritten] = field(default_factory=dict[str, AsWritten])


def from_student(
    key: Key, answers: Mapping[str, Values], written: Mapping[str, AsWritten] | None = None
) -> FromStudent:
    """What may be followed. A degenerate answer is not, for everything would follow from it, unless its error has a name."""
    right: dict[str, Values] = {}
    wrong: dict[str, Values] = {}
    notes = written or {}
    for part, values in answers.items():
        truth = key.truths.get(part)
        if truth is None or len(values) != len(truth.values):
            continue
        if truth.is_met_by(values):
            right[part] = values
        elif not degenerate(values, truth, named=part in notes and notes[part].named):
            wrong[part] = values
    return FromStudent(right, wrong, notes)


def consequences(
    key: Key, truth: Truth, answers: Mapping[str, Values], written: Mapping[str, AsWritten] | None = None
) -> Iterator[FollowThrough]:
    """The part's value for the student's own earlier answers: first for none of them, then for every combination.

    First along the author's order, then along the other ways of the derivation. What makes the part nothing, which everybody can
    write down, is left out unless every error before it has a name.
    """
    given = from_student(key, answers, written)
    named = {part for part, note in given.written.items() if note.named}
    for each in (*_in_order(key, truth, given), *_by_paths(key, truth, given)):
        if any(each.values) or not any(truth.values) or (each.earlier and named.issuperset(each.earlier)):
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


def _in_order(key: Key, truth: Truth, given: FromStudent) -> Iterator[FollowThrough]:
    """Replayed as the author found it. Right answers are held along with the others, so that rounding them is never a fault."""
    solution = key.solution
    above = ancestors(solution, truth.place)
    right = {part: values for part, values in given.right.items() if key.truths[part].place in above}
    wrong = [part for part in given.wrong if key.truths[part].place in above]
    rules: list[Rule | None] = [None, *(route.rule for route in solution.unknowns[truth.place].routes)]
    for count in range(min(len(wrong), MOST) + 1):
        for parts in combinations(wrong[-MOST:], count):
            held = {part: given.wrong[part] for part in parts}
            for also in ({}, right) if right else ({},):
                for rule in rules:
                    own = also | held
                    work = partial(_replayed, key, truth, rule)
                    try:
                        values = work(own)
                    except Undefined:
                        continue
                    what_if = _what_if(key, truth, rule, own)
                    yield FollowThrough(
                        values,
                        parts,
                        partial(wrong_values, key, truth, what_if),
                        partial(slips_of_input, key, truth, what_if),
                        partial(_moved, work, own, given.written, values),
                        partial(_turned_in_order, key, truth, rule, own),
                    )


def _what_if(key: Key, truth: Truth, rule: Rule | None, held: Mapping[str, Values]) -> WhatIf:
    places = {key.truths[part].place: values for part, values in held.items()}
    return WhatIf(places, {truth.place: rule} if rule is not None else {})


def _replayed(key: Key, truth: Truth, rule: Rule | None, held: Mapping[str, Values]) -> Values:
    """Raises Undefined."""
    what_if, givens = _what_if(key, truth, rule, held), key.variant.exact
    if not held:
        return replay(key.solution, givens, what_if, truth.place)[truth.place]
    return without_noise(key.solution, givens, what_if, truth.place, truth.scale)


def _by_paths(key: Key, truth: Truth, given: FromStudent) -> Iterator[FollowThrough]:
    """By the formulas of the derivation's other ways, where one of the answers they start from is wrong."""
    if not given.wrong:
        return
    known = given.right | given.wrong
    for path in key.solution.paths.get(key.find(truth).part, ()):
        wrong = tuple(part for part in path.earlier if part in given.wrong)
        if not wrong or not all(part in known for part in path.earlier):
            continue
        own = {part: known[part] for part in path.earlier}
        work = partial(_along, key, truth, path)
        try:
            values = work(own)
        except Undefined:
            continue
        moved = partial(_moved, work, own, given.written, values)
        yield FollowThrough(values, wrong, moved=moved, turned=partial(_turned_along, key, truth, path, own))


def _along(key: Key, truth: Truth, path: Way, own: Mapping[str, Values]) -> Values:
    """Raises Undefined."""
    letters = {
        name: as_exact(value)
        for part, values in own.items()
        for name, value in zip(key.solution.unknowns[key.truths[part].place].names, values, strict=True)
    }
    with precision_of(BITS):
        values = numbers(path.trees, balls(key.variant.exact | letters))
    return tuple(0.0 if abs(value) <= CANCELLED * truth.scale else value for value in values)


def _moved(
    work: Callable[[Mapping[str, Values]], Values],
    own: Mapping[str, Values],
    written: Mapping[str, AsWritten],
    values: Values,
) -> Iterator[Values]:
    """What comes of each number moved by half of its last figure, to the side where it makes more of a difference."""
    for part, numbers_written in own.items():
        halves = written[part].halves if part in written else ()
        for place, half in enumerate(halves):
            if not half:
                continue
            found = [values]
            for off in (half, -half):
                moved = (
                    *numbers_written[:place],
                    numbers_written[place] + off,
                    *numbers_written[place + 1 :],
                )
                with suppress(Undefined):
                    found.append(work({**own, part: moved}))
            found = [each for each in found if len(each) == len(values)]
            yield max(found, key=lambda each: math.dist(each, values))


def _turned_in_order(
    key: Key, truth: Truth, rule: Rule | None, held: Mapping[str, Values]
) -> Iterator[Values]:
    own = rule or key.find(truth).local
    for trees in _with_a_sign_turned(own.trees) if isinstance(own, ClosedForms) else ():
        with suppress(Undefined):
            yield _replayed(key, truth, ClosedForms(trees), held)


def _turned_along(key: Key, truth: Truth, path: Way, own: Mapping[str, Values]) -> Iterator[Values]:
    for trees in _with_a_sign_turned(path.trees):
        with suppress(Undefined):
            yield _along(key, truth, replace(path, trees=trees), own)


def _with_a_sign_turned(trees: tuple[Expr, ...]) -> Iterator[tuple[Expr, ...]]:
    """The formulas with one term of one sum taken away instead of added, or the other way round."""
    for place, tree in enumerate(trees):
        for other in islice(_turns(tree), MOST_TURNED):
            yield (*trees[:place], other, *trees[place + 1 :])


def _turns(tree: Expr) -> Iterator[Expr]:
    for place, part in enumerate(children(tree)):
        if isinstance(tree, Sum):
            yield replace_child(tree, place, negated(part))
        for other in _turns(part):
            yield replace_child(tree, place, other)


def degenerate(values: Values, truth: Truth, *, named: bool = False) -> bool:
    """Whether a wrong answer is of no use further on: not finite, zero where the truth is not, or of an absurd size.

    An error that has a `name` may make it of any size: who multiplies by milliseconds instead of dividing is off by a million.
    """
    if not all(map(math.isfinite, values)):
        return True
    size = math.hypot(*values)
    if named:
        return not size
    return bool(truth.scale) and not truth.scale / ABSURD <= size <= truth.scale * ABSURD


def copied(values: Values, earlier: Values) -> bool:
    """Whether an answer is another one written down again."""
    return len(values) == len(earlier) and math.dist(values, earlier) <= COPIED * math.hypot(*earlier)
