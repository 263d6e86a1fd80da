"""The questions that the parts of a problem are, and what does not fit between a part's heading and its answer type."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from corollary.answers.bound import extreme_asked
from corollary.answers.positive_direction import angle_reference, named_positive
from corollary.answers.question import Question, Symbol
from corollary.answers.registry import BUILT_IN, answer_type, known
from corollary.problem.bank import Bank, chapter_order, readable
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.statement import HOLE, filled
from corollary.problem.variant import Variant

SIGNATURE = re.compile(r"[A-Za-z_]\w*\([\w\s,]*\)$")


def question_of(problem: Problem, part: Part) -> Question:
    """A part as readers of answers see it, in the letters of the sheet that it was handed out on."""
    return Question(
        part.id,
        problem.variable(part),
        part.answer_types,
        part.unit,
        part.title,
        part.components,
        tuple(option.letter for option in part.options),
        tuple(option.text for option in part.options),
        part.signature,
        (
            *(_symbols(problem.givens) if not problem.renamed else _symbols_asked(problem)),
            *_variables(problem, part),
        ),
        part.slope,
        part.rows,
        part.columns,
        part.column_units,
        named_positive(problem.statement, part.text),
        angle_reference(problem.statement, f"{part.title} {part.text}"),
        extreme_asked(part.title, part.text),
        " ".join(part.text.split()),
        tuple((each.symbol, *each.ends) for each in problem.variables if each.symbol in part.of),
    )


def question_in(variant: Variant, part: Part) -> Question:
    """The same as a student reads it: the options with the numbers of the variant."""
    question = question_of(variant.problem, part)
    if not any(HOLE.search(text) for text in question.option_texts):
        return question
    return replace(question, option_texts=tuple(filled(text, variant) for text in question.option_texts))


# By identity: every part of every student's sheet asks for them. What they are made of is held, so that its id stays its own.
_SYMBOLS: dict[int, tuple[tuple[Given, ...], tuple[Symbol, ...]]] = {}
MOST_CACHED = 256


def _symbols(givens: tuple[Given, ...]) -> tuple[Symbol, ...]:
    found = _SYMBOLS.get(id(givens))
    if found is None:
        if len(_SYMBOLS) >= MOST_CACHED:
            _SYMBOLS.clear()
        found = (
            givens,
            tuple(Symbol(given.symbol, given.unit, given.meaning) for given in givens if not given.words),
        )
        _SYMBOLS[id(givens)] = found
    return found[1]


def _symbols_asked(problem: Problem) -> tuple[Symbol, ...]:
    """As on the sheet: a given of today under a letter that meant another one there is not on it."""
    asked = dict(problem.renamed)
    there = [given for given in problem.givens if given.symbol in asked or given.symbol not in asked.values()]
    return tuple(Symbol(asked.get(given.symbol, given.symbol), given.unit, given.meaning) for given in there)


def _variables(problem: Problem, part: Part) -> tuple[Symbol, ...]:
    """The letters that the part's formula is asked of, each with its domain, too."""
    return tuple(
        Symbol(each.symbol, each.unit, f"{each.meaning}, {each.domain}")
        for each in problem.variables
        if each.symbol in part.of
    )


def checked(problem: Problem) -> Problem:
    """The problem, whose headings fit their answer types. Raises Malformed with every misfit."""
    found = [
        Diagnostic(problem.path, part.line, sentence) for part in problem.parts for sentence in _misfits(part)
    ]
    if not found:
        found = [
            Diagnostic(
                problem.path,
                part.line,
                f"part {part.id} asks for no quantity and no option; leave expected= out",
            )
            for part in problem.parts
            if part.id in dict(problem.expected) and not _foreseeable(part)
        ]
    if found:
        raise Malformed(found)
    return problem


def askable(bank: Bank) -> tuple[list[Problem], list[Diagnostic]]:
    """The problems of a bank that can be asked, in the order of the chapter, and what is wrong with the others."""
    problems, broken = readable(bank)
    found: list[Problem] = []
    for problem in sorted(problems, key=lambda each: chapter_order(each.code)):
        try:
            found.append(checked(problem))
        except Malformed as error:
            broken += error.complaints
    return found, broken


def _misfits(part: Part) -> Iterator[str]:
    if not _possible(part.answer_types):
        types = ", ".join(f".{name}" for name in known())
        yield f"part {part.id} needs one kind of {types} (or .code .plot together)"
        return
    types = [answer_type(name) for name in part.answer_types]
    accepted = frozenset[str]().union(*(each.accepts for each in types))
    needed = frozenset[str]().union(*(each.needs for each in types))
    if part.rows and "rows" not in accepted:
        yield f"part {part.id}: only .table parts have rows and columns"
    elif part.components and "components" not in accepted and not part.rows:
        having = [f".{name}" for name in known() if "components" in answer_type(name).accepts]
        yield f"part {part.id}: only {', '.join(having[:-1])} and {having[-1]} parts have components"
    if not part.components and "components" in needed:
        yield f'part {part.id} is .{part.answer_type}; name its components: components="x y"'
    if "rows" in needed and not part.rows:
        yield f'part {part.id} is a .table; name its rows and columns: rows="before, after" columns="v, E", or say how many: rows=2 columns=2'
    if part.rows and any(unit.offset for unit in part.units):
        yield f"part {part.id}: the temperatures of a table are asked in K"
    if part.answer_type == "integer" and part.tolerance:
        yield f"part {part.id}: a whole number is exact; leave tolerance= and because= out, or ask for a .value"
    if (part.tolerance or part.plausible) and not any(
        each.stated_by == "step" and not each.in_symbols for each in types
    ):
        yield f"part {part.id} asks for no quantity; leave tolerance=, because= and plausible= out"
    if part.plausible and part.column_units:
        yield f"part {part.id}: the columns of its table differ in their units; leave plausible= out"
    if part.of and "expression" not in part.answer_types:
        yield f"part {part.id}: only .expression parts are formulas of a variable; leave of= out, or ask for an .expression"
    if part.given and "proof" not in part.answer_types:
        yield f"part {part.id}: only .proof parts have given equations"
    if part.slope and "slope" not in accepted:
        yield f"part {part.id}: only .forces parts have a slope"
    if ("function" in needed) != bool(part.signature) or (
        part.signature and not SIGNATURE.match(part.signature)
    ):
        yield f'part {part.id}: a .code part, and only that, has a function="name(arguments)"'
    if len(part.options) < 2 if "options" in needed else part.options:
        listing = [f".{name}" for name in known() if "options" in answer_type(name).accepts]
        yield f"part {part.id}: {' and '.join(listing)} parts, and only these, list options, each as: - (a) text"


def _foreseeable(part: Part) -> bool:
    """Whether its answer can be told in a number or a letter beforehand."""
    return not part.of and all(
        answer_type(name).stated_by in ("step", "choice") for name in part.answer_types
    )


def _possible(types: tuple[str, ...]) -> bool:
    """One answer type that exists; or a function and a figure drawn with it. Other packages are asked for what is not ours only."""
    if not types or not (set(types) <= set(BUILT_IN) or set(types) <= set(known())):
        return False
    return len(types) == 1 or [answer_type(name).found_in for name in types] == ["function", "figure"]
