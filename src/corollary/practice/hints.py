"""Hints to a part: the steps from what a student has to what is asked, each told in three turns.

A hint names what to find, the laws, and the textbook's equation. It never has a value, and no equation that is the answer's own formula.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass
from itertools import permutations
from typing import TypeAlias

from corollary.answers.evaluation import as_exact
from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.formula.ast import Expr, Name, Number, names
from corollary.formula.ball import Undefined, certified
from corollary.formula.latex import latex, letter, letters_printed, vector
from corollary.formula.operators import has_operators
from corollary.grading.advice import advice_for
from corollary.grading.key import Key
from corollary.grading.replay import letters_of, steps_to
from corollary.messages import catalogue
from corollary.problem.part import Part

_ = catalogue(__name__)
_law_name = catalogue("corollary.laws")

FORMULA = re.compile(r"\$[^$]*\$")
MOST_LETTERS = 5
POINTS = ((1.25, 2.5, 0.375, 3.0, 0.8125), (0.75, 1.5, 2.375, 1.125, 4.5))  # where two formulas are compared
DIGIT = re.compile(r"\d")


@dataclass(frozen=True, slots=True)
class Fork:
    """Hints that depend on whether `part` is known already."""

    part: str
    known: Hints
    unknown: Hints


Hints: TypeAlias = Fork | tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Remaining:
    """The steps that are still to be taken, in an order in which they can be; the last is the one asked for, and it starts from
    the answers to the parts in `starts`."""

    steps: tuple[Unknown, ...]
    starts: tuple[str, ...]

    def same_as(self, other: Remaining) -> bool:
        return self.starts == other.starts and list(map(id, self.steps)) == list(map(id, other.steps))


def hints(key: Key, part: Part, right: Set[str]) -> tuple[str, ...]:
    """What may be told, one after the other, to whom the parts in `right` are known; the author's own hint comes first. Empty
    where nothing can be told."""
    asked = key.solution.answer(part.id)
    return _hints(key, part, remaining(key.solution, asked, right) if asked is not None else None)


def hints_by_known(key: Key, part: Part) -> Hints:
    """The hints for every choice of known parts, as a tree.

    A part that becomes known takes steps away and adds none: what is left with the fewest and with the most of some parts known
    is left with any of these known.
    """
    asked = key.solution.answer(part.id)
    if asked is None:
        return hints(key, part, frozenset())
    of_steps = {step.part for step in steps_to(key.solution, asked, frozenset())}
    of_ways = {each for way in key.solution.paths.get(asked.part, ()) for each in way.earlier}
    count = [
        each.id for each in key.variant.problem.parts if each.id in of_steps | of_ways and each.id != part.id
    ]
    return _tree(key, part, asked, frozenset(), count)


def _tree(key: Key, part: Part, asked: Unknown, right: frozenset[str], others: Sequence[str]) -> Hints:
    fewest, most = (remaining(key.solution, asked, known) for known in (right, right.union(others)))
    if fewest.same_as(most):
        return _hints(key, part, fewest)
    first = next(
        (
            each
            for each in others
            if not remaining(key.solution, asked, right | {each}).same_as(fewest)
            or not remaining(key.solution, asked, right.union(others) - {each}).same_as(most)
        ),
        others[0],
    )
    left = [each for each in others if each != first]
    return Fork(
        first,
        known=_tree(key, part, asked, right | {first}, left),
        unknown=_tree(key, part, asked, right, left),
    )


def remaining(solution: Solution, asked: Unknown, right: Set[str]) -> Remaining:
    """Of the author's way and those of `Solution.paths`, which lead from earlier answers straight to a later one, the shorter."""
    needed = steps_to(solution, asked, right)
    if len(needed) > 1:
        for way in solution.paths.get(asked.part, ()):
            if set(way.earlier) <= right:
                return Remaining((asked,), way.earlier)
    letters = letters_of(asked.local)
    return Remaining(
        tuple(find for find in solution.unknowns if any(find is each for each in needed)),
        tuple(find.part for find in solution.unknowns if find.part in right and letters & set(find.names)),
    )


def _hints(key: Key, part: Part, left: Remaining | None) -> tuple[str, ...]:
    own = (part.hint,) if part.hint else ()
    with letters_printed(key.variant.problem.printed_letters):
        if left is not None:
            return tuple(dict.fromkeys((*own, *_of_steps(key, left))))
        if laws := _laws_of(key.solution, part.id):
            return (*own, *_of_laws(laws, ()))
    thought = advice_for(key, part, None)
    return (*own, thought) if thought else own


