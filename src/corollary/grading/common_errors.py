"""The generic slips: sign, factor, power of ten, units, degrees for radians, sine for cosine, g = 10."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from corollary.derive.solution import ClosedForms, Rule
from corollary.formula.ast import Call, Expr, children, rebuilt
from corollary.formula.ball import RationalPi, Undefined
from corollary.grading.follow_through import Carried
from corollary.grading.key import Key, Truth
from corollary.grading.replay import Values, WhatIf, replay
from corollary.problem.given import Given
from corollary.problem.variant import Variant
from corollary.units.unit import Dimension, Unit

TEN = "The power of ten is off (by a factor of {}); check prefixes such as g and kg, ms and s."
KMH = "A factor of 3.6 too {}: km/h and m/s have been mixed."
FACTORS = (
    (2.0, "A factor of 2 too large."),
    (0.5, "A factor of 2 too small."),
    *(
        (10.0**n, TEN.format(str(10**n) if n > 0 else f"1/{10**-n}"))
        for n in (1, -1, 2, -2, 3, -3, 4, -4, 6, -6)
    ),
    (3.6, KMH.format("large")),
    (1 / 3.6, KMH.format("small")),
)
SIGN = "The sign is wrong: check which direction is positive."
SIGNS = "Every component has the wrong sign: check which way the axes point, or what acts on what."
SPEED = Dimension(Fraction(0), Fraction(1), Fraction(-1))


def slipped(key: Key, truth: Truth, base: Carried, unit: Unit) -> Iterator[tuple[Values, str]]:
    """What the part's value becomes by each generic slip, and what the student is told."""
    values = base.values
    if any(values):
        yield tuple(-x for x in values), SIGN if len(values) == 1 else SIGNS
    if len(values) > 1:
        for place, value in enumerate(values):
            if value:
                yield (*values[:place], -value, *values[place + 1 :]), "The sign of one component is wrong."
        if len(values) == 2 and values[0] != values[1]:
            yield (values[1], values[0]), "The two components have changed places."
    if unit.dimension == Dimension():
        yield (
            tuple(math.degrees(x) for x in values),
            "That looks like degrees where radians are asked for; write the unit, as in 30 deg.",
        )
        yield tuple(math.radians(x) for x in values), "That looks like radians written as degrees."
    for factor, said in FACTORS:
        if any(values):
            yield tuple(factor * x for x in values), said
    yield from _replayed(key, truth, base)


def _replayed(key: Key, truth: Truth, base: Carried) -> Iterator[tuple[Values, str]]:
    """Slips in what goes into the formulas."""
    givens, variant = key.variant.exact, key.variant
    if "g" in givens and givens["g"].ratio in (Fraction("9.8"), Fraction("9.81")):
        yield from _with(
            key,
            truth,
            base.deviation,
            givens | {"g": RationalPi(Fraction(10))},
            "You calculated with g = 10 m/s²; the problem gives a closer value.",
        )
    for given in variant.problem.givens:
        if given.unit.pi or given.unit.factor != 1:
            bare = RationalPi(givens[given.symbol].ratio / given.unit.factor)
            yield from _with(key, truth, base.deviation, givens | {given.symbol: bare}, _unconverted(given))
    if any(_angle(variant, given.symbol) for given in variant.problem.givens):
        swapped: dict[int, Rule] = {
            place: ClosedForms(tuple(map(_swapped, find.local.trees)))
            for place, find in enumerate(key.solution.finds)
            if isinstance(find.local, ClosedForms)
        }
        deviation = WhatIf(base.deviation.held, swapped | dict(base.deviation.rules))
        yield from _with(
            key,
            truth,
            deviation,
            givens,
            "Sine and cosine have changed places: check from where the angle is measured.",
        )


def _unconverted(given: Given) -> str:
    """What is said where the bare number of a given was put in."""
    if given.unit.pi:
        return "Your calculator took the angle for radians; it is given in degrees."
    if given.unit.dimension == SPEED:
        return f"{given.symbol} was put in as if it were in m/s; convert km/h first."
    return f"{given.symbol} was put in without converting its unit to SI."


def _with(key: Key, truth: Truth, deviation: WhatIf, givens, said: str) -> Iterator[tuple[Values, str]]:
    try:
        yield replay(key.solution, givens, deviation, truth.place)[truth.place], said
    except Undefined:
        return


def _angle(variant: Variant, symbol: str) -> bool:
    return bool(variant.problem.given(symbol).unit.pi) or variant.problem.given(symbol).unit.text == "rad"


def _swapped(tree: Expr) -> Expr:
    """The formula with sine and cosine exchanged."""
    if isinstance(tree, Call) and tree.function in {"sin", "cos"}:
        return Call("cos" if tree.function == "sin" else "sin", tuple(map(_swapped, tree.arguments)))
    return rebuilt(tree, tuple(map(_swapped, children(tree))))
