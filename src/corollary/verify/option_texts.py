"""The options of a choice, told apart in print: for every draw where the numbers in them have few values, else for a sample."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import prod

from corollary.formula.ast import Relation, names
from corollary.formula.ball import holds
from corollary.formula.errors import Undefined
from corollary.grading.assign import options_alike
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.statement import holes
from corollary.problem.variant import Variant, chapter, written
from corollary.verify.checked import Tally

MOST = 4000  # sets of numbers that are all tried
SAMPLED = 400  # of the grid, where there are more


def check_options(problem: Problem, tally: Tally) -> None:
    """Complains of options that print alike with the printed numbers, or whatever the numbers; notes the draws that are left out."""
    for part in problem.parts:
        if not part.options:
            continue
        where, own = f"{problem.path.name}:{part.line}: part {part.id}", chapter(problem)
        letters = sorted(
            {letter for option in part.options for hole in holes(option.text) for letter in hole.letters}
        )
        if met := _alike(own, part):
            one, other = met
            numbers = f" with {_numbers(own, letters)}, the printed numbers" if letters else ""
            tally.complain(f"{where}: options {one} and {other} print alike{numbers}; change one of them")
            continue
        tried = list(_variants(problem, letters))
        found = [(variant, pair) for variant in tried if (pair := _alike(variant, part))]
        tally.count("options apart", len(tried) - len(found))
        if found:
            first, (one, other) = found[0]
            tally.note(
                f"{where}: options {one} and {other} print alike with {_numbers(first, letters)} ({len(found)} of {len(tried)} "
                "sets of numbers): these are never dealt"
            )


def _variants(problem: Problem, letters: Sequence[str]) -> Iterator[Variant]:
    """Every set of values of these givens, the others as printed; where those are too many, a sample of the grid."""
    own = chapter(problem)
    moved = [given for given in problem.givens if given.symbol in letters]
    if prod(given.grid.count for given in moved) > MOST:
        yield from sample(problem, SAMPLED, salt="options")
        return
    conditions = [each.relation for each in problem.conditions if names(each.relation) - {"pi"} <= {*letters}]
    for places in product(*(range(given.grid.count) for given in moved)):
        values = {given.symbol: given.grid[place] for given, place in zip(moved, places, strict=True)}
        variant = Variant(problem, {**own.values, **values}, None)
        if all(_fulfilled(each, variant) for each in conditions):
            yield variant


def _fulfilled(condition: Relation, variant: Variant) -> bool:
    try:
        return holds(condition, variant.exact) is True
    except Undefined:
        return False


def _alike(variant: Variant, part: Part) -> tuple[str, str] | None:
    """The marks of two options of the part that print alike; None where numbers that are never dealt give an option no value."""
    try:
        return next(((one, other) for _part, one, other in options_alike(variant, (part,))), None)
    except Undefined:
        return None


def _numbers(variant: Variant, letters: Sequence[str]) -> str:
    return ", ".join(f"{letter} = {written(variant, letter)}" for letter in letters)
