"""Claims that nothing is created in a collision: no kinetic energy, and no body with less than no mass."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.solution import AppliedLaw, Solution
from corollary.formula.ast import Expr, Number, Power, Product, Relation, Sum, names, substitute
from corollary.verify.obligations.obligation import Obligation
from corollary.verify.obligations.values import TWO, ZERO

Body = tuple[Expr, tuple[Expr, ...]]
"""A mass, and the components of a velocity."""


def not_created(solution: Solution) -> Iterator[Obligation]:
    """After two bodies or more have met, they have no more kinetic energy than before; every mass is positive."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        own = zip(find.names, find.in_givens, strict=True) if find.in_givens is not None else ()
        found |= own
        found |= find.aside
        known = found.keys() | {given.symbol for given in solution.problem.givens} | {"pi"}
        for law in find.laws:
            if law.name != "Conservation of momentum":
                continue
            before, after = (_bodies(law, side) for side in (0, 1))
            every = [tree for mass, speeds in (*before, *after) for tree in (mass, *speeds)]
            if not before or not after or any(names(tree) - known for tree in every):
                continue
            masses = dict.fromkeys(substitute(mass, found) for mass, _ in (*before, *after))
            needs = tuple(
                (Relation(">", mass, ZERO),)
                for mass in masses
                if not (isinstance(mass, Number) and mass.value > 0)
            )
            line = find.statement.line
            yield Obligation("not created", f"the masses around {find.names[0]} are positive", line, needs)
            if len(before) > 1:
                spent = Relation("<=", substitute(_energy(after), found), substitute(_energy(before), found))
                claim = f"no kinetic energy is created where {', '.join(find.names)} is found"
                yield Obligation("not created", claim, line, ((spent,),))


def _bodies(law: AppliedLaw, side: int) -> list[Body]:
    """The bodies of one side of the law; none where it is not a sum of masses times velocities."""
    components = [(relation.left, relation.right)[side] for relation in law.here]
    terms = [each.terms if isinstance(each, Sum) else (each,) for each in components]
    if any(not isinstance(term, Product) or len(term.factors) != 2 for each in terms for term in each):
        return []
    return [
        (column[0].factors[0], tuple(term.factors[1] for term in column))  # type: ignore[union-attr]
        for column in zip(*terms, strict=True)
    ]


def _energy(bodies: list[Body]) -> Expr:
    """Twice the kinetic energy."""
    terms = [Product((mass, Sum(tuple(Power(each, TWO) for each in speeds)))) for mass, speeds in bodies]
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0]
