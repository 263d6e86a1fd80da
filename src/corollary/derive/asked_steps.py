"""The steps of a solution that a sheet needs which asks some of its parts: those that answer these, and those that lead there."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace

from corollary.derive.solution import AppliedLaw, ClosedForms, Rule, Solution, SolvedRoute, Unknown
from corollary.formula.ast import names


def asked_steps(solution: Solution, asked: Collection[str]) -> dict[int, Unknown]:
    """By their places, in the solution's order. The answer of a part that is not `asked` stands there where a step needs it,
    as something that nobody asks about; another way that starts from what is left out is left out, too."""
    found = dict(enumerate(solution.unknowns))
    if all(not find.part or find.part in asked for find in found.values()):
        return found
    homes = {name: place for place, find in found.items() for name in _named(find)}
    left_out = {place for place, find in found.items() if find.part and find.part not in asked}
    beside = {homes[name] for part in asked for name in _beside(solution, part) if name in homes}
    answers = {place for place, find in found.items() if find.part in asked}
    needed = _with_those_before(solution, answers | beside, homes)
    for_others = _with_those_before(solution, left_out, homes)

    def by_itself(place: int) -> bool:
        """Whether no part needs it, and all it starts from is there: the texts may speak of it."""
        return place not in for_others and for_others & _with_those_before(solution, {place}, homes) <= needed

    places = [place for place in found if place in needed or by_itself(place)]
    hidden = {name for name, place in homes.items() if place not in places}
    return {place: _without(found[place], asked, hidden) for place in places}


def _with_those_before(solution: Solution, places: Collection[int], homes: Mapping[str, int]) -> set[int]:
    """The places given, and of all steps whose letters lead there or stand in the equations."""
    found, left = set[int](), [*places]
    while left:
        place = left.pop()
        if place not in found:
            found.add(place)
            left += [homes[name] for name in _used(solution.unknowns[place]) if name in homes]
    return found


def _without(find: Unknown, asked: Collection[str], hidden: Collection[str]) -> Unknown:
    """As one that nobody asks about where its part is not asked, and without ways over letters that are hidden."""
    routes = tuple(route for route in find.routes if not _letters(route) & set(hidden))
    statement = find.statement if find.part in asked else replace(find.statement, part="")
    return replace(find, statement=statement, routes=routes)


def _letters(route: SolvedRoute) -> frozenset[str]:
    return frozenset(_in_laws(route.stated.laws)) | _in_rule(route.rule)


def _named(find: Unknown) -> tuple[str, ...]:
    return (*find.names, *(each.name for each in find.functions))


def _used(find: Unknown) -> frozenset[str]:
    return frozenset(_in_laws(find.laws)) | _in_rule(find.local)


def _beside(solution: Solution, part: str) -> Iterator[str]:
    """The letters in what a part neglects, shows, or draws."""
    for each in solution.neglected:
        if each.statement.part == part:
            yield from _used(each.bound)
    for entries in (solution.proofs, solution.examples):
        if part in entries:
            yield from _in_laws(entries[part].laws)
    if part in solution.forces:
        yield from _in_laws(each.law for each in solution.forces[part].balances)


def _in_laws(laws: Iterable[AppliedLaw]) -> Iterator[str]:
    for law in laws:
        for relation in law.here:
            yield from names(relation)


def _in_rule(rule: Rule) -> frozenset[str]:
    """Every letter that a rule mentions."""
    trees = rule.trees if isinstance(rule, ClosedForms) else rule.settings.values()
    return frozenset[str]().union(*map(names, trees))
