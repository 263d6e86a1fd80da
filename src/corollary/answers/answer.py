"""What a student's answer is once it has been read: one of a few inert forms, or a sentence on why it could not be."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.formula.ast import Expr, Relation


@dataclass(frozen=True, slots=True)
class Numbers:
    """Values in SI, one for each component; `figures` as written (0: a machine number with many digits).

    `missing` is a sentence when a unit was needed and none was written; the values then take the part's unit. `misfit` is
    one when the unit measures something else than was asked for. `in_words`: the sign comes from a direction in words.
    `sizes` are the SI values of the units the numbers were written in (the part's own unit where there are none).
    `polar` are the length and the angle of a vector that was written so: its components have no figures of their own.
    """

    values: tuple[float, ...]
    figures: tuple[int, ...]
    as_read: str
    missing: str = ""
    misfit: str = ""
    in_words: bool = False
    sizes: tuple[float, ...] = ()
    polar: tuple[Numbers, Numbers] | None = None


@dataclass(frozen=True, slots=True)
class Formulas:
    """One formula for each component, in the symbols of the problem."""

    trees: tuple[Expr, ...]
    as_read: str


@dataclass(frozen=True, slots=True)
class Letter:
    """The option chosen."""

    letter: str
    as_read: str


@dataclass(frozen=True, slots=True)
class Chain:
    """Equations, one a line."""

    lines: tuple[Relation, ...]
    as_read: str


@dataclass(frozen=True, slots=True)
class Prose:
    """Words for a person to read."""

    text: str

    @property
    def as_read(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Blank:
    """Nothing was handed in."""

    as_read: str = ""


@dataclass(frozen=True, slots=True)
class Unclear:
    """An attempt that cannot be read; `why` says what was met and how to write it.

    `readings` are what it could mean when it has several meanings (1,234 is 1.234 or 1234): never guessed among, but a person
    is asked where one of them is right.
    """

    why: str
    as_read: str
    readings: tuple[Numbers | Formulas, ...] = ()


Answer = Numbers | Formulas | Letter | Chain | Prose | Blank | Unclear
