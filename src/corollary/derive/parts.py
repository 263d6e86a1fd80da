"""Every part of a problem has an entry of its kind in the solution, and one only, which measures what it asks for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from corollary.answers.registry import answer_type
from corollary.derive.derivation import ENTRIES, Always, Asserted, Derivation, Entry
from corollary.derive.solution import Unsolved
from corollary.derive.statements import (
    Code,
    Example,
    Finding,
    FunctionFormula,
    Neglected,
    Optimum,
    Printed,
    Simulated,
    Step,
)
from corollary.formula.ast import Expr, names
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.dimension import Dimension
from corollary.units.unit import called, show, si_unit

if TYPE_CHECKING:  # it brings sympy, which a kept solution does without
    from corollary.derive.assumptions import Known


def misfits(problem: Problem, derivation: Derivation) -> Iterator[tuple[str, int]]:
    """What does not fit between the parts and the entries: a sentence, and the line of the entry it is about (or 0)."""
    for entry in derivation.entries:
        if not isinstance(entry, ENTRIES):  # pyright: ignore[reportUnnecessaryIsInstance]
            yield (
                f"derivation(…) holds a {type(entry).__name__}, which is not an entry; use step(…), choice(…), explain(…), "
                "one behind the other, without square brackets",
                0,
            )
            return
    ids = {part.id for part in problem.parts}
    for entry in derivation.entries:
        if (part := entry.statement.part) and part not in ids:
            yield f"answers part {part}, which {problem.path.name} does not have", entry.statement.line
        elif isinstance(entry, Simulated) and not part:
            yield (
                "a simulated find must answer a part, whose unit it takes; add answers=",
                entry.statement.line,
            )
        elif part:
            yield from ((sentence, entry.statement.line) for sentence in _unfit(problem, entry, part))
    given = Counter(
        (entry.statement.part, words_of_kind(entry))
        for entry in derivation.entries
        if not isinstance(entry, Printed | Neglected | Asserted | Always)
    )
    for part in problem.parts:
        for word in _stated_by(part):
            if not given[part.id, word]:
                yield (
                    f"answers no part {part.id}; each part of {problem.path.name} needs an entry, here {word}(…)",
                    0,
                )
            if given[part.id, word] > 1:
                yield f"answers part {part.id} more than once; keep one {word}(…)", 0
    yield from _misprinted(problem, derivation)


def _unfit(problem: Problem, entry: Entry, name: str) -> Iterator[str]:
    part = problem.part(name)
    wanted = _stated_by(part)
    if isinstance(entry, Neglected) and (wanted != ["step"] or part.rows or part.of):
        yield f"part {name} is .{part.answer_type}; only of a number can be said what is neglected in it"
    elif not isinstance(entry, Printed | Neglected) and words_of_kind(entry) not in wanted:
        yield f"part {name} is .{' .'.join(part.answer_types)}; answer it with {' and '.join(f'{word}(…)' for word in wanted)}"
    elif (
        part.answer_type == "list"
        and not part.components
        and not (isinstance(entry, Printed | Neglected) or (isinstance(entry, Step) and entry.each))
    ):
        yield (
            f'part {name} is a .list; name what it holds, components="first second", or state in its step for which whole numbers '
            "there is an entry: each: `m` from `1` to `floor(d/lam)`"
        )
    elif (
        isinstance(entry, Code)
        and isinstance(entry.judge, FunctionFormula)
        and "".join(part.signature.split()) != entry.judge.signature
    ):
        yield f'part {name} asks for function="{part.signature}", and {entry.judge.signature} is judged; make them the same'
    elif isinstance(entry, Step | Optimum | Simulated | Example) and len(entry.unknowns) != (
        len(part.components) or 1
    ):
        numbers = (
            f"{len(part.components)} entries, row by row"
            if part.rows
            else f"components {', '.join(part.components)}"
            if part.components
            else "one number"
        )
        found = ", ".join(map(str, entry.unknowns))
        aside = "; what the laws need besides goes into also" if len(entry.unknowns) > 1 else ""
        yield f"part {name} asks for {numbers}, but {found} is found{aside}"


def _stated_by(part: Part) -> list[str]:
    """The author's words that answer a part: one, or `code` and `plot`."""
    return [answer_type(name).stated_by for name in part.answer_types]


def _misprinted(problem: Problem, derivation: Derivation) -> Iterator[tuple[str, int]]:
    found = {
        entry.statement.part: len(entry.unknowns)
        for entry in derivation.entries
        if isinstance(entry, Finding)
    }
    for entry in derivation.entries:
        if (
            isinstance(entry, Printed)
            and answer_type(problem.part(entry.statement.part).answer_type).stated_by == "choice"
        ):
            letters = [option.letter for option in problem.part(entry.statement.part).options]
            if entry.text.strip("() ").lower() not in letters:
                yield (
                    f"printed: part {entry.statement.part} has the options {', '.join(letters)}; {entry.text!r} is none of them",
                    entry.statement.line,
                )
        elif isinstance(entry, Printed) and (numbers := len(entry.text.split(";"))) != found.get(
            entry.statement.part
        ):
            yield (
                f"printed: part {entry.statement.part} has {found.get(entry.statement.part, 'no')} numbers, but {entry.text!r} gives {numbers}; part several by semicolons",
                entry.statement.line,
            )


def unsolved(derivation: Derivation) -> tuple[Unsolved, ...]:
    """The entries that are used as they stand: code, plot, explain, printed."""
    return tuple(entry for entry in derivation.entries if isinstance(entry, Unsolved))


def dimensions_asked(
    problem: Problem, part_id: str, answer: tuple[Expr, ...], known: Known
) -> tuple[Dimension, ...]:
    """The dimension of each component of what is found. Raises ValueError when it is not what the part asks for."""
    part = next((part for part in problem.parts if part.id == part_id), None)
    if part is None:
        return known.dimensions_of(answer, None)
    units = part.units_for(len(answer))
    known.refuse_variables(
        names(*answer),
        f'; say of="{{variable}}" in its heading, or find it at one {{variable}} that is given, as in {known.some_function}(t1)',
        part.of,
    )
    for formula, unit in zip(answer, units, strict=True):
        (dimension,) = known.dimensions_of((formula,), unit.dimension)
        if dimension != unit.dimension:
            remedy = "" if show(unit) else f'; say unit="{show(si_unit(dimension))}" in its heading'
            raise ValueError(
                f"the answer is not in {show(unit) or 'plain numbers'}, it is {called(dimension)}{remedy}"
            )
    return tuple(unit.dimension for unit in units)


def words_of_kind(entry: Entry) -> str:
    """The author's word that makes such an entry."""
    return "step" if isinstance(entry, Finding) else type(entry).__name__.lower()
