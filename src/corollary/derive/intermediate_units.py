"""Units of intermediate results: the author's, those of the givens, those of the parts, or the SI's."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress

from corollary.derive.solution import ClosedForms, Solution, Unknown
from corollary.formula.ast import names
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.dimension import Dimension
from corollary.units.unit import Unit, si_unit
from corollary.units.unit import unit as unit_of

READABLE = 0.1, 100_000.0  # from where to where a number needs no power of ten
IN_UNIT = re.compile(r"(?P<words>.*\S) (?:in|i) (?P<unit>\S+)$")  # in Norwegian `i`


def words_and_unit(meaning: str, dimension: Dimension) -> tuple[str, Unit | None]:
    """What a letter stands for, and the unit that `radius in km` asks for; None where the last word is no unit that measures it."""
    if found := IN_UNIT.match(meaning):
        with suppress(ValueError):
            stated = unit_of(found["unit"])
            if stated.dimension == dimension and dimension != Dimension():
                return found["words"], stated
    return meaning, None


def units_of(
    find: Unknown, part: Part | None, numbers: tuple[float, ...], solution: Solution
) -> tuple[Unit, ...]:
    """The part's units; where no part asks, for each number the author's, else the first in which it is easy to read."""
    if part:
        return part.units_for(len(find.dimensions))
    return tuple(
        words_and_unit(solution.meanings.get(name, ""), dimension)[1]
        or _readable(find, dimension, value, solution.problem)
        for name, dimension, value in zip(find.names, find.dimensions, numbers, strict=True)
    )


def _readable(find: Unknown, dimension: Dimension, value: float, problem: Problem) -> Unit:
    standard = si_unit(dimension)
    if dimension == Dimension():
        return standard
    low, high = READABLE
    found = (each for each in _candidates(find, dimension, problem) if low <= abs(each.from_si(value)) < high)
    return next(found, standard) if value else standard


def _candidates(find: Unknown, dimension: Dimension, problem: Problem) -> Iterator[Unit]:
    """The units of the dimension among those of the givens in its formula, of other givens, and of the parts."""
    used = names(*find.local.trees) if isinstance(find.local, ClosedForms) else frozenset[str]()
    givens = sorted(problem.givens, key=lambda given: given.symbol not in used)
    for unit in [*(given.unit for given in givens), *(unit for part in problem.parts for unit in part.units)]:
        if unit.offset:
            continue
        if unit.dimension == dimension:
            yield unit
        elif unit.text.isalpha():
            for power in (2, 3):  # cm² for an area where lengths are given in cm
                with suppress(ValueError):
                    raised = unit_of(f"{unit.text}^{power}")
                    if raised.dimension == dimension:
                        yield raised
