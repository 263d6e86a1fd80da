"""Hints to a part: the next step on the shortest way from what a student has to what is asked, told in three turns.

A hint names what to find, the laws, and the textbook's equation. It never has a value, and no equation that is the answer's own formula.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence, Set
from itertools import permutations

from corollary.answers.evaluation import as_exact
from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.formula.ast import Expr, Name, Number, names
from corollary.formula.ball import Undefined, certified
from corollary.formula.latex import latex, letter, vector
from corollary.grading.advice import advice, steps_to
from corollary.grading.key import Key
from corollary.grading.replay import letters_of
from corollary.messages import catalogue
from corollary.problem.part import Part

_ = catalogue(__name__)
_law_name = catalogue("corollary.laws")

FORMULA = re.compile(r"\$[^$]*\$")
MOST_LETTERS = 5
POINTS = ((1.25, 2.5, 0.375, 3.0, 0.8125), (0.75, 1.5, 2.375, 1.125, 4.5))  # where two formulas are compared
DIGIT = re.compile(r"\d")


def hints(key: Key, part: Part, right: Set[str]) -> tuple[str, ...]:
    """What may be told, one after the other, to whom the parts in `right` are known; the author's own hint comes first. Empty
    where nothing can be told."""
    return (*((part.hint,) if part.hint else ()), *_of_the_derivation(key, part, right))


def _of_the_derivation(key: Key, part: Part, right: Set[str]) -> tuple[str, ...]:
    """What the derivation has to tell."""
    solution = key.solution
    asked = solution.answer(part.id)
    if asked is not None:
        steps = missing(solution, asked, right)
        return tuple(_of_step(key, steps, asked, right))
    laws = _laws_of(solution, part.id)
    if laws:
        return tuple(_of_laws(laws, ()))
    thought = advice(key, part)
    return (thought,) if thought else ()


def missing(solution: Solution, asked: Unknown, right: Set[str]) -> list[Unknown]:
    """The steps that are still to be taken, in an order in which they can be; the last is the one asked for.

    Of the author's way and those of `Solution.paths`, which lead from earlier answers straight to a later one, the shorter.
    """
    if any(set(way.earlier) <= right for way in solution.paths.get(asked.part, ())):
        return [asked]
    needed = steps_to(solution, asked, right)
    return [find for find in solution.unknowns if any(find is each for each in needed)]


def _of_step(key: Key, steps: Sequence[Unknown], asked: Unknown, right: Set[str]) -> Iterator[str]:
    step, problem = steps[0], key.variant.problem
    found = ", ".join(f"${letter(name)}$" for name in step.names)
    if step is asked:
        needs = letters_of(step.local)
        earlier = [
            problem.part(find.part).heading_letter
            for find in key.solution.unknowns
            if find.part in right and needs & set(find.names)
        ]
        if earlier:
            yield _(
                "One step is left, and it starts from your answer in {parts}.",
                parts=", ".join(f"({each})" for each in earlier),
            )
        else:
            yield _("One step leads from what is given to the answer.")
    elif step.part:
        part = problem.part(step.part)
        yield _(
            "Find first what ({part}) asks for: {title}. From there it is {count} more.",
            part=part.heading_letter,
            title=part.title,
            count=_steps(len(steps) - 1),
        )
    else:
        yield _(
            "Something that nobody asks for comes first; call it {found}. From there it is {count} more.",
            found=found,
            count=_steps(len(steps) - 1),
        )
    yield from _of_laws(step.laws, _formulas(step, asked), _why(step))


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
    return not isinstance(side, (Name, Number)) and any(_alike(side, answer) for answer in answers)


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
