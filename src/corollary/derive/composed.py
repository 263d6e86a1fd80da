"""An unknown as one formula of the givens and of answers that are held, by the rules of its derivation or by others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field
from fractions import Fraction

from corollary.derive.inverse import inverses
from corollary.derive.solution import ClosedForms, Solution
from corollary.derive.tried import Tried
from corollary.formula.ast import Call, Expr, Name, Negative, Number, Quotient, Sum, names, substitute
from corollary.formula.operators import has_operators

Trees = tuple[Expr, ...]
NO_LETTERS: Mapping[str, Expr] = {}
ZERO = Number(Fraction(0))


@dataclass(slots=True)
class Rules:
    """The ways to find each unknown from letters before it: as the author does, by routes, and by single laws of any step."""

    solution: Solution
    tried: Tried
    _known: dict[int, list[Trees]] = field(default_factory=dict[int, list[Trees]])

    def of(self, place: int) -> list[Trees]:
        """The author's rule first; none where a scene is run."""
        if place not in self._known:
            self._known[place] = list(self._rules(place))
        return self._known[place]

    def above(self, place: int) -> frozenset[int]:
        """The places of all that the author's rules make an unknown of."""
        owner = {name: at for at, find in enumerate(self.solution.unknowns) for name in find.names}
        seen, todo = set[int](), [place]
        while todo:
            local = self.solution.unknowns[todo.pop()].local
            trees = local.trees if isinstance(local, ClosedForms) else tuple(local.settings.values())
            for at in {owner[name] for tree in trees for name in names(tree) if name in owner} - seen:
                seen.add(at)
                todo.append(at)
        return frozenset(seen)

    def _rules(self, place: int) -> Iterator[Trees]:
        find = self.solution.unknowns[place]
        if not isinstance(find.local, ClosedForms):
            return
        yield find.local.trees
        for route in find.routes:
            if isinstance(route.rule, ClosedForms):
                yield route.rule.trees
        if len(find.names) != 1:
            return
        match find.local.trees:
            case (Call("atan", (Quotient(top, bottom),)),):  # an angle knows its quadrant
                yield (Call("atan2", (top, bottom)),)
            case _:
                pass
        letter = find.names[0]
        before = {given.symbol for given in self.solution.problem.givens} | {"pi"}
        before |= {name for other in self.solution.unknowns[:place] for name in other.names}
        laws = {
            relation: None
            for other in self.solution.unknowns
            for law in (*other.laws, *(law for route in other.routes for law in route.stated.laws))
            for relation in law.here
            if not has_operators(relation)
        }
        for relation in laws:
            residual = Sum((relation.left, Negative(relation.right)))
            if letter in names(residual) and names(residual) - {letter} <= before:
                for tree in inverses(residual, letter, ZERO):
                    if self.tried.agrees(tree, letter):
                        yield (tree,)
                        break


def composed(
    rules: Rules,
    place: int,
    held: Set[int],
    inferred: Mapping[str, Expr] = NO_LETTERS,
    at: int = -1,
    instead: Trees = (),
) -> Trees | None:
    """The unknown at a place in givens and the letters at the places `held`; None where a scene is on the way.

    `inferred` are formulas that take the place of those found for some letters (givens among them), `instead` a rule for the
    unknown at the place `at`.
    """
    meaning: dict[str, Expr] = dict(inferred)
    missing: set[str] = set()
    needed = rules.above(place) | {place}
    for here, find in enumerate(rules.solution.unknowns[: place + 1]):
        if here not in needed or (here in held and here != place):
            continue
        local = find.local
        trees = instead if here == at else local.trees if isinstance(local, ClosedForms) else ()
        lost = not trees or any(names(tree) & missing for tree in trees)
        for index, name in enumerate(find.names):
            if name in inferred:
                continue
            if lost:
                missing.add(name)
            else:
                meaning[name] = substitute(trees[index], meaning)
    found = tuple(meaning.get(name, Name(name)) for name in rules.solution.unknowns[place].names)
    return None if missing & set(rules.solution.unknowns[place].names) else found
