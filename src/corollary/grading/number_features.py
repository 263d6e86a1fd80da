"""Features of the numbers that a student drew: what may make one variant harder than another."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Final

from corollary.formula.ast import names
from corollary.grading.key import Key, Truth
from corollary.problem.part import Part

FIGURES, CANCELLATION, SIZE, NEGATIVE = "figures", "cancellation", "size", "negative"
LEAST_NOISE: Final = 1e-9


def number_features(key: Key) -> dict[str, dict[str, float]]:
    """Of each part asked that asks for a quantity, by the part's name: `figures`, how many figures the givens in its formula have
    together; `cancellation`, log₁₀ of how far honest rounding moves the answer (relative); `size`, log₁₀ of the answer in its
    unit, left out of an answer that is zero; `negative`, 1 where a component is below zero, else 0."""
    parts = {part.id: part for part in key.variant.problem.parts}
    return {
        name: dict(_features(key, parts[name], truth))
        for name, truth in key.truths.items()
        if name in parts and not parts[name].of
    }


def _features(key: Key, part: Part, truth: Truth) -> list[tuple[str, float]]:
    values = key.variant.values
    trees = key.find(truth).in_givens or ()
    used = names(*trees) & values.keys() or values.keys()
    in_unit = [float(part.unit.from_si(value)) for value in truth.values]
    largest = max(map(abs, in_unit))
    found = [
        (FIGURES, float(sum(_figures(values[name]) for name in used))),
        (CANCELLATION, math.log10(max(truth.noise, LEAST_NOISE))),
        (NEGATIVE, float(min(in_unit) < 0)),
    ]
    if largest > 0 and math.isfinite(largest):
        found.append((SIZE, math.log10(largest)))
    return found


def _figures(value: Fraction) -> int:
    """From the first to the last digit that is not zero; a number that no decimal writes has as many as its ratio."""
    if not value:
        return 1
    places = 0
    while value.denominator != 1 and places < 12:
        value, places = value * 10, places + 1
    return len(str(abs(round(value))).rstrip("0"))
