"""Students' values outside the student's process: closed, inert data."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Nothing:
    """No answer: `None`, or the name was never assigned."""


@dataclass(frozen=True, slots=True)
class Real:
    """A machine number (float, numpy scalar); may be nan or inf."""

    value: float


@dataclass(frozen=True, slots=True)
class Exact:
    """An exact number (int, Fraction, Decimal, sympy Rational)."""

    value: Fraction


@dataclass(frozen=True, slots=True)
class Complex:
    real: float
    imaginary: float


@dataclass(frozen=True, slots=True)
class Text:
    """What the student typed, as a string."""

    text: str


@dataclass(frozen=True, slots=True)
class Measured:
    """A number that carries a unit of its own (a pint quantity): the unit in words."""

    value: float
    unit: str


@dataclass(frozen=True, slots=True)
class Items:
    """A list, tuple or array, with its shape for arrays (row-major order of the items)."""

    items: tuple[Value, ...]
    shape: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Named:
    """A dictionary: a value for each of its names."""

    names: tuple[str, ...]
    items: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class Refused:
    """A value no answer can be read from; `why` is a predicate (`is a set`), `excerpt` a short picture of it."""

    why: str
    excerpt: str = ""


Value = Nothing | Real | Exact | Complex | Text | Measured | Items | Named | Refused
