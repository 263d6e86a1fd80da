"""Tagged data from a worker, as `worker/encode.py` makes it, checked and turned into values."""

from __future__ import annotations

from typing import Annotated

import msgspec

from corollary.formula.value import Value
from corollary.sandbox.tagged import refused, value_of

_Hex = Annotated[str, msgspec.Meta(min_length=1, max_length=25_002, pattern=r"^-?[0-9a-f]+$")]
_Words = Annotated[str, msgspec.Meta(max_length=10_000)]
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


class EncodedNamed(msgspec.Struct, array_like=True, tag="named", frozen=True, forbid_unknown_fields=True):
    names: Annotated[list[Annotated[str, msgspec.Meta(max_length=100)]], msgspec.Meta(max_length=20)]
    items: Annotated[list[Encoded], msgspec.Meta(max_length=20)]


class EncodedRefused(msgspec.Struct, array_like=True, tag="refused", frozen=True, forbid_unknown_fields=True):
    word: _Words
    what: _Words
    excerpt: _Words


Encoded = (
    EncodedNothing
    | EncodedReal
    | EncodedExact
    | EncodedComplex
    | EncodedText
    | EncodedMeasured
    | EncodedItems
    | EncodedNamed
    | EncodedRefused
)


def to_value(encoded: Encoded) -> Value:
    """The value itself; what contradicts itself, or is nested too deeply, is refused."""
    try:
        return value_of(msgspec.to_builtins(encoded))
    except RecursionError:
        return refused("nesting")
