"""Findings of verification: counts of what was checked, complaints and notes with file and line, and the mutation score."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from corollary.derive.put_back import PutBack
from corollary.verify.obligations.obligation import Settled

LISTED, MOST_LAWS = 3, 8  # bends of a law, and laws, that are shown to a person


@dataclass(frozen=True, slots=True)
class Unnoticed:
    """A bend that no check would notice: the law by its name, where its step stands, the kind of slip, and the law with it."""

    law: str
    file: str
    line: int
    kind: str
    bend: str


@dataclass(frozen=True, slots=True)
class MutationScore:
    """`by` counts the noticed bends by the first check that would fail; `undecided` are bends of laws that are not solved in
    numbers, and `untried` those laws with file and line; `proposal` is a line that would catch `caught` of the unnoticed."""

    bends: int
    noticed: int
    by: Mapping[str, int] = field(default_factory=dict[str, int])
    unnoticed: tuple[Unnoticed, ...] = ()
    undecided: int = 0
    proposal: str = ""
    caught: int = 0
    untried: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """One line for the author."""
        if not self.bends and not self.undecided:
            return "signs and factors: no law to bend"
        text = f"signs and factors: {self.noticed} of {self.bends} bends noticed"
        return text + (f", {self.undecided} undecided" if self.undecided else "")

    @property
    def lines(self) -> list[str]:
        """The line, the laws in which bends are not noticed, and what would notice them."""
        laws: dict[str, list[str]] = {}
        for each in self.unnoticed:
            laws.setdefault(f"{each.file}:{each.line}: {each.law}", []).append(each.bend)
        found = [self.sentence]
        for law, several in list(laws.items())[:MOST_LAWS]:
            more = f" and {len(several) - LISTED} more" if len(several) > LISTED else ""
            found.append(f"  not noticed in {law}: {'; '.join(several[:LISTED])}{more}")
        if len(laws) > MOST_LAWS:
            found.append(f"  and in {len(laws) - MOST_LAWS} more laws: --json has all")
        if self.untried:
            more = f" and {len(self.untried) - LISTED} more" if len(self.untried) > LISTED else ""
            laws_not_tried = "; ".join(self.untried[:LISTED])
            found.append(f"  only dimensions check the signs in {laws_not_tried}{more}: read them once more")
        if self.proposal:
            found.append(f"  {self.proposal} would notice {self.caught} of {len(self.unnoticed)}")
        return found


def from_data(data: Mapping[str, Any] | None) -> MutationScore | None:
    """The score that `dataclasses.asdict` wrote."""
    if data is None:
        return None
    unnoticed: Any = tuple(Unnoticed(**each) for each in data["unnoticed"])
    content: dict[str, Any] = {**data, "unnoticed": unnoticed, "untried": tuple(data.get("untried", ()))}
    return MutationScore(**content)


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
