"""A problem whose list has an entry for each whole number, with one entry of it: each bend of its law changes every entry alike."""

from __future__ import annotations

from dataclasses import replace

import sympy

from corollary.derive.derivation import Entry
from corollary.derive.load import Loaded
from corollary.derive.numbered_list import entry_of, own_range, solution_for
from corollary.derive.solution import Rule, Solution, Unknown
from corollary.derive.statements import Each, Exchange, Mistake, Printed, Step
from corollary.formula.ball import Undefined
from corollary.laws.law import Law
from corollary.problem.variant import Variant


def with_one_entry(loaded: Loaded, solution: Solution, own: Variant) -> tuple[Loaded, Solution]:
    """The derivation and its solution with the last entry that each list has for these numbers. Raises Undefined."""
    assert solution.template is not None
    lists = solution_for(solution, own.exact).unknowns
    numbers = {
        find.statement.line: _last(find, each) for find, each in zip(solution.template.unknowns, lists, strict=True)
        if find.numbering
    }  # fmt: skip
    parts = {
        find.part: len(each.entries)
        for find, each in zip(solution.template.unknowns, lists, strict=True)
        if find.numbering
    }
    entries = tuple(_stated(entry, numbers, parts) for entry in loaded.derivation.entries)
    derivation = replace(loaded.derivation, entries=entries)
    branches = tuple(replace(each, derivation=derivation) for each in loaded.branches)
    unknowns = tuple(
        _found(find, numbers[find.statement.line]) if find.numbering else find
        for find in solution.template.unknowns
    )
    return (
        replace(loaded, derivation=derivation, branches=branches),
        replace(solution.template, unknowns=unknowns),
    )


def _last(template: Unknown, found: Unknown) -> int:
    """The number of the last entry: the range begins where the form gives the first."""
    for number in range(-1000, 1001):
        if entry_of(template, found.entries[-1].names[0], number).local == found.entries[-1].local:
            return number
    raise Undefined("the number of the last entry is not known")


def _found(find: Unknown, number: int) -> Unknown:
    """The unknown for one number; its mistakes but those that are in the range."""
    one = entry_of(find, find.names[0], number)
    mistakes: list[Mistake[Rule]] = []
    for each in find.mistakes:
        if not own_range(each.rule):
            wrong = entry_of(replace(find, local=each.rule), find.names[0], number).local
            mistakes.append(replace(each, rule=wrong))
    return replace(one, mistakes=tuple(mistakes))


def _stated(entry: Entry, numbers: dict[int, int], parts: dict[str, int]) -> Entry:
    match entry:
        case Step(each=Each(letter=letter)):
            whole = sympy.Integer(numbers[entry.statement.line])
            return replace(
                entry,
                laws=tuple(_numbered(law, letter, whole) for law in entry.laws),
                where=entry.where if isinstance(entry.where, bool) else entry.where.subs(letter, whole),
                mistakes=tuple(
                    replace(each, rule=_exchange(each.rule, letter, whole))
                    for each in entry.mistakes
                    if each.rule.each is None
                ),
                routes=(),
                each=None,
            )
        case Printed() if entry.statement.part in parts:
            return replace(entry, text=entry.text.split(";")[-1].strip())
        case _:
            return entry


def _exchange(rule: Exchange, letter: sympy.Symbol, whole: sympy.Integer) -> Exchange:
    where = (
        rule.where if rule.where is None or isinstance(rule.where, bool) else rule.where.subs(letter, whole)
    )
    return Exchange(tuple(_numbered(law, letter, whole) for law in rule.laws), rule.instead, where)  # type: ignore[arg-type]


def _numbered(law: Law, letter: sympy.Symbol, whole: sympy.Integer) -> Law:
    letters = {
        name: meaning.subs(letter, whole) if isinstance(meaning, sympy.Expr) else meaning
        for name, meaning in law.letters.items()
    }
    return replace(law, letters=letters)
