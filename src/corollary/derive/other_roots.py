"""Records of the root that is meant: the conditions on it, and the roots of the same laws that are not meant."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.assumptions import Known
from corollary.derive.cases import relations
from corollary.derive.roots import Picked
from corollary.derive.solution import OtherRoot
from corollary.derive.statements import Step
from corollary.formula.ast import Expr, Relation
from corollary.formula.authored import NotTyped, as_expression
from corollary.formula.from_sympy import NoTree, tree


def conditions(entry: Step) -> tuple[Relation, ...] | None:
    """The conditions on the root that is meant; None where they are no relations."""
    if isinstance(entry.where, bool):
        return ()
    try:
        return relations(entry.where)
    except ValueError:
        return None


def others(picked: Picked, known: Known) -> Iterator[OtherRoot]:
    """The roots that are not meant, in givens."""
    for worded, roots in ((True, picked.worded), (False, picked.others)):
        for root in roots:
            values = {symbol.name: formula(known.in_givens(value)) for symbol, value in root.items()}
            whole = {name: value for name, value in values.items() if value is not None}
            yield OtherRoot(whole if len(whole) == len(values) else {}, worded)


def asides(entry: Step, known: Known) -> dict[str, Expr]:
    """What the laws needed besides, in givens."""
    found = {symbol.name: formula(known.aside[symbol]) for symbol in entry.also}
    return {name: value for name, value in found.items() if value is not None}


def formula(expression: object) -> Expr | None:
    """In our own terms; None where it is no formula of ours."""
    try:
        return tree(as_expression(expression))
    except (NoTree, NotTyped):  # NotTyped: a complex root
        return None
