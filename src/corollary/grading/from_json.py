"""Answers as they come in JSON or from an author's hand, made into what a student's process would hand out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import cast

from corollary.formula.value import Exact, Items, Named, Nothing, Real, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)


def from_json(answer: object) -> Value:
    """A JSON value (or None, number, text, list or object of these) as inert data."""
    match answer:
        case None:
            return Nothing()
        case bool():
            return Refused(_("is true or false, not a number"), str(answer))
        case int():
            return Exact(Fraction(answer))
        case Fraction():
            return Exact(answer)
        case float():
            return Real(answer)
        case str():
            return Text(answer)
        case list() | tuple():
            items = tuple(map(from_json, cast("Sequence[object]", answer)))
            shapes = {item.shape for item in items if isinstance(item, Items)}
            inner = (
                shapes.pop() if len(shapes) == 1 and all(isinstance(item, Items) for item in items) else ()
            )
            return Items(items, (len(items), *inner))
        case dict() if answer:
            named = cast("dict[str, object]", answer)
            return Named(tuple(map(str, named)), tuple(map(from_json, named.values())))
        case _:
            return Refused(_("has a type that no answer can have"), type(answer).__name__)


def finite(value: float) -> float | str:
    """A number for JSON: beyond the doubles it is a word."""
    if math.isnan(value):
        return "nan"
    return value if math.isfinite(value) else "inf" if value > 0 else "-inf"
