"""Complaints with a remedy: on a line of an author's file, or on a thing that a course needs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

SOLUTIONS = "solutions"  # the folder of a bank in which solutions stand, as its problems do in `problems`


def name_in_bank(path: Path) -> str:
    """A file's name as complaints have it; of a solution in text with its folders, for its problem has the same name."""
    folders = path.parts[:-1]
    if path.suffix != ".md" or SOLUTIONS not in folders:
        return path.name
    first = len(folders) - 1 - folders[::-1].index(SOLUTIONS)
    return "/".join(path.parts[first:])


@dataclass(frozen=True, slots=True)
class Diagnostic:
    path: Path
    line: int
    sentence: str

    def __str__(self) -> str:
        return f"{name_in_bank(self.path)}:{self.line}: {self.sentence}"


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
