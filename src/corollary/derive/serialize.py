"""A solved derivation as plain data and back: formulas, laws and words, and never a program."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import MISSING, Field, fields, is_dataclass
from fractions import Fraction
from typing import Any

from corollary.derive import solution, statements
from corollary.formula import ast
from corollary.problem import given, part, variable
from corollary.units import dimension
from corollary.units.unit import Unit, unit

TYPES: dict[str, type] = {
    each.__name__: each
    for room in (ast, dimension, given, part, solution, statements, variable)
    for each in vars(room).values()
    if isinstance(each, type) and is_dataclass(each) and each.__module__ == room.__name__
}


View = Mapping[type, Set[str]]
EVERYTHING: View = {}
EMPTY: Mapping[type, Any] = {str: "", int: 0, tuple: (), dict: {}}


class NotSerializable(TypeError):
    """Something that data cannot hold: a function, an expression still to be solved."""


def to_data(value: Any, view: View = EVERYTHING) -> Any:
    """The value as JSON can hold it: each dataclass under its name, with its fields in order. Raises NotSerializable.

    Of a type that the `view` names only the fields are written that stand there; the others are empty.
    """
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
            return [to_data(each, view) for each in whole]
        case frozenset():
            return {"set": list(map(to_data, sorted(whole)))}
        case Mapping():
            return {"table": [[to_data(name, view), to_data(each, view)] for name, each in whole.items()]}
        case _ if TYPES.get(type(value).__name__) is type(value):
            named = view.get(TYPES[type(value).__name__])
            inside = [
                getattr(value, each.name) if named is None or each.name in named else _empty(value, each)
                for each in fields(value)
            ]
            return {type(value).__name__: [to_data(each, view) for each in inside]}
        case _:
            raise NotSerializable(f"{type(value).__name__} cannot be serialized")


def _empty(value: Any, left_out: Field[Any]) -> Any:
    """A field's default, or nothing of the type that it has."""
    if left_out.default is not MISSING:
        return left_out.default
    if left_out.default_factory is not MISSING:
        return left_out.default_factory()
    return EMPTY.get(getattr(value, left_out.name).__class__)


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
