"""Claims that the laws of a step hold for what is found, and have no other root that the wording admits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from corollary.derive.solution import Solution, Unknown
from corollary.formula.ast import Expr, Relation, opposite, substitute
from corollary.formula.operators import has_operators
from corollary.verify.obligations.obligation import Clause, Equations, Obligation

Found = Mapping[str, Expr]
NOT_FOUND = "that the algebra system has found all roots is not proven"


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
        return Obligation("one root", claim, line, open="it rests on a simulation", tried=False)
    if find.where is None:
        return Obligation("one root", claim, line, open="its condition is no relation")
    here = [relation for law in find.laws for relation in law.here]
    meant = dict(zip(find.names, find.in_givens, strict=True)) | dict(find.aside)
    needs: list[Clause] = [(_put(each, meant | dict(found)),) for each in find.where]
    rejected = [each.values for each in find.others if each.worded]
    others = [each.values for each in find.others if not each.worded and each.values]
    partial = [_not_admitted(other, meant, find.where, found) for other in others]
    equations = None
    if not any(map(has_operators, here)) and all(rejected):
        where = [_put(each, found) for each in find.where]
        laws = tuple(_put(each, found) for each in here)
        equations = Equations(laws, tuple(meant), meant, tuple(rejected), tuple(where), tuple(others))
    return Obligation(
        "one root", claim, line, tuple(needs), equations, tuple(partial), open="" if equations else NOT_FOUND
    )


def _not_admitted(other: Found, meant: Found, where: tuple[Relation, ...], found: Found) -> Clause:
    """That another root is the one that is meant, breaks a condition, or has no value: a relation that is never true says so."""
    broken = tuple(opposite(_put(each, dict(other) | dict(found))) for each in where)
    no_value = (
        () if where and len(other) == 1 else tuple(Relation("!=", each, each) for each in other.values())
    )
    return (*_same(other, meant), *broken, *no_value)


def _same(other: Found, meant: Found) -> Clause:
    """That another root of one unknown is there the one that is meant: a double root."""
    (name, *more) = other
    return () if more or name not in meant else (Relation("=", other[name], meant[name]),)


def _put(relation: Relation, meaning: Found) -> Relation:
    return Relation(relation.sign, substitute(relation.left, meaning), substitute(relation.right, meaning))
