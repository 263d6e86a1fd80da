"""One thing asked: its answer type, its unit, its points, and the words around it."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.units.unit import Unit, canonical


@dataclass(frozen=True, slots=True)
class Option:
    """One alternative of a choice: the letter a student gives, and its text."""

    letter: str
    text: str

    @property
    def mark(self) -> str:
        """How the letter is printed: a capital, for parts have small ones."""
        return self.letter.upper()


@dataclass(frozen=True, slots=True)
class Part:
    """`answer_types` names its answer type, or `code` and `plot` together; `components` names what a list answer holds, in order;
    `asked_as` is the id it was handed out with, where it has been given another since; `letters` has for each letter of the options
    it was handed out with the one of today, where these were changed since (empty: it has none); `lettered` is what its heading says in place of the id;
    `slope` is the angle of the slope, a formula of the givens, that the directions of forces are told by;
    `rows` and `columns` are the labels of a table, whose entries are the components, row by row, and `column_units` the units of
    its columns, where they are not all the same; `tolerance` is the share that answers may be off besides rounding (0: none of
    the author's own) and `because` why; `plausible` is from where to where answers may lie, in the unit of the part; `hint` is what
    the author tells whoever practises and asks for one; `given` are equations that the question states, which a derivation may use;
    `of` are the variables that its formula is asked of.

    Whether there is such a type, and the rest fits it, is checked where answer types are known (`answers.questions`).
    """

    id: str
    title: str
    text: str
    answer_types: tuple[str, ...]
    unit: Unit
    points: float
    components: tuple[str, ...]
    options: tuple[Option, ...]
    signature: str
    line: int
    asked_as: str = ""
    letters: tuple[tuple[str, str], ...] = ()
    lettered: str = ""
    slope: str = ""
    rows: tuple[str, ...] = ()
    columns: tuple[str, ...] = ()
    column_units: tuple[Unit, ...] = ()
    tolerance: float = 0.0
    because: str = ""
    plausible: tuple[float, ...] = ()
    hint: str = ""
    given: str = ""
    of: tuple[str, ...] = ()

    @property
    def units(self) -> tuple[Unit, ...]:
        """The unit of each component; one unit where there are none."""
        if self.column_units:
            return self.column_units * len(self.rows)
        return (self.unit,) * max(1, len(self.components))

    def units_for(self, count: int) -> tuple[Unit, ...]:
        """The units of so many numbers: of the components, or of one that is about all of them."""
        return self.units if len(self.units) == count else (self.unit,) * count

    @property
    def units_text(self) -> str:
        """The unit as the heading names it; of a table whose columns have units of their own, all of them."""
        return ", ".join(map(canonical, self.column_units)) or canonical(self.unit)

    @property
    def label(self) -> str:
        """The id that students know it by."""
        return self.asked_as or self.id

    def letter_asked(self, today: str) -> str:
        """The letter that today's option has on the sheet; empty where the sheet does not have it."""
        return next((asked for asked, now in self.letters if now == today), "") if self.letters else today

    @property
    def heading_letter(self) -> str:
        """What stands in brackets before its title."""
        return self.lettered or self.label

    @property
    def id_and_letter(self) -> str:
        """`e`, or `e [d on the sheet]` where students see another letter than files have."""
        return (
            self.id if self.heading_letter == self.id else f"{self.id} [{self.heading_letter} on the sheet]"
        )

    @property
    def answer_type(self) -> str:
        """The answer type; of two, the one that is asked for first."""
        return self.answer_types[0]

    @property
    def function(self) -> str:
        """The name a code part's function must have."""
        return self.signature.partition("(")[0].strip()
