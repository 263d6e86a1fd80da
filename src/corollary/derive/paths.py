"""Every way from a student's earlier answers to a later one that the laws allow, as a formula for it."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations, product

import sympy

from corollary.derive.composed import NO_LETTERS, Rules, Trees, composed
from corollary.derive.inverse import inverses
from corollary.derive.solution import Solution, Way
from corollary.derive.tried import Signature, Tried, same
from corollary.formula.ast import Call, Expr, Name, Power, Sum, names, substitute, walk
from corollary.formula.from_sympy import NoTree
from corollary.formula.from_sympy import tree as from_sympy
from corollary.formula.to_sympy import expression

MOST = 40  # ways for one part: the shortest
SHORT = 16  # letters, numbers and operations of a formula that does without a given
LONG = 80  # the same, before it is made shorter


@dataclass(frozen=True, slots=True)
class Inference:
    """What the answer to a part tells of letters before it: from the unknown at place `of`, or from a given; or nothing."""

    of: int | str | None
    letters: Mapping[str, Expr]


NOTHING = Inference(None, NO_LETTERS)


def with_paths(solution: Solution) -> Solution:
    """The solution with the ways to each part from earlier ones, in the order in which the student meets them."""
    search = Search(solution)
    order = [part.id for part in solution.problem.parts if part.id in search.places]
    found = {part: search.paths(order[:index], part) for index, part in enumerate(order)}
    return replace(solution, paths={part: paths for part, paths in found.items() if paths})


class Search:
    """The ways of one derivation."""

    def __init__(self, solution: Solution):
        self.solution = solution
        self.places = {find.part: place for place, find in enumerate(solution.unknowns) if find.part}
        self.tried = Tried(solution)
        self.rules = Rules(solution, self.tried)

    def paths(self, before: Sequence[str], part: str) -> tuple[Way, ...]:
        """The ways to a part from one earlier answer or from two; the author's own order is no way that need be said."""
        found: list[Way] = []
        useful: dict[str, list[Inference]] = {}
        for earlier in [*combinations(before, 1), *combinations(before, 2)]:
            if len(earlier) == 2 and not all(each in useful for each in earlier):
                continue
            alone = len(earlier) == 1
            seen: list[Signature] = []
            held = {self.places[each] for each in earlier}
            choices = [
                list(self.inferences(self.places[each], held, self.places[part], alone))
                if alone
                else [
                    again
                    for again in self.inferences(self.places[each], held, self.places[part], alone)
                    if any(again.of == once.of for once in useful[each])
                ]
                for each in earlier
            ]
            for chosen in product(*choices):
                inferred = {name: tree for each in chosen for name, tree in each.letters.items()}
                if len(inferred) < sum(len(each.letters) for each in chosen):
                    continue
                for trees in self.functions(self.places[part], held, inferred):
                    signature = self.tried.signature(trees, earlier)
                    if not self._leads(trees, signature, earlier):
                        continue
                    if alone and not isinstance(chosen[0].of, str):
                        useful.setdefault(earlier[0], []).append(chosen[0])
                    if any(_alike(signature, other) for other in seen):
                        continue
                    if isinstance(given := chosen[0].of, str):
                        short = self._short(trees, given, earlier[0], part)
                        if short is None:
                            continue
                        trees = short
                    seen.append(signature)
                    if inferred or trees != composed(self.rules, self.places[part], held):
                        found.append(Way(earlier, trees))
        return tuple(sorted(found, key=_length)[:MOST])

    def inferences(self, place: int, held: Set[int], target: int, alone: bool) -> Iterator[Inference]:
        """What an answer may tell that matters for the target: nothing but itself first."""
        yield NOTHING
        matter = (self.rules.above(target) | {target}) & self.rules.above(place) - held
        others = held - {place}
        for rule in self.rules.of(place):
            for of in sorted(matter):
                forms = composed(self.rules, place, others | {of}, at=place, instead=rule)
                letters = self._solved(forms, place, self.solution.unknowns[of].names)
                if letters:
                    yield Inference(of, letters)
        if alone:
            forms = composed(self.rules, place, others)
            for given in self.solution.problem.givens:
                letters = self._solved(forms, place, (given.symbol,))
                if letters:
                    yield Inference(given.symbol, letters)

    def functions(self, target: int, held: Set[int], inferred: Mapping[str, Expr]) -> Iterator[Trees]:
        """The target by the author's rules, and with one of them exchanged for another."""
        ways = [composed(self.rules, target, held, inferred)]
        for at in sorted((self.rules.above(target) | {target}) - held):
            for rule in self.rules.of(at)[1:]:
                ways.append(composed(self.rules, target, held, inferred, at, rule))
        yield from (trees for trees in ways if trees is not None)

    def _solved(self, forms: Trees | None, place: int, letters: Sequence[str]) -> dict[str, Expr]:
        """The letters, as far as the components of the answer tell them, in turn."""
        found: dict[str, Expr] = {}
        waiting = list(zip(forms or (), self.solution.unknowns[place].names, strict=False))
        while True:
            for pair in waiting:
                form, value = substitute(pair[0], found), Name(pair[1])
                left = [letter for letter in letters if letter not in found and letter in names(form)]
                if len(left) != 1:
                    continue
                root = next(
                    (each for each in inverses(form, left[0], value) if self.tried.agrees(each, left[0])),
                    None,
                )
                if root is not None:
                    found[left[0]] = root
                    waiting.remove(pair)
                    break
            else:
                return found

    def _leads(self, trees: Trees, signature: Signature, earlier: Sequence[str]) -> bool:
        """Whether the way has values, depends on each of the earlier answers, and is more than a copy of one."""
        if sum(values is not None for values in signature) < 2:
            return False
        for part in earlier:
            if all(map(_same_or_none, signature, self.tried.signature(trees, earlier, part))):
                return False
            copied = tuple(map(Name, self.tried.letters[part]))
            if all(map(_same_or_none, signature, self.tried.signature(copied, earlier))):
                return False
        return True

    def _short(self, trees: Trees, given: str, earlier: str, part: str) -> Trees | None:
        """The way as short as it can be written, where somebody may have gone it and left a given aside; else None.

        Who works from the answer then needs fewer givens; or as many, where the part is not made of the answer and that given
        stands in the very rule that leads to it; or one more, where the part is in proportion to the answer.
        """
        place, target = self.places[earlier], self.places[part]
        usual = composed(self.rules, target, {place})
        if usual is None or max(map(_nodes, trees)) > LONG:
            return None
        need, before = self.tried.needs(trees, (earlier,)), self.tried.needs(usual, (earlier,))
        near = place not in self.rules.above(target) and any(
            given in names(tree) for tree in self.rules.of(place)[0]
        )
        if need < before or (near and given not in need and len(need) <= len(before)):
            return _simplified(trees)
        if given in need or len(need) > len(before) + 1:
            return None
        if not self.tried.may_be_in_proportion(trees, earlier):  # no algebra makes it so
            return None
        short = _simplified(trees)
        return short if short and _is_proportional(short, self.solution.unknowns[place].names) else None


