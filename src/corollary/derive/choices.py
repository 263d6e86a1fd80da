"""Conditions in givens: those of the options of a choice, and what an author claims of all numbers."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.assumptions import Known
from corollary.derive.cases import clauses, ways
from corollary.derive.derivation import Always, Entry
from corollary.derive.load import NotDerivable
from corollary.derive.solution import ClaimedCondition, SolvedChoice, Ways
from corollary.derive.statements import Choice
from corollary.formula.ast import Number, Relation
from corollary.problem.part import Part


def solved_choice(entry: Choice[Boolean | bool], part: Part, known: Known) -> SolvedChoice:
    """Raises ValueError where the options are not those of the part."""
    letters = {option.letter for option in part.options}
    if letters != entry.options.keys():  # pyright: ignore[reportUnnecessaryComparison]
        raise ValueError(
            f"its options are {', '.join(sorted(letters))}; give each of them, and no other, its condition"
        )
    options: dict[str, Ways] = {}
    for letter, condition in entry.options.items():
        try:
            holds = known.in_givens_alone(condition)
            constant = holds in (sympy.true, sympy.false)
            options[letter] = (((),) if holds else ()) if constant else ways(holds)
        except ValueError as error:
            raise ValueError(f"option {letter}: {error}") from None
    return Choice(entry.statement, options, entry.mistakes)


def claims(
    entries: Iterable[Entry], known: Known, failing: Callable[[str, int], NotDerivable]
) -> Iterator[ClaimedCondition]:
    """What an author claims of all numbers. Raises what `failing` makes where a claim is none, or speaks of what is unknown."""
    for entry in entries:
        if isinstance(entry, Always):
            words, line = entry.statement.because, entry.statement.line
            try:
                yield ClaimedCondition(words, _claimed(entry.condition, known), line)
            except ValueError as error:
                raise failing(f"always(…): {error}", line) from error


def _claimed(condition: Boolean | bool | str, known: Known) -> tuple[tuple[Relation, ...], ...]:
    """None of a condition that sympy takes for true of all numbers: which of its letters it has cancelled cannot be seen any more."""
    if isinstance(condition, str):
        return ((known.relation_in_givens(condition),),)
    holds = known.in_givens_alone(condition)
    if holds == sympy.true:
        return ()
    if holds == sympy.false:
        one = Number(Fraction(1))
        return ((Relation("!=", one, one),),)
    return clauses(holds)
