"""Several regimes, such as rest and sliding: each with its condition and its own steps, of which one holds for the numbers drawn."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from corollary.derive.derivation import Derivation, Entry
from corollary.derive.statements import Choice, Finding
from corollary.formula.ast import Relation

if TYPE_CHECKING:  # as in statements.py: what is solved already is used without any algebra
    from sympy.logic.boolalg import Boolean


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

    from corollary.formula.from_sympy import NoTree, relation

    parts = condition.args if isinstance(condition, sympy.And) else (condition,)
    try:
        return tuple(relation(part) for part in parts)  # pyright: ignore[reportArgumentType]
    except NoTree:
        raise ValueError(
            f"{condition} is no condition of a case; write relations, such as mu > tan(alpha)"
        ) from None
