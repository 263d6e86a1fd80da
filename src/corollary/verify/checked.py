"""What verification found: counts of what was checked, and complaints with file and line."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(slots=True)
class Tally:
    """Grows while a problem is verified."""

    counts: dict[str, int] = field(default_factory=dict)
    complaints: list[str] = field(default_factory=list)

    def count(self, what: str, number: int = 1) -> None:
        self.counts[what] = self.counts.get(what, 0) + number

    def complain(self, sentence: str) -> None:
        if len(self.complaints) < 20:
            self.complaints.append(sentence)

    def expect(self, holds: bool, what: str, sentence: Callable[[], str]) -> None:
        """Counts a check, and complains when it does not hold."""
        self.count(what)
        if not holds:
            self.complain(sentence())


@dataclass(frozen=True, slots=True)
class Checked:
    """One problem, verified. `redrawn` is the share of draws that may not be dealt, `why` their most common reasons."""

    code: str
    variants: int
    exact_count: bool
    redrawn: float
    why: tuple[tuple[str, int], ...]
    checks: dict[str, int]
    complaints: tuple[str, ...]

    @property
    def ok(self) -> bool:
        return not self.complaints
