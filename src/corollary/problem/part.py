"""One thing asked: its kind, its unit, its points, and the words around it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from corollary.units.unit import Unit

KindName = Literal["value", "vector", "expression", "choice", "example", "code", "plot", "explain", "proof"]
KIND_NAMES: tuple[KindName, ...] = get_args(KindName)


@dataclass(frozen=True, slots=True)
class Option:
    """One alternative of a choice: the letter a student gives, and its text."""

    letter: str
    text: str


@dataclass(frozen=True, slots=True)
class Part:
    """`kinds` has one member, or `code` and `plot` together; `components` names what a list answer holds, in order."""

    id: str
    title: str
    text: str
    kinds: tuple[KindName, ...]
    unit: Unit
    points: float
    components: tuple[str, ...]
    options: tuple[Option, ...]
    signature: str
    line: int

    @property
    def kind(self) -> KindName:
        return self.kinds[0]

    @property
    def function(self) -> str:
        """The name a code part's function must have."""
        return self.signature.partition("(")[0].strip()
