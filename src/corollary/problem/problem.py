"""A problem: statement, givens, conditions among them, and parts; from one Markdown file, and without any truth."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from corollary.formula.ast import Relation
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.variable import Variable


@dataclass(frozen=True, slots=True)
class Condition:
    """A relation among the givens. `hard` ones bound where the physics holds; the others only where numbers are drawn."""

    relation: Relation
    text: str
    hard: bool
    line: int


@dataclass(frozen=True, slots=True)
class Description:
    """What a bank's author says of a problem for other teachers: `difficulty` from 1 (easiest) to 5, 0 when nothing is said."""

    difficulty: int = 0
    tags: tuple[str, ...] = ()
    author: str = ""
    licence: str = ""
    version: str = ""


@dataclass(frozen=True, slots=True)
class Problem:
    """`written` is what its file has today, where this is the problem as it was handed out to somebody; `renamed` are then the
    letters of givens that are called otherwise today: the one of today, and the one of the sheet. `expected` has the answers that
    the author expects, as typed, by part: beside the parts and not in them, for what is made of a part is handed out. `meant` are
    numbers in the words that are the same for everybody, though they look like those of a given. `printed_letters` has the TeX of letters, of
    givens and unknowns, that are not printed by rule. `variables` are the letters that its formulas are asked of."""

    code: str
    name: str
    title: str
    source: str
    topic: str
    statement: str
    givens: tuple[Given, ...]
    conditions: tuple[Condition, ...]
    parts: tuple[Part, ...]
    figure: str
    figure_alt: str
    path: Path
    figure_line: int
    written: Problem | None = None
    renamed: tuple[tuple[str, str], ...] = ()
    description: Description = Description()
    expected: tuple[tuple[str, str], ...] = ()
    meant: tuple[str, ...] = ()
    printed_letters: tuple[tuple[str, str], ...] = ()
    variables: tuple[Variable, ...] = ()

    @property
    def as_written(self) -> Problem:
        """The problem as its file has it: itself, but for one that is as it was once handed out."""
        return self.written or self

    @property
    def letters(self) -> tuple[Given | Variable, ...]:
        """What stands for itself in formulas: the givens, and the variables."""
        return (*self.givens, *self.variables)

    def given(self, symbol: str) -> Given:
        return next(given for given in self.givens if given.symbol == symbol)

    def asks_of_variable(self, part_id: str) -> bool:
        """True if a part asks for a formula of a variable, so that no number answers it."""
        return any(part.of for part in self.parts if part.id == part_id)

    def part(self, part_id: str) -> Part:
        return next(part for part in self.parts if part.id == part_id)

    @property
    def prefix(self) -> str:
        """The code as part of a Python name: X12.5 becomes X12_5."""
        return _as_name(self.code)

    def answer_name(self, part: Part) -> str:
        """What records, cells and gradebooks call the answer to a part: by its id."""
        return f"{self.prefix}_{part.label}"

    def variable(self, part: Part) -> str:
        """The variable a student assigns the answer to: by the letter that the heading above it shows."""
        return f"{self.prefix}_{part.heading_letter}"


@lru_cache(maxsize=1024)
def _as_name(code: str) -> str:
    return "".join(letter if letter.isalnum() else "_" for letter in code)
