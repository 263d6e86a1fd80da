"""Ways from a student's own answers to the others: formulas composed, turned round, and tried on numbers."""

# pyright: reportArgumentType=false, reportCallIssue=false, reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations, product

import sympy

from corollary.answers.evaluation import as_exact, number
from corollary.derive.solution import ClosedForms, Solution, Way
from corollary.formula.ast import (
    ZERO,
    Call,
    Expr,
    Name,
    Power,
    Quotient,
    Sum,
    difference,
    names,
    substitute,
    walk,
)
from corollary.formula.ball import RationalPi, Undefined
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.from_sympy import tree as from_sympy
from corollary.formula.operators import has_operators
from corollary.formula.to_sympy import expression
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

ARCS = {
    sympy.sin: (sympy.asin, lambda y: sympy.pi - sympy.asin(y)),
    sympy.cos: (sympy.acos, lambda y: -sympy.acos(y)),
    sympy.tan: (sympy.atan,),
    sympy.asin: (sympy.sin,),
    sympy.acos: (sympy.cos,),
    sympy.atan: (sympy.tan,),
    sympy.exp: (sympy.log,),
    sympy.log: (sympy.exp,),
}
LONGEST = 60  # operations: what is longer than that nobody turns round by hand


@lru_cache(maxsize=4096)
def inverses(formula: Expr, letter: str, value: Expr) -> tuple[Expr, ...]:
    """What the letter may be where the formula comes to `value`: every branch, for it to be seen which one is meant.

    Only what takes no more than the operations undone one by one, or a quadratic equation; else nothing.
    """
    letters = {
        name: sympy.Symbol(name, real=True)
        for name in names(formula) | names(value) | {letter}
        if name != "pi"
    }
    unknown = letters[letter]
    left, right = expression(formula, letters), expression(value, letters)
    if sympy.count_ops(left) > LONGEST:
        return ()
    found: list[Expr] = []
    for root in _undone(left, unknown, right) or _quadratic(left - right, unknown):
        with suppress(NoTree):
            found.append(tree(root))
    return tuple(found)


def _undone(formula: sympy.Expr, unknown: sympy.Symbol, value: sympy.Expr) -> list[sympy.Expr]:
    """The operations on the unknown undone from the outside, where it stands in one place only."""
    if formula == unknown:
        return [value]
    inside = [each for each in formula.args if each.has(unknown)]
    if len(inside) != 1:
        shorter = sympy.factor(formula) if inside else formula
        if shorter != formula and sum(each.has(unknown) for each in shorter.args) == 1:
            return _undone(shorter, unknown, value)
        return []
    (part,) = inside
    others = [each for each in formula.args if each is not part]
    if isinstance(formula, sympy.Add):
        before = [value - sympy.Add(*others)]
    elif isinstance(formula, sympy.Mul):
        before = [value / sympy.Mul(*others)]
    elif isinstance(formula, sympy.Pow) and part is formula.base:
        root = value ** (1 / formula.exp)
        before = [root, -root] if formula.exp.is_Integer and formula.exp % 2 == 0 else [root]
    elif isinstance(formula, sympy.Pow) and formula.base.is_positive:
        before = [sympy.log(value) / sympy.log(formula.base)]
    elif isinstance(formula, sympy.Abs):
        before = [value, -value]
    else:
        before = [arc(value) for arc in ARCS.get(formula.func, ())]
    return [root for each in before for root in _undone(part, unknown, each)]


def _quadratic(residual: sympy.Expr, unknown: sympy.Symbol) -> list[sympy.Expr]:
    top, _bottom = sympy.fraction(sympy.together(residual))
    try:
        polynomial = sympy.Poly(sympy.expand(top), unknown)
    except sympy.PolynomialError:
        return []
    if polynomial.degree() not in (1, 2):
        return []
    c, b, a = (polynomial.coeff_monomial(unknown**power) for power in (0, 1, 2))
    if a == 0:
        return [sympy.factor(-c / b)]
    spread = sympy.sqrt(sympy.factor(b**2 - 4 * a * c))
    return [(-b + spread) / (2 * a), (-b - spread) / (2 * a)]


POINTS = 4  # variants: the chapter's numbers and three more
# one way may leave a root without a value, and only the last tells an angle in its quadrant from one between -90° and 90°
BENT = ((1.031, 0.983, 1.057, 0.961), (0.967, 1.021, 0.949, 1.043), (-1.1, 0.8, 1.2, 0.7))
ALIKE = 1e-9
FAR = 1e-6  # relative: what is so far apart is not the same
Trees = tuple[Expr, ...]
Signature = tuple[tuple[float, ...] | None, ...]


@dataclass(frozen=True, slots=True)
class Spot:
    """The givens of one variant, and the letters found from them."""

    givens: dict[str, RationalPi]
    found: dict[str, float]


