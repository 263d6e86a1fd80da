"""Totals of a term: shares of sets with weights, the worst left out, and ranges where a mark is not final."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from corollary.records.term_rules import TermRules

MARKED, WAITS, UNGRADED, MISSING, OPEN, EXCUSED, NO_SHEET = (
    "marked",
    "waits",
    "not graded",
    "missing",
    "open",
    "excused",
    "no sheet",
)
COUNTED = frozenset({MARKED, WAITS, UNGRADED, MISSING})
SAME = 1e-12


@dataclass(frozen=True, slots=True)
class SetResult:
    """What became of one set for one student. `low` and `high` are the least and the most share of the points that the marks may
    end at; they differ where answers wait for a person, and where a hand-in is not graded yet."""

    state: str
    low: float = 0.0
    high: float = 0.0
    points: float = 0.0
    out_of: float = 0.0
    waiting: int = 0
    late: bool = False
    trouble: str = ""

    @property
    def is_final(self) -> bool:
        return self.high - self.low < SAME


@dataclass(frozen=True, slots=True)
class TermTotal:
    """The least and the most share of the whole, None where nothing counts yet; `dropped` are the places of the sets left out of
    the most that can be reached."""

    low: float | None
    high: float | None
    dropped: frozenset[int] = frozenset()

    @property
    def is_final(self) -> bool:
        return self.low is not None and self.high is not None and self.high - self.low < SAME

    @property
    def value(self) -> float | None:
        """The total; None where there is none, or it is not final."""
        return self.low if self.is_final else None


def term_total(results: Sequence[SetResult], weights: Sequence[float], rules: TermRules) -> TermTotal:
    """The weighted mean of a student's sets that count so far."""
    counted = [place for place, each in enumerate(results) if each.state in COUNTED and weights[place] > 0]
    if not counted:
        return TermTotal(None, None)
    most = rules.chosen(len(counted))
    own = [weights[place] for place in counted]
    low, _ = best_mean([results[place].low for place in counted], own, most)
    high, chosen = best_mean([results[place].high for place in counted], own, most)
    return TermTotal(low, high, frozenset(counted) - {counted[place] for place in chosen})


def best_mean(shares: Sequence[float], weights: Sequence[float], count: int) -> tuple[float, frozenset[int]]:
    """The largest weighted mean of `count` of the shares, and which these are.

    With unequal weights, leaving out the lowest share is not the best for a student, and a better mark could lower the total. Here
    none can: the mean is the largest of all choices. Found by Dinkelbach's iteration, as in Kane and Kane 2006, *Dropping lowest
    grades*, Mathematics Magazine 79, 181.
    """

    def mean(places: Sequence[int]) -> float:
        return sum(weights[at] * shares[at] for at in places) / sum(weights[at] for at in places)

    chosen: Sequence[int] = range(count)
    while True:
        found = mean(chosen)
        gains = sorted(range(len(shares)), key=lambda at: (-weights[at] * (shares[at] - found), at))
        if mean(gains[:count]) <= found + SAME:
            return found, frozenset(chosen)
        chosen = gains[:count]
