"""A derivation: all that an author states of a problem, in order, and the regimes in which steps differ."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import TYPE_CHECKING, Any

from corollary.derive.statements import (
    Choice,
    Code,
    Confirm,
    Example,
    Explain,
    Finding,
    Forces,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Simulated,
    StatedChoice,
    StatedExample,
    StatedNeglected,
    StatedProof,
    Statement,
    Step,
)
from corollary.formula.ast import Relation, opposite

if TYPE_CHECKING:
    import sympy
    from sympy.logic.boolalg import Boolean

    from corollary.laws.law import Law  # noqa: F401  (named in a text below)


@dataclass(frozen=True, slots=True)
class Limit:
    """What something found comes to when a given goes to its limit."""

    statement: Statement
    of: sympy.Expr
    letter: sympy.Symbol
    to: sympy.Expr
    equals: sympy.Expr


@dataclass(frozen=True, slots=True)
class Special:
    """What is found in a special case: values of givens and, with these, of unknowns, by their letters."""

    statement: Statement
    values: Mapping[str, sympy.Expr]


@dataclass(frozen=True, slots=True)
class Always:
    """What the statement says in words of every variant, as a condition on what is given and found."""

    statement: Statement
    condition: Boolean | bool | str


StatedForces = Forces["sympy.Expr", "Law"]
Asserted = Limit | Special | Confirm
Solved = (
    Step | Optimum | Simulated | StatedChoice | StatedForces | StatedExample | StatedProof | StatedNeglected
)
Entry = Solved | Code | Plot | Explain | Printed | Asserted | Always
ENTRIES = (Step, Optimum, Simulated, Choice, Forces, Example, Proof, Neglected, Code, Plot, Explain, Printed, Limit, Special, Confirm, Always)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Derivation:
    """The entries in the order in which they are found."""

    entries: tuple[Entry, ...]


MOST_WAYS = 8  # in which a condition can hold: each is proven by itself


def one_for_each_part(step: Step, answers: Mapping[str, tuple[sympy.Symbol, ...]]) -> tuple[Step, ...]:
    """A step as one step for each part that it answers, and one for what no part asks for: the same laws, in which the others'
    unknowns are unknowns that this one needs. Raises ValueError."""
    if not answers:
        return (step,)
    found = [each for unknowns in answers.values() for each in unknowns]
    twice = [each for each in found if found.count(each) > 1]
    if strange := [each for each in found if each not in step.unknowns]:
        raise ValueError(f"{strange[0]} answers a part, and is none of the unknowns of the step")
    if twice:
        raise ValueError(f"{twice[0]} answers a part, and answers it twice; name it once")
    rest = tuple(each for each in step.unknowns if each not in found)
    system = tuple(each.name for each in step.unknowns)
    places = [*answers.items(), *([("", rest)] if rest else [])]
    return tuple(
        replace(
            step,
            statement=replace(
                step.statement,
                part=part,
                system=system,
                check=step.statement.check if place == len(places) - 1 else "",
            ),
            unknowns=unknowns,
            also=(*(each for each in step.unknowns if each not in unknowns), *step.also),
        )
        for place, (part, unknowns) in enumerate(places)
    )


@dataclass(frozen=True, slots=True)
class Case:
    """One regime: what the student reads, when it holds, and how things are found then."""

    text: str
    condition: Boolean | bool
    entries: tuple[Entry, ...]
    line: int


@dataclass(frozen=True, slots=True)
class Cases:
    """Regimes of which exactly one holds."""

    cases: tuple[Case, ...]
    line: int


@dataclass(frozen=True, slots=True)
class Branch:
    """A derivation as it is in one case; the case is None where there are none. `before` counts the entries ahead of its own."""

    case: Case | None
    derivation: Derivation
    before: int


StatedEntry = Entry | tuple[Step, ...]
"""An entry, or the steps that one statement makes."""


def one_by_one(stated: Iterable[StatedEntry | Cases]) -> Iterator[Entry | Cases]:
    """The entries without the tuples around some."""
    for each in stated:
        if isinstance(each, tuple):
            yield from each
        else:
            yield each


def branches(entries: Sequence[Entry | Cases]) -> tuple[Branch, ...]:
    """The derivation of each case, or the only one. Raises ValueError where cases are not as they can be."""
    stated = [entry for entry in entries if isinstance(entry, Cases)]
    if not stated:
        return (
            Branch(None, Derivation(tuple(entry for entry in entries if not isinstance(entry, Cases))), 0),
        )
    if len(stated) > 1:
        raise ValueError("cases(…) can stand once in a derivation; state each combination as a case")
    (only,) = stated
    if len(only.cases) < 2:
        raise ValueError("cases(…) needs two cases or more; with one, state its steps as they are")
    for case in only.cases:
        for entry in case.entries:
            if not isinstance(entry, Finding | Choice):
                raise ValueError(
                    "a case holds steps, extrema, simulated finds and choices; state others outside of it"
                )
    place = list(entries).index(only)
    before = tuple(entry for entry in entries[:place] if not isinstance(entry, Cases))
    after = tuple(entry for entry in entries[place + 1 :] if not isinstance(entry, Cases))
    return tuple(
        Branch(case, Derivation((*before, *case.entries, *after)), len(before)) for case in only.cases
    )


def relations(condition: object) -> tuple[Relation, ...]:
    """The relations that must all hold. Raises ValueError where the condition is no relation, nor several joined by sympy's And."""
    import sympy  # only here, as above

    parts = condition.args if isinstance(condition, sympy.And) else (condition,)
    return tuple(_relation(part, condition) for part in parts)