def _of_steps(key: Key, left: Remaining) -> Iterator[str]:
    """Each step in turn, as far as the one that decides."""
    asked = left.steps[-1]
    for place, step in enumerate(left.steps):
        yield _opening(key, left, place)
        thoughts = tuple(_of_laws(step.laws, _formulas(step, asked), _why(step)))
        if not thoughts and step.part:  # laws that say no more than the answer itself
            thoughts = tuple(filter(None, (advice_for(key, key.variant.problem.part(step.part), None),)))
        yield from thoughts


def _opening(key: Key, left: Remaining, place: int) -> str:
    """What a step finds, and how many come after it."""
    step, problem, after = left.steps[place], key.variant.problem, len(left.steps) - 1 - place
    if not after and place:
        return _("Now the last step: the quantity asked for.")
    if not after and left.starts:
        parts = ", ".join(f"({problem.part(each).heading_letter})" for each in left.starts)
        return _("One step is left, and it starts from your answer in {parts}.", parts=parts)
    if not after:
        return _("One step leads from what is given to the answer.")
    if step.part:
        part = problem.part(step.part)
        return _(
            "First find the answer to ({part}): {title}. After that, {count} to go.",
            part=part.heading_letter,
            title=part.title,
            count=_steps(after),
        )
    return _(
        "First find a quantity that is not asked for; call it {found}. After that, {count} to go.",
        found=", ".join(f"${letter(name)}$" for name in step.names),
        count=_steps(after),
    )


def _of_laws(laws: Sequence[AppliedLaw], answers: Sequence[Expr], why: str = "") -> Iterator[str]:
    """The laws by their names and when they hold; then as the textbook has them."""
    laws_by_name = [_law_name(law.name) for law in laws if not _only_names(law)]
    if laws_by_name:
        thought = _("Think of: {laws}.", laws="; ".join(dict.fromkeys(laws_by_name)))
        yield " ".join(filter(None, (thought, why)))
    elif why:
        yield why
    written = [
        f"$${_equation(law)}$$"
        for law in laws
        if not _only_names(law) and not any(_is(side, answers) for side in _sides(law))
    ]
    if written:
        opening = _("In the letters of a textbook:")
        yield "\n\n".join([opening, *dict.fromkeys(written)])


def _equation(law: AppliedLaw) -> str:
    return latex(law.textbook, {name: vector(name) for name in law.vectors})


def _why(step: Unknown) -> str:
    """The author's reason, where it speaks of the situation and of no formula or number."""
    because = step.statement.because
    bare = all("=" not in each for each in FORMULA.findall(because))
    return because if bare and "=" not in because and not DIGIT.search(because) else ""


def _steps(count: int) -> str:
    return _.plural("{count} step", "{count} steps", count)


def _laws_of(solution: Solution, part: str) -> tuple[AppliedLaw, ...]:
    if part in solution.proofs:
        return tuple(solution.proofs[part].laws)
    if part in solution.examples:
        return tuple(solution.examples[part].laws)
    return ()


def _only_names(law: AppliedLaw) -> bool:
    """Whether it only says that two things are the same."""
    return all(isinstance(side, Name) for side in _sides(law))


def _sides(law: AppliedLaw) -> tuple[Expr, Expr]:
    return law.textbook.left, law.textbook.right


def _formulas(step: Unknown, asked: Unknown) -> list[Expr]:
    """The answer as a formula: of earlier unknowns, and of givens alone."""
    trees = list(step.local.trees) if isinstance(step.local, ClosedForms) else []
    return [*trees, *(step.in_givens or ()), *(asked.in_givens or ())]


def _is(side: Expr, answers: Sequence[Expr]) -> bool:
    """Whether a side of an equation is an answer's formula in other letters; a letter or a number alone is none."""
    if isinstance(side, (Name, Number)) or has_operators(side):
        return False
    return any(_alike(side, answer) for answer in answers)


def _alike(one: Expr, other: Expr) -> bool:
    """Whether there is an exchange of letters that makes one of the other; of many letters it is not asked."""
    mine, theirs = sorted(names(one) - {"pi"}), sorted(names(other) - {"pi"})
    if len(mine) != len(theirs) or len(mine) > MOST_LETTERS:
        return False
    points = [dict(zip(theirs, numbers, strict=False)) for numbers in POINTS]
    values = [_value(other, point) for point in points]
    for order in permutations(range(len(mine))):
        exchanged = [{mine[k]: point[theirs[order[k]]] for k in range(len(mine))} for point in points]
        found = [_value(one, point) for point in exchanged]
        if all(
            mine_value is not None and value is not None and math.isclose(mine_value, value, rel_tol=1e-12)
            for mine_value, value in zip(found, values, strict=True)
        ):
            return True
    return False


def _value(tree: Expr, point: dict[str, float]) -> float | None:
    try:
        return certified(tree, {name: as_exact(value) for name, value in point.items()}).value
    except Undefined:
        return None
