"""Formulas tried on numbers: where two are the same, what they depend on, and whether they give what is true."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass

from corollary.answers.evaluation import as_exact, number
from corollary.derive.solution import Solution
from corollary.formula.ast import Expr
from corollary.formula.ball import RationalPi, Undefined
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

POINTS = 4  # variants: the chapter's numbers and three more
# one way may leave a root without a value, and only the last tells an angle in its quadrant from one between -90° and 90°
BENT = ((1.031, 0.983, 1.057, 0.961), (0.967, 1.021, 0.949, 1.043), (-1.1, 0.8, 1.2, 0.7))
ALIKE = 1e-9
FAR = 1e-6  # relative: what is so far apart is not the same
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
        self.letters = {find.part: find.names for find in solution.unknowns if find.part}

    def _spot(self, givens: Mapping[str, RationalPi]) -> Spot:
        found: dict[str, float] = {}
        for find in self.solution.unknowns:
            values = at(find.in_givens, givens) if find.in_givens is not None else None
            if values is not None:
                found |= dict(zip(find.names, values, strict=True))
        return Spot(dict(givens), found)

    def agrees(self, tree: Expr, letter: str) -> bool:
        """Whether the formula gives the letter's true value at every spot."""
        for spot in self.spots:
            values = at((tree,), spot.givens | exact(spot.found))
            if values is None or (letter not in spot.found and letter not in spot.givens):
                return False
            true = spot.found.get(letter)
            if true is None:
                true = float(spot.givens[letter])
            if abs(values[0] - true) > ALIKE * max(abs(true), abs(values[0])) + 1e-300:
                return False
        return True

    def signature(self, trees: Collection[Expr], earlier: Collection[str], straight: str = "") -> Signature:
        """What the formulas give where the answers to `earlier` parts are bent (but for one): the same for the same function."""
        result: list[tuple[float, ...] | None] = []
        for spot in self.spots:
            for turn in range(len(BENT)):
                letters = self.bent(spot, earlier, turn, straight)
                result.append(None if letters is None else at(trees, spot.givens | exact(letters)))
        return tuple(result)

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

    def needs(self, trees: Collection[Expr], earlier: Collection[str]) -> frozenset[str]:
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
