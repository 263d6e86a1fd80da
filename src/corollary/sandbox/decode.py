"""Tagged data from a worker, as `worker/encode.py` makes it, checked and turned into values."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, assert_never

import msgspec

from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value

_Hex = Annotated[str, msgspec.Meta(min_length=1, max_length=25_002, pattern=r"^-?[0-9a-f]+$")]
_Words = Annotated[str, msgspec.Meta(max_length=10_000)]
_DEEPEST = 20  # an honest worker refuses what is nested deeper than 12 lists
_Length = Annotated[int, msgspec.Meta(ge=0, le=1 << 40)]


class EncodedNothing(msgspec.Struct, array_like=True, tag="nothing", frozen=True, forbid_unknown_fields=True):
    pass


class EncodedReal(msgspec.Struct, array_like=True, tag="real", frozen=True, forbid_unknown_fields=True):
    value: float


class EncodedExact(msgspec.Struct, array_like=True, tag="exact", frozen=True, forbid_unknown_fields=True):
    numerator: _Hex
    denominator: _Hex


class EncodedComplex(msgspec.Struct, array_like=True, tag="complex", frozen=True, forbid_unknown_fields=True):
    real: float
    imaginary: float


class EncodedText(msgspec.Struct, array_like=True, tag="text", frozen=True, forbid_unknown_fields=True):
    text: _Words


class EncodedMeasured(
    msgspec.Struct, array_like=True, tag="measured", frozen=True, forbid_unknown_fields=True
):
    value: float
    unit: _Words


class EncodedItems(msgspec.Struct, array_like=True, tag="items", frozen=True, forbid_unknown_fields=True):
    items: Annotated[list[Encoded], msgspec.Meta(max_length=20_000)]
    shape: Annotated[list[_Length], msgspec.Meta(max_length=64)]


class EncodedRefused(msgspec.Struct, array_like=True, tag="refused", frozen=True, forbid_unknown_fields=True):
    why: _Words
    shown: _Words


Encoded = (
    EncodedNothing
    | EncodedReal
    | EncodedExact
    | EncodedComplex
    | EncodedText
    | EncodedMeasured
    | EncodedItems
    | EncodedRefused
)


def to_value(encoded: Encoded, depth: int = _DEEPEST) -> Value:
    """What contradicts itself (a zero denominator, a shape of other length) is refused."""
    if depth < 0:
        return Refused("is nested too deeply")
    match encoded:
        case EncodedNothing():
            return Nothing()
        case EncodedReal(value):
            return Real(value)
        case EncodedExact(numerator, denominator):
            below = int(denominator, 16)
            return (
                Exact(Fraction(int(numerator, 16), below))
                if below
                else Refused("is a fraction with denominator zero")
            )
        case EncodedComplex(real, imaginary):
            return Complex(real, imaginary)
        case EncodedText(text):
            return Text(text)
        case EncodedMeasured(value, unit):
            return Measured(value, unit)
        case EncodedItems(items, shape):
            count = 1
            for length in shape:
                count *= length
            if count != len(items):
                return Refused("is an array whose shape does not fit its numbers")
            return Items(tuple(to_value(each, depth - 1) for each in items), tuple(shape))
        case EncodedRefused(why, shown):
            return Refused(why, shown)
        case _:
            assert_never(encoded)
