"""A student's answer after reading: one of a few inert forms, or a sentence on why it has none."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.formula.ast import Expr, Name, Relation


@dataclass(frozen=True, slots=True)
class Numbers:
    """Values in SI, one for each component; `figures` as written (0: a machine number with many digits).

    `missing` says, when a unit was needed and none was written, in which unit the values are taken: the part's. `misfit` is
    a sentence when the unit measures something else than was asked for. `in_words` are the components whose sign comes from words.
    `most` are the figures that may have been typed where that is more than is shown: a machine number loses zeros at its end.
    `sizes` are the SI values of the units the numbers were written in (the part's own unit where there are none), `zeros` where
    these units begin (0 but for °C and °F; the part's own where there are none).
    `beside` are formulas of the givens on the left of the number, which must come to it: `m*v` of `m*v = 8.6`.
    `open_words` stand beside the number and may make it the value of something else; `turning_words` may be its sign.
    `polar` are the length and the angle of a vector that was written so: its components have no figures of their own.
    """

    values: tuple[float, ...]
    figures: tuple[int, ...]
    as_read: str
    missing: str = ""
    misfit: str = ""
    in_words: tuple[int, ...] = ()
    most: tuple[int, ...] = ()
    sizes: tuple[float, ...] = ()
    polar: tuple[Numbers, Numbers] | None = None
    beside: tuple[Expr, ...] = ()
    zeros: tuple[float, ...] = ()
    open_words: str = ""
    turning_words: str = ""


@dataclass(frozen=True, slots=True)
class Formulas:
    """One formula for each component, in the symbols of the problem."""

    trees: tuple[Expr, ...]
    as_read: str


@dataclass(frozen=True, slots=True)
class Entries:
    """The entries of a table, row by row, each read on its own."""

    entries: tuple[Numbers | Formulas | Blank | Unclear, ...]
    as_read: str


@dataclass(frozen=True, slots=True)
class Letter:
    """The option chosen."""

    letter: str
    as_read: str


@dataclass(frozen=True, slots=True)
class DirectedForce:
    """A force on a body: the letter of its name among the options, and a direction in a word or (else `way` is empty) as an angle."""

    letter: str
    way: str
    angle: Numbers | Formulas | None
    as_read: str


@dataclass(frozen=True, slots=True)
class NamedForces:
    """The forces on a body."""

    pulls: tuple[DirectedForce, ...]
    as_read: str


@dataclass(frozen=True, slots=True)
class Equation:
    """One equation of a derivation, and the line it stands on, from 1.

    `defines` is the student's own letter that it gives a meaning to, `undefined` one that no line does. `otherwise` is what it says if `m/L(a + b)` is to be
    read with the bracket below the line.
    """

    relation: Relation
    line: int
    defines: str = ""
    otherwise: Relation | None = None
    undefined: str = ""

    @property
    def meaning(self) -> Expr:
        """What the letter it defines stands for."""
        left, right = self.relation.left, self.relation.right
        return right if left == Name(self.defines) else left


@dataclass(frozen=True, slots=True)
class Chain:
    """Equations, one after the other."""

    steps: tuple[Equation, ...]
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

    `readings` are what it could mean when it has several meanings: never guessed among, but where one of them is right a
    person is asked. `benefit`: they are so far apart (1,234 is 1.234 or 1234) that the right one is the one meant.
    `sign_alone`: they differ in their sign, and words that name no direction leave it open.
    `near` are the words of a list that are nearly written: where one of them is right a person is asked, too.
    """

    why: str
    as_read: str
    readings: tuple[Numbers | Formulas | Letter, ...] = ()
    benefit: bool = False
    near: tuple[Letter, ...] = ()
    sign_alone: bool = False


Answer = Numbers | Formulas | Entries | Letter | NamedForces | Chain | Prose | Blank | Unclear
