"""The trusted side of the door: tagged data from a student's process, checked and turned into plain values."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, assert_never

import msgspec

from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value

_Hex = Annotated[str, msgspec.Meta(min_length=1, max_length=25_002, pattern=r"^-?[0-9a-f]+$")]
_Words = Annotated[str, msgspec.Meta(max_length=10_000)]
_Length = Annotated[int, msgspec.Meta(ge=0, le=1 << 40)]


class SentNothing(msgspec.Struct, array_like=True, tag="nothing", frozen=True, forbid_unknown_fields=True):
    pass


class SentReal(msgspec.Struct, array_like=True, tag="real", frozen=True, forbid_unknown_fields=True):
    value: float


class SentExact(msgspec.Struct, array_like=True, tag="exact", frozen=True, forbid_unknown_fields=True):
    numerator: _Hex
    denominator: _Hex


class SentComplex(msgspec.Struct, array_like=True, tag="complex", frozen=True, forbid_unknown_fields=True):
    real: float
    imaginary: float


class SentText(msgspec.Struct, array_like=True, tag="text", frozen=True, forbid_unknown_fields=True):
    text: _Words


class SentMeasured(msgspec.Struct, array_like=True, tag="measured", frozen=True, forbid_unknown_fields=True):
    value: float
    unit: _Words


class SentItems(msgspec.Struct, array_like=True, tag="items", frozen=True, forbid_unknown_fields=True):
    items: Annotated[list[Sent], msgspec.Meta(max_length=20_000)]
    shape: Annotated[list[_Length], msgspec.Meta(max_length=64)]


class SentRefused(msgspec.Struct, array_like=True, tag="refused", frozen=True, forbid_unknown_fields=True):
    why: _Words
    shown: _Words


Sent = SentNothing | SentReal | SentExact | SentComplex | SentText | SentMeasured | SentItems | SentRefused


def plain(sent: Sent) -> Value:
    """The value itself; what contradicts itself (a zero denominator, a shape of other length) is refused."""
    match sent:
        case SentNothing():
            return Nothing()
        case SentReal(value):
            return Real(value)
        case SentExact(numerator, denominator):
            below = int(denominator, 16)
            return (
                Exact(Fraction(int(numerator, 16), below))
                if below
                else Refused("is a fraction with denominator zero")
            )
        case SentComplex(real, imaginary):
            return Complex(real, imaginary)
        case SentText(text):
            return Text(text)
        case SentMeasured(value, unit):
            return Measured(value, unit)
        case SentItems(items, shape):
            count = 1
            for length in shape:
                count *= length
            if count != len(items):
                return Refused("is an array whose shape does not fit its numbers")
            return Items(tuple(plain(each) for each in items), tuple(shape))
        case SentRefused(why, shown):
            return Refused(why, shown)
        case _:
            assert_never(sent)


def read_plain(encoded: object) -> Value:
    """Reads what `worker/encode.py` gave in this very process (the check a student runs at home)."""
    try:
        return plain(msgspec.convert(encoded, Sent))
    except (msgspec.ValidationError, RecursionError):
        return Refused("could not be read")
