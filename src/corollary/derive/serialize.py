"""A solved derivation as plain data and back: formulas, laws and words, and never a program."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from typing import Any

from corollary.derive import solution, statements
from corollary.formula import ast
from corollary.units import unit

NOUNS: dict[str, type] = {
    noun.__name__: noun
    for room in (ast, unit, solution, statements)
    for noun in vars(room).values()
    if isinstance(noun, type) and is_dataclass(noun) and noun.__module__ == room.__name__
}


class NotPlain(TypeError):
    """Something that data cannot hold: a function, an expression still to be solved."""


def plain(value: Any) -> Any:
    """The value as JSON can hold it: each noun under its name, with what it holds in order. Raises NotPlain."""
    match value:
        case None | bool() | int() | str():
            return value
        case float():
            return {"float": value.hex()}
        case Fraction():
            return {"fraction": str(value)}
        case tuple() | list():
            return [plain(each) for each in value]
        case frozenset():
            return {"set": [plain(each) for each in sorted(value)]}
        case Mapping():
            return {"table": [[plain(name), plain(each)] for name, each in value.items()]}
        case _ if NOUNS.get(type(value).__name__) is type(value):
            return {type(value).__name__: [plain(getattr(value, field.name)) for field in fields(value)]}
        case _:
            raise NotPlain(f"{type(value).__name__} is no plain data")


def noun(data: Any) -> Any:
    """The value that `plain` wrote. Raises ValueError, TypeError or KeyError for what it never writes."""
    match data:
        case None | bool() | int() | str():
            return data
        case list():
            return tuple(map(noun, data))
        case dict():
            ((name, inside),) = data.items()
            match name:
                case "float":
                    return float.fromhex(inside)
                case "fraction":
                    return Fraction(inside)
                case "set":
                    return frozenset(map(noun, inside))
                case "table":
                    return {noun(key): noun(each) for key, each in inside}
                case _:
                    return NOUNS[name](*map(noun, inside))
        case _:
            raise ValueError(f"{data!r} was not written here")
