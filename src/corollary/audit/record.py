"""A record: an exercise as it was published, and the laws that hold in it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from corollary.formula.ast import names
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.problem.variant import with_unit
from corollary.units.unit import Unit

MOST_RECORDS = 20_000  # of one file


@dataclass(frozen=True, slots=True)
class StatedGiven:
    """What a statement gives: `low` and `high` in its unit, the same for a number, None where only the unit is known.

    `figures` are those it is written with (0: exact).
    """

    symbol: str
    unit: Unit
    low: Fraction | None
    high: Fraction | None
    figures: int = 0

    @property
    def fixed(self) -> bool:
        return self.low is not None and self.low == self.high

    @property
    def text(self) -> str:
        """As people read it: `2 kg`, `2..5 kg`, `kg`."""
        numbers = [decimal_text(each, 0) for each in (self.low, self.high) if each is not None]
        return (
            with_unit("..".join(dict.fromkeys(numbers)), self.unit).replace("\N{NO-BREAK SPACE}", " ").strip()
        )


@dataclass(frozen=True, slots=True)
class AssumedValue:
    """What a letter is by convention, in its unit: the first value is the source's, the others are usual, too."""

    symbol: str
    unit: Unit
    values: tuple[Fraction, ...]

    def given(self, value: Fraction) -> StatedGiven:
        return StatedGiven(self.symbol, self.unit, value, value)


@dataclass(frozen=True, slots=True)
class LawText:
    """A law as it is written, and its name: the text itself where it has none."""

    name: str
    formula: str
    line: int


@dataclass(frozen=True, slots=True)
class WrongLaw:
    """A law that somebody may have used, what is wrong with it, and the name of the law it takes the place of ("": by its left side)."""

    says: str
    formula: str
    instead: str
    line: int


@dataclass(frozen=True, slots=True)
class AskedLetter:
    """What is asked: a letter of the laws, or a part of a problem; and the unit in which a bare number is meant."""

    letter: str
    unit: Unit | None


def overridden(stated: StatedGiven, drawn: str) -> str:
    """That a number in the file of laws was used for one that a question draws."""
    return f"{stated.symbol} = {stated.text} is from the laws' file, and the question draws {drawn}"


@dataclass(frozen=True, slots=True)
class ForgivenError:
    """How far a right answer may be off the key: a share of it, and an absolute part in the unit of the answer."""

    relative: float
    absolute: float

    def refuses(self, answer: float, key: float) -> bool:
        """In the unit of the answer."""
        noise = 1e-12 * abs(key)  # of units converted
        return abs(answer - key) > (self.relative * abs(key) + self.absolute) * (1 + 1e-9) + noise


@dataclass(frozen=True, slots=True)
class ExerciseRecord:
    """`published` has one text for each thing asked. `directions`: a convention settles what is positive.

    `unread` says why a reader could not make out the exercise; then nothing else counts. Of a program that was read, `worked_out`
    are the letters that it works out itself, `key_unit` is the unit behind its formula, if any. `isolation` says how well the
    program was isolated that drew its numbers; "" where none was run. `note` is said with every finding. `forgives` has for each
    thing asked how far an answer may be off in the question, where that is known.
    """

    id: str
    path: Path
    line: int
    given: tuple[StatedGiven, ...] = ()
    laws: tuple[LawText, ...] = ()
    where: tuple[str, ...] = ()
    asked: tuple[AskedLetter, ...] = ()
    published: tuple[str, ...] = ()
    assumed: tuple[AssumedValue, ...] = ()
    directions: bool = False
    figures: int | None = None
    mistakes: tuple[WrongLaw, ...] = ()
    constants: tuple[str, ...] = ()
    problem: str = ""
    source: str = ""
    address: str = ""
    licence: str = ""
    statement: str = ""
    unread: str = ""
    worked_out: frozenset[str] = frozenset()
    key_unit: str = ""
    isolation: str = ""
    note: str = ""
    forgives: tuple[ForgivenError | None, ...] = ()

    @property
    def assumed_here(self) -> tuple[AssumedValue, ...]:
        """What is assumed of letters that the laws have."""
        used = {letter for law in self.laws for letter in names(author_formula(law.formula))}
        return tuple(each for each in self.assumed if each.symbol in used)

    @property
    def place(self) -> str:
        return f"{self.path.name}:{self.line}"
