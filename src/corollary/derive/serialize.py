"""A solved derivation as plain data and back: formulas, laws and words, and never a program."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from typing import Any

from corollary.derive import solution, statements
from corollary.formula import ast
from corollary.problem import given, part
from corollary.units import dimension
from corollary.units.unit import Unit, unit

TYPES: dict[str, type] = {
    each.__name__: each
    for room in (ast, dimension, given, part, solution, statements)
    for each in vars(room).values()
    if isinstance(each, type) and is_dataclass(each) and each.__module__ == room.__name__
}


class NotSerializable(TypeError):
    """Something that data cannot hold: a function, an expression still to be solved."""


def to_data(value: Any) -> Any:
    """The value as JSON can hold it: each dataclass under its name, with its fields in order. Raises NotSerializable."""
    whole = value  # which stays of any type where a case below narrows the value
    match value:
        case None | bool() | int() | str():
            return value
        case float():
            return {"float": value.hex()}
        case Fraction():
            return {"fraction": str(value)}
        case Unit():
            return {"unit": value.text}
        case tuple() | list():
            return list(map(to_data, whole))
        case frozenset():
            return {"set": list(map(to_data, sorted(whole)))}
        case Mapping():
            return {"table": [[to_data(name), to_data(each)] for name, each in whole.items()]}
        case _ if TYPES.get(type(value).__name__) is type(value):
            return {type(value).__name__: [to_data(getattr(value, field.name)) for field in fields(value)]}
        case _:
            raise NotSerializable(f"{type(value).__name__} cannot be serialized")


def from_data(data: Any) -> Any:
    """The value that `to_data` wrote. Raises ValueError, TypeError or KeyError for what it never writes."""
    whole = data
    match data:
        case None | bool() | int() | str():
            return data
        case list():
            return tuple(map(from_data, whole))
        case dict():
            ((name, inside),) = whole.items()
            match name:
                case "float":
                    return float.fromhex(inside)
                case "fraction":
                    return Fraction(inside)
                case "unit":
                    return unit(inside)
                case "set":
                    return frozenset(map(from_data, inside))
                case "table":
                    return {from_data(key): from_data(each) for key, each in inside}
                case _:
                    return TYPES[name](*map(from_data, inside))
        case _:
            raise ValueError(f"{data!r} was not written here")
