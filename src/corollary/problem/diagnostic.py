"""What is wrong with an author's file: sentences that name file, line and remedy."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


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
