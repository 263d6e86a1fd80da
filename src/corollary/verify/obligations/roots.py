"""Claims that the laws of a step hold for what is found, and have no other root that the wording admits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from corollary.derive.solution import Solution, Unknown
from corollary.formula.ast import Expr, Relation, substitute
from corollary.formula.operators import has_operators
from corollary.verify.obligations.obligation import Clause, Equations, Obligation, opposite

Found = Mapping[str, Expr]


def only_roots(solution: Solution) -> Iterator[Obligation]:
    """For each step: its condition holds for the root that is meant, and for no other that is real."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        if find.laws:
            yield _only_root(find, found)
        if find.in_givens is not None:
            found |= zip(find.names, find.in_givens, strict=True)
        found |= find.aside


def _only_root(find: Unknown, found: Found) -> Obligation:
    claim = f"{', '.join(find.names)} is the only admissible root of its laws"
    line = find.statement.line
    if find.in_givens is None:
        return Obligation("one root", claim, line, open="it rests on a simulation")
    if find.where is None:
        return Obligation("one root", claim, line, open="its condition is no relation")
    here = [relation for law in find.laws for relation in law.here]
    meant = dict(zip(find.names, find.in_givens, strict=True)) | dict(find.aside)
    needs: list[Clause] = [(_put(each, meant | dict(found)),) for each in find.where]
    rejected = [each.values for each in find.others if each.worded]
    equations = None
    if not any(map(has_operators, here)) and all(rejected):
        where = [_put(each, found) for each in find.where]
        equations = Equations(
            tuple(_put(each, found) for each in here), tuple(meant), meant, tuple(rejected), tuple(where)
        )
    why = ""
    for other in (each for each in find.others if not each.worded):
        if find.where and other.values:
            meaning = dict(other.values) | dict(found)
            needs.append(
                (*_same(other.values, meant), *(opposite(_put(each, meaning)) for each in find.where))
            )
        else:
            why = "whether another root is real, or which condition it breaks, was tried at four draws"
    return Obligation("one root", claim, line, tuple(needs), equations, open=why)


def _same(other: Found, meant: Found) -> Clause:
    """That another root of one unknown is there the one that is meant: a double root."""
    (name, *more) = other
    return () if more or name not in meant else (Relation("=", other[name], meant[name]),)


def _put(relation: Relation, meaning: Found) -> Relation:
    return Relation(relation.sign, substitute(relation.left, meaning), substitute(relation.right, meaning))
