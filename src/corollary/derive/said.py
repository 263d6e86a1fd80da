"""What a judge of programs and figures says of a failing: a sentence, and whether it is one of the usual mistakes."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Said:
    sentence: str
    known: bool = False
