"""Tagged data, as `worker/encode.py` gives it, made into plain values; whoever got it from elsewhere has it checked first."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod
from typing import Any

from corollary.formula.value import (
    Complex,
    Exact,
    Items,
    Measured,
    Named,
    Nothing,
    Real,
    Text,
    Value,
)
from corollary.sandbox.refusals import refused

DEEPEST = 20  # an honest worker refuses what is nested deeper than 12 lists


def value_of(tagged: Sequence[Any], depth: int = DEEPEST) -> Value:
    """The value itself; what contradicts itself (a zero denominator, a shape of other length) is refused."""
    if depth < 0:
        return refused("nesting")
    match tagged:
        case ["nothing"]:
            return Nothing()
        case ["real", value]:
            return Real(value)
        case ["exact", numerator, denominator]:
            below = int(denominator, 16)
            return Exact(Fraction(int(numerator, 16), below)) if below else refused("denominator")
        case ["complex", real, imaginary]:
            return Complex(real, imaginary)
        case ["text", text]:
            return Text(text)
        case ["measured", value, unit]:
            return Measured(value, unit)
        case ["items", items, shape]:
            if prod(shape) != len(items):
                return refused("shape")
            return Items(tuple(value_of(each, depth - 1) for each in items), tuple(shape))
        case ["named", names, items]:
            if len(names) != len(items):
                return refused("names")
            return Named(tuple(names), tuple(value_of(each, depth - 1) for each in items))
        case ["refused", word, what, excerpt]:
            return refused(word, what, excerpt)
        case _:
            return refused("unknown")
