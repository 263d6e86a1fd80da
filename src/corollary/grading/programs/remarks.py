"""What a judge of programs and figures says: of a failing, or of what is right and worth a word."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Said:
    """A failing, in a sentence; `known` when it is one of the usual mistakes."""

    sentence: str
    known: bool = False


@dataclass(frozen=True, slots=True)
class Remark:
    """The program is right; this is what halving its step showed."""

    sentence: str
