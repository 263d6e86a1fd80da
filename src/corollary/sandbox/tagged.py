"""Tagged data, as `worker/encode.py` gives it, made into plain values; whoever got it from elsewhere has it checked first."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod
from typing import Any

from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value

DEEPEST = 20  # an honest worker refuses what is nested deeper than 12 lists


def value_of(tagged: Sequence[Any], depth: int = DEEPEST) -> Value:
    """The value itself; what contradicts itself (a zero denominator, a shape of other length) is refused."""
    if depth < 0:
        return Refused("is nested too deeply")
    match tagged:
        case ["nothing"]:
            return Nothing()
        case ["real", value]:
            return Real(value)
        case ["exact", numerator, denominator]:
            below = int(denominator, 16)
            return (
                Exact(Fraction(int(numerator, 16), below))
                if below
                else Refused("is a fraction with denominator zero")
            )
        case ["complex", real, imaginary]:
            return Complex(real, imaginary)
        case ["text", text]:
            return Text(text)
        case ["measured", value, unit]:
            return Measured(value, unit)
        case ["items", items, shape]:
            if prod(shape) != len(items):
                return Refused("is an array whose shape does not fit its numbers")
            return Items(tuple(value_of(each, depth - 1) for each in items), tuple(shape))
        case ["refused", why, excerpt]:
            return Refused(why, excerpt)
        case _:
            return Refused("could not be read")