def _is_proportional(trees: Trees, answer: Sequence[str]) -> bool:
    """Whether the formulas are single terms, each with the first power of the one number of the answer: `F*dt*m/(M*t)`."""
    return len(answer) == 1 and all(
        [node.name for node in walk(tree) if isinstance(node, Name)].count(answer[0]) == 1
        and not any(
            isinstance(node, (Sum, Call)) or (isinstance(node, Power) and answer[0] in names(node))
            for node in walk(tree)
        )
        for tree in trees
    )


def _same_or_none(left: tuple[float, ...] | None, right: tuple[float, ...] | None) -> bool:
    return left is None or right is None or same(left, right)


def _alike(left: Signature, right: Signature) -> bool:
    return all((a is None and b is None) or same(a, b) for a, b in zip(left, right, strict=True))


def _length(path: Way) -> int:
    return sum(map(_nodes, path.trees))


def _nodes(tree: Expr) -> int:
    return sum(1 for _node in walk(tree))


@lru_cache(maxsize=1024)  # several ways lead to one formula
def _simplified(trees: Trees) -> Trees | None:
    """The formulas as short as they can be written; None where that is still long."""
    letters = {name: sympy.Symbol(name, real=True) for tree in trees for name in names(tree) if name != "pi"}
    try:
        short = tuple(_shortest(expression(tree, letters)) for tree in trees)
    except NoTree:
        return None
    return short if max(map(_nodes, short)) <= SHORT else None


def _shortest(formula: sympy.Expr) -> Expr:
    forms = (formula, sympy.factor(formula), sympy.expand(formula))
    return min(map(from_sympy, forms), key=_nodes)