class Tried:
    """The spots of one derivation at which formulas are tried; a letter that only a scene gives has no value there."""

    def __init__(self, solution: Solution):
        self.solution = solution
        variants = [chapter(solution.problem), *sample(solution.problem, POINTS - 1, salt="paths")]
        self.spots = [self._spot(variant.exact) for variant in variants]
        self.true = [spot.givens | exact(spot.found) for spot in self.spots]
        self.letters = {find.part: find.names for find in solution.unknowns if find.part}
        self._bent: dict[tuple[tuple[str, ...], str], list[dict[str, RationalPi] | None]] = {}
        self._signatures: dict[tuple[Trees, tuple[str, ...], str], Signature] = {}

    def _spot(self, givens: Mapping[str, RationalPi]) -> Spot:
        found: dict[str, float] = {}
        for find in self.solution.unknowns:
            values = at(find.in_givens, givens) if find.in_givens is not None else None
            if values is not None:
                found |= dict(zip(find.names, values, strict=True))
        return Spot(dict(givens), found)

    def agrees(self, tree: Expr, letter: str) -> bool:
        """Whether the formula gives the letter's true value at every spot."""
        for spot, letters in zip(self.spots, self.true, strict=True):
            values = at((tree,), letters)
            if values is None or (letter not in spot.found and letter not in spot.givens):
                return False
            true = spot.found.get(letter)
            if true is None:
                true = float(spot.givens[letter])
            if abs(values[0] - true) > ALIKE * max(abs(true), abs(values[0])) + 1e-300:
                return False
        return True

    def signature(self, trees: Trees, earlier: Sequence[str], straight: str = "") -> Signature:
        """What the formulas give where the answers to `earlier` parts are bent (but for one): the same for the same function."""
        asked = trees, tuple(earlier), straight
        if asked not in self._signatures:
            self._signatures[asked] = tuple(
                None if letters is None else at(trees, letters) for letters in self._all_bent(*asked[1:])
            )
        return self._signatures[asked]

    def _all_bent(self, earlier: tuple[str, ...], straight: str) -> list[dict[str, RationalPi] | None]:
        """The letters at every spot with every turn of the bent answers."""
        if (earlier, straight) not in self._bent:
            turned = [
                (spot, self.bent(spot, earlier, turn, straight))
                for spot in self.spots
                for turn in range(len(BENT))
            ]
            self._bent[earlier, straight] = [
                None if letters is None else spot.givens | exact(letters) for spot, letters in turned
            ]
        return self._bent[earlier, straight]

    def bent(
        self, spot: Spot, earlier: Collection[str], turn: int, straight: str = ""
    ) -> dict[str, float] | None:
        """The letters of earlier parts with wrong values; None where one has no true value."""
        letters: dict[str, float] = {}
        for place, part in enumerate(earlier):
            names = self.letters[part]
            if any(name not in spot.found for name in names):
                return None
            true = [spot.found[name] for name in names]
            size = math.hypot(*true) or 1.0
            for index, (name, value) in enumerate(zip(names, true, strict=True)):
                factor = 1.0 if part == straight else BENT[turn][(place + index) % len(BENT[turn])]
                letters[name] = value * factor if value else (factor - 1.0) * size
        return letters

    def may_be_in_proportion(self, trees: Collection[Expr], earlier: str) -> bool:
        """False where formulas are seen not to double with the one number that answers an earlier part."""
        if len(self.letters[earlier]) != 1:
            return False
        (letter,) = self.letters[earlier]
        for spot in self.spots:
            if letter not in spot.found:
                continue
            once, twice = (
                at(trees, spot.givens | exact({letter: factor * spot.found[letter]})) for factor in (1.0, 2.0)
            )
            if once is None or twice is None:
                continue
            if any(abs(b - 2 * a) > FAR * (abs(a) + abs(b)) for a, b in zip(once, twice, strict=True)):
                return False
        return True

    def needs(self, trees: Trees, earlier: Sequence[str]) -> frozenset[str]:
        """The givens on which the formulas really depend."""
        before = self.signature(trees, earlier)
        found: set[str] = set()
        for given in self.solution.problem.givens:
            for place, spot in enumerate(self.spots):
                value = float(spot.givens[given.symbol])
                moved = spot.givens | exact({given.symbol: value * 1.013 if value else 0.013})
                letters = self.bent(spot, earlier, 0)
                values = None if letters is None else at(trees, moved | exact(letters))
                if values is not None and not same(values, before[place * len(BENT)]):
                    found.add(given.symbol)
                    break
        return frozenset(found)


def at(trees: Collection[Expr] | None, letters: Mapping[str, RationalPi]) -> tuple[float, ...] | None:
    """The values of formulas; None where one has none."""
    try:
        return None if trees is None else tuple(number(tree, letters) for tree in trees)
    except (Undefined, KeyError):
        return None


def exact(values: Mapping[str, float]) -> dict[str, RationalPi]:
    """Doubles as exact numbers."""
    return {name: as_exact(value) for name, value in values.items()}


def same(left: tuple[float, ...] | None, right: tuple[float, ...] | None) -> bool:
    """Whether both have values, and the same but for rounding."""
    if left is None or right is None or len(left) != len(right):
        return False
    size = max(map(abs, (*left, *right)), default=0.0)
    return all(abs(a - b) <= ALIKE * size for a, b in zip(left, right, strict=True))


NO_LETTERS: Mapping[str, Expr] = {}


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
            for at in {owner[name] for form in trees for name in names(form) if name in owner} - seen:
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
            residual = difference(relation)
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
