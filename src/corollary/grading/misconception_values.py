"""Values of a part under a known misconception, or a slip in what goes into the formulas."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Rule
from corollary.formula.ast import Call, Expr, children, rebuilt, substitute
from corollary.formula.ball import RationalPi, Undefined
from corollary.grading.key import Key, Truth
from corollary.grading.replay import WhatIf, ancestors, without_noise
from corollary.messages import catalogue
from corollary.problem.given import Given
from corollary.problem.variant import Variant
from corollary.units.unit import Dimension

_ = catalogue(__name__)

SPEED = Dimension(Fraction(0), Fraction(1), Fraction(-1))
USUAL_GRAVITY = (Fraction("9.8"), Fraction("9.81"))


def wrong_values(key: Key, truth: Truth, base: WhatIf) -> Iterator[tuple[Values, str]]:
    """What each misconception makes of the part: at its own step, and at those before it whose values are not held."""
    solution = key.solution
    for place in sorted(ancestors(solution, truth.place) | {truth.place}, reverse=True):
        if place in base.held:
            continue
        for mistake in solution.unknowns[place].mistakes:
            what_if = WhatIf(base.held, {**base.rules, place: mistake.rule})
            yield from _replayed(key, truth, what_if, key.variant.exact, mistake.text)


def wrong_formulas(key: Key, place: int) -> Iterator[tuple[tuple[Expr, ...], str]]:
    """Closed forms of an unknown by each misconception, at its own step and at those it is made of."""
    for at in sorted(ancestors(key.solution, place) | {place}, reverse=True):
        for mistake in key.solution.unknowns[at].mistakes:
            in_givens = _in_givens(key, place, at, mistake.rule)
            if in_givens is not None:
                yield in_givens, mistake.text


def slips_of_input(key: Key, truth: Truth, base: WhatIf) -> Iterator[tuple[Values, str]]:
    """What slips in the numbers put in make of the part: g = 10, a unit not converted, sine for cosine."""
    givens, variant = key.variant.exact, key.variant
    if "g" in givens and givens["g"].ratio in USUAL_GRAVITY:
        changed = {**givens, "g": RationalPi(Fraction(10))}
        sentence = _("You calculated with g = 10 m/s²; the problem gives a closer value.")
        yield from _replayed(key, truth, base, changed, sentence)
    for given in variant.problem.givens:
        if not given.unit.bare:
            bare = RationalPi(variant.values[given.symbol])
            yield from _replayed(key, truth, base, {**givens, given.symbol: bare}, _unconverted(given))
    if any(_is_angle(variant, given.symbol) for given in variant.problem.givens):
        swapped: dict[int, Rule] = {
            place: ClosedForms(tuple(map(_swapped, find.local.trees)))
            for place, find in enumerate(key.solution.unknowns)
            if isinstance(find.local, ClosedForms)
        }
        what_if = WhatIf(base.held, swapped | dict(base.rules))
        sentence = _("Sine and cosine have changed places: check from where the angle is measured.")
        yield from _replayed(key, truth, what_if, givens, sentence)


def _replayed(
    key: Key, truth: Truth, what_if: WhatIf, givens: Mapping[str, RationalPi], sentence: str
) -> Iterator[tuple[Values, str]]:
    try:
        yield without_noise(key.solution, givens, what_if, truth.place, truth.scale), sentence
    except Undefined:
        return


def _in_givens(key: Key, place: int, at: int, rule: Rule) -> tuple[Expr, ...] | None:
    """The unknown at `place` in givens alone, when the rule at `at` is exchanged; None where a scene is on the way."""
    meaning: dict[str, Expr] = {}
    for index, find in enumerate(key.solution.unknowns[: place + 1]):
        local = rule if index == at else find.local
        if not isinstance(local, ClosedForms):
            return None
        trees = tuple(substitute(tree, meaning) for tree in local.trees)
        if index == place:
            return trees
        meaning |= dict(zip(find.names, trees, strict=True))
    return None


def _unconverted(given: Given) -> str:
    """What the student reads where the bare number of a given was put in."""
    if given.unit.pi and given.unit.dimension == Dimension():
        return _("Your calculator took the angle for radians; it is given in degrees.")
    if given.unit.dimension == SPEED:
        return _("{symbol} was put in as if it were in m/s; convert km/h first.", symbol=given.symbol)
    return _("{symbol} was put in without converting its unit to SI.", symbol=given.symbol)


def _is_angle(variant: Variant, symbol: str) -> bool:
    unit = variant.problem.given(symbol).unit
    return (bool(unit.pi) and unit.dimension == Dimension()) or unit.text == "rad"


def _swapped(tree: Expr) -> Expr:
    """The formula with sine and cosine exchanged."""
    if isinstance(tree, Call) and tree.function in {"sin", "cos"}:
        return Call("cos" if tree.function == "sin" else "sin", tuple(map(_swapped, tree.arguments)))
    return rebuilt(tree, tuple(map(_swapped, children(tree))))
