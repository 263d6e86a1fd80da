"""Letters introduced in a worked solution: a line for those of a step, of constants of nature, and the ones nobody explains."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import chain, groupby

from corollary.derive.intermediate_units import words_and_unit
from corollary.derive.numbers_in_formulas import quantity
from corollary.derive.solution import Solution, Unknown
from corollary.formula.ast import Name, names
from corollary.formula.latex import letter
from corollary.messages import catalogue
from corollary.problem.problem import Problem

_ = catalogue(__name__)

FEW = 6  # letters that a heading has room for; a matrix has as many as forty


def introduced(found: Collection[Unknown], problem: Problem) -> list[str]:
    """A line that names the givens that occur where these are found, and an empty one; constants of nature have a line of their
    own. `problem` is in the language spoken."""
    used = frozenset[str]().union(*map(_letters_in_laws, found))
    used |= names(*(tree for each in found for tree in each.in_givens or ()))
    given = {each.symbol: each.meaning for each in problem.givens if each.symbol in used and not each.source}
    given |= {each.symbol: each.meaning for each in problem.variables if each.symbol in used}
    return _line((name, meaning) for name, meaning in given.items() if meaning)


def constants_of_nature(problem: Problem) -> list[str]:
    """A line for each: its value, what it is, and where the value is from."""
    return [
        f"- ${letter(given.symbol)} = {quantity(float(given.value), given.unit)}$, {given.meaning} ({given.source})"
        for given in problem.givens
        if given.source
    ]


def asked_for(find: Unknown, of: Collection[str] = ()) -> str:
    """The letters of what a part asks for, as they stand behind its title; `of` are the variables that it is a formula of."""
    variables = f"({', '.join(map(letter, of))})" if of else ""
    spoken = [f"${letter(name)}{variables}$" for name in find.names]
    return ", ".join(spoken if len(spoken) <= FEW else [spoken[0], "…", spoken[-1]])


def found_first(find: Unknown, solution: Solution) -> str:
    """The letters of what nobody asks for, each with what it stands for."""
    return _listed(
        (name, words_and_unit(solution.meanings.get(name, ""), dimension)[0])
        for name, dimension in zip(find.names, find.dimensions, strict=True)
    )


def explained(find: Unknown, solution: Solution, known: Collection[str]) -> list[str]:
    """A line that names the letters of this step which the author explains and that no line has named (not `known`), and an empty one."""
    headed = () if find.part else find.names
    used = _letters_in_laws(find) | set(find.names)
    dimensions = {
        name: dimension
        for each in solution.unknowns
        for name, dimension in zip(each.names, each.dimensions, strict=True)
    }
    return _line(
        (name, words_and_unit(meaning, dimensions[name])[0] if name in dimensions else meaning)
        for name, meaning in solution.meanings.items()
        if name in used and name not in known and name not in headed
    )


def unexplained(solution: Solution) -> Iterator[tuple[int, str]]:
    """Letters that a step's laws have and nothing introduces, with the step's line.

    Introduced is what is given, what its author explains, what is asked for and found here or before, and what stands alone on
    the left of a law, for then the law's name says what it is.
    """
    known = {each.symbol for each in solution.problem.letters} | solution.meanings.keys() | {"pi"}
    for find in solution.unknowns:
        together = [each for each in solution.unknowns if each.statement.solved_with(find.statement)]
        for each in (find, *together):
            known |= set(each.names) if each.part else set()
        known |= {each.left.name for law in find.laws for each in law.here if isinstance(each.left, Name)}
        known |= {name for each in find.functions for name in (each.name, each.letter)}
        for name in sorted((_letters_in_laws(find) | set(find.names)) - known):
            known.add(name)
            yield find.statement.line, name


def _letters_in_laws(find: Unknown) -> frozenset[str]:
    return frozenset(chain.from_iterable(names(relation) for law in find.laws for relation in law.here))


def _line(letters: Iterable[tuple[str, str]]) -> list[str]:
    listed = _listed(letters)
    return [_("*Letters:* {letters}.", letters=listed), ""] if listed else []


def _listed(letters: Iterable[tuple[str, str]]) -> str:
    """Those that follow each other and stand for the same, such as components, have it said once."""
    together = (
        (meaning, [f"${letter(name)}$" for name, _word in each])
        for meaning, each in groupby(letters, lambda pair: pair[1])
    )
    return ", ".join(", ".join(each) + (f" ({meaning})" if meaning else "") for meaning, each in together)
