"""Quantities with a direction, and whether turning some of them round makes another answer right."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import combinations

from corollary.audit.contractor import periodic_arguments
from corollary.audit.exercise import AdmittedRoot, PublishedExercise
from corollary.formula.ast import Relation, names
from corollary.formula.ball import RationalPi, certified
from corollary.formula.errors import Undefined
from corollary.units.unit import ONE, UNITS

UNDIRECTED = tuple(UNITS[each].dimension for each in ("kg", "s", "K", "mol", "ohm", "F", "H"))
MOST_TURNED = 10  # letters: of more it is not tried which are turned round together
SAME = 1e-9  # relative


def reversible(exercise: PublishedExercise, root: AdmittedRoot, letter: str) -> bool:
    """Whether a letter's sign is a matter of direction: with the opposite one the laws hold, some others being turned round, too.

    `s = abs(v)` has no minus, whichever direction is positive.
    """
    directed = _directed(exercise)
    if letter not in directed:
        return False
    others = sorted(directed & root.values.keys() - {letter})
    if len(others) > MOST_TURNED:
        return True
    values = {name: RationalPi(Fraction(value)) for name, value in root.values.items()} | exercise.numbers
    for count in range(len(others) + 1):
        for turned in combinations(others, count):
            opposite = {name: RationalPi(-values[name].ratio, values[name].pi) for name in (letter, *turned)}
            if all(_holds(each, values | opposite) for each in exercise.equations):
                return True
    return False


def _directed(exercise: PublishedExercise) -> set[str]:
    """The letters that may have a direction: no mass, time, temperature or resistance, and of plain numbers the angles alone."""
    angles = {name for name, given in exercise.givens.items() if given.unit.pi}
    angles |= {each.letter for each in exercise.record.asked if each.unit is not None and each.unit.pi}
    for equation in exercise.equations:
        for argument in periodic_arguments(equation, [*exercise.unknowns, *exercise.givens]):
            angles |= names(argument)
    dimensions = {name: given.unit.dimension for name, given in exercise.givens.items()}
    dimensions |= dict(exercise.dimensions)
    return {
        name
        for name, dimension in dimensions.items()
        if dimension not in UNDIRECTED and (dimension != ONE or name in angles)
    }


def _holds(equation: Relation, values: Mapping[str, RationalPi]) -> bool:
    try:
        left, right = (certified(side, values).value for side in (equation.left, equation.right))
    except (Undefined, KeyError):
        return False
    return abs(left - right) <= SAME * max(abs(left), abs(right))
