"""Complaints with a remedy: on a line of an author's file, or on a thing that a course needs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal


@dataclass(frozen=True, slots=True)
class Diagnostic:
    path: Path
    line: int
    sentence: str

    def __str__(self) -> str:
        return f"{self.path.name}:{self.line}: {self.sentence}"


class Malformed(Exception):
    """An author's file does not say what it must; carries every complaint found, in the order of the lines."""

    def __init__(self, complaints: list[Diagnostic]):
        self.complaints = sorted(complaints, key=lambda complaint: complaint.line)
        super().__init__("\n".join(map(str, self.complaints)))


@dataclass(frozen=True, slots=True)
class Finding:
    """What was found of one thing that a course needs. `state`: "good"; "weak", when something works less well or is missing
    without harm; "broken", when work will fail. `remedy` says what to do, or is empty."""

    name: str
    state: Literal["good", "weak", "broken"]
    sentence: str
    remedy: str = ""