def ways(condition: object) -> tuple[tuple[Relation, ...], ...]:
    """The ways in which a condition can hold, of which no two hold for the same numbers: relations that all hold in each.

    Raises ValueError where the condition joins no relations, or too many.
    """
    found = tuple(islice(_ways(condition, condition), MOST_WAYS + 1))
    if found in ((), ((),)):
        raise ValueError(_refused(condition))
    if len(found) > MOST_WAYS:
        raise ValueError(
            f"{condition} can hold in more than {MOST_WAYS} ways; state cases with conditions that are shorter"
        )
    return found


def clauses(condition: object) -> tuple[tuple[Relation, ...], ...]:
    """A condition as clauses that must all hold, each with one of its relations at least. Raises ValueError as `ways`."""
    import sympy  # only here, as above

    found: list[tuple[Relation, ...]] = []
    for part in condition.args if isinstance(condition, sympy.And) else (condition,):
        joined = isinstance(part, sympy.logic.boolalg.BooleanFunction)
        broken = ways(sympy.Not(part)) if joined else ((opposite(_relation(part, condition)),),)
        found += [tuple(map(opposite, way)) for way in broken]
    return tuple(found)


def _ways(condition: Any, whole: object) -> Iterator[tuple[Relation, ...]]:
    """By the first relation in it: those where it holds, then those where it does not."""
    import sympy  # only here, as above

    if condition in (sympy.true, sympy.false, True, False):
        yield from [()] if condition else []
        return
    first = _first(condition)
    _relation(first, whole)
    for held, value in ((first, sympy.true), (sympy.Not(first), sympy.false)):
        for rest in _ways(condition.xreplace({first: value}), whole):
            yield (_relation(held, whole), *rest)


def _first(condition: Any) -> Any:
    """What stands first in a condition and joins nothing."""
    import sympy  # only here, as above

    joins = isinstance(condition, sympy.logic.boolalg.BooleanFunction) and condition.args
    return _first(condition.args[0]) if joins else condition


def _relation(part: Any, whole: object) -> Relation:
    from corollary.formula.from_sympy import NoTree, relation  # only here, as above

    try:
        return relation(part)
    except NoTree:
        raise ValueError(_refused(whole)) from None


def _refused(condition: object) -> str:
    return (
        f"{condition} is not a condition of a case; write relations, such as mu > tan(alpha), "
        "alone or joined by And, Or and Not"
    )
