"""One thing asked: its answer type, its unit, its points, and the words around it."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.units.unit import Unit


@dataclass(frozen=True, slots=True)
class Option:
    """One alternative of a choice: the letter a student gives, and its text."""

    letter: str
    text: str


@dataclass(frozen=True, slots=True)
class Part:
    """`answer_types` names its answer type, or `code` and `plot` together; `components` names what a list answer holds, in order;
    `asked_as` is the id it was handed out with, where it has been given another since.

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

    @property
    def label(self) -> str:
        """The id that students know it by."""
        return self.asked_as or self.id

    @property
    def answer_type(self) -> str:
        """The answer type; of two, the one that is asked for first."""
        return self.answer_types[0]

    @property
    def function(self) -> str:
        """The name a code part's function must have."""
        return self.signature.partition("(")[0].strip()
