"""Several regimes, such as rest and sliding: each with its condition and its own steps, of which one holds for the numbers drawn."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

from corollary.derive.derivation import Derivation, Entry
from corollary.derive.statements import Choice, Finding
from corollary.formula.ast import Relation, opposite

if TYPE_CHECKING:  # as in statements.py: what is solved already is used without any algebra
    from sympy.logic.boolalg import Boolean

MOST_WAYS = 8  # in which a condition can hold: each is proven by itself


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
        f"{condition} is no condition of a case; write relations, such as mu > tan(alpha), "
        "alone or joined by And, Or and Not"
    )
