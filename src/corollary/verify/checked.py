"""Findings of verification: counts of what was checked, complaints and notes with file and line."""

from __future__ import annotations

from dataclasses import dataclass, field

from corollary.derive.put_back import PutBack
from corollary.verify.mutation.score_record import MutationScore
from corollary.verify.obligations.obligation import Settled

MOST = 20  # complaints of one problem: an author mends the first and verifies again


@dataclass(slots=True)
class Tally:
    """Grows while a problem is verified."""

    counts: dict[str, int] = field(default_factory=dict[str, int])
    complaints: list[str] = field(default_factory=list[str])
    notes: list[str] = field(default_factory=list[str])
    obligations: list[Settled] = field(default_factory=list[Settled])
    mutation: MutationScore | None = None
    put_back: list[PutBack] = field(default_factory=list[PutBack])

    def count(self, what: str, number: int = 1) -> None:
        self.counts[what] = self.counts.get(what, 0) + number

    def complain(self, sentence: str) -> None:
        if len(self.complaints) < MOST:
            self.complaints.append(sentence)

    def note(self, sentence: str) -> None:
        """Says what may be meant so, and then is no fault."""
        self.notes.append(sentence)

    def check(self, holds: bool, what: str) -> bool:
        """Counts a check and hands its outcome on: what does not hold is complained of by who knows why."""
        self.count(what)
        return holds


@dataclass(frozen=True, slots=True)
class Checked:
    """One problem, verified. `redrawn` is the share of draws that may not be assigned, `why` their most common reasons; `notes` are what
    an author may want to know, and no fault; `unread` is what no check has read."""

    code: str
    variants: int
    exact_count: bool
    redrawn: float
    why: tuple[tuple[str, int], ...]
    checks: dict[str, int]
    complaints: tuple[str, ...]
    notes: tuple[str, ...] = ()
    obligations: tuple[Settled, ...] = ()
    unread: tuple[str, ...] = ()
    mutation: MutationScore | None = None

    @property
    def ok(self) -> bool:
        return not self.complaints
