"""A graded problem set in numbers: one row for each part of each student, and what they come to."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from statistics import fmean, median

WITHIN = 0.005
SHARING = (
    "A wrong answer is taken to fall anywhere, on a logarithmic scale, in the span of the class's right answers to that part; "
    f"it fits another student's when it lies within {WITHIN:.1%} of it. The chance is that of meeting at least one of the "
    "other students so, in one part of each exercise listed (parts of one exercise follow from one another and count once)."
)


@dataclass(frozen=True, slots=True)
class Row:
    """One part of one student, points before lateness. `verdict` is its word, `said` the mistake or slip, `why` the rest."""

    student: str
    problem: str
    part: str
    verdict: str
    points: float
    out_of: float
    said: str = ""
    why: str = ""


@dataclass(frozen=True, slots=True)
class HandedIn:
    """One submission as a whole: points after lateness; `late` in seconds; `trouble` a sentence, or empty; `notes` tell
    what was noticed."""

    student: str
    name: str
    points: float
    out_of: float
    late: float = 0.0
    late_share: float = 1.0
    trouble: str = ""
    isolation: str = ""
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PartTally:
    """How one part went. `counts` has every verdict's word; `share` is the mean share of points among marked answers, or None."""

    problem: str
    part: str
    counts: Mapping[str, int]
    share: float | None


@dataclass(frozen=True, slots=True)
class Met:
    """A misconception (`mistaken`) or a generic slip (`slip`) met in one part, and the students in whose work it was."""

    verdict: str
    text: str
    problem: str
    part: str
    students: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Waiting:
    student: str
    problem: str
    part: str
    why: str


@dataclass(frozen=True, slots=True)
class Shared:
    """Wrong answers of a student that are right for the numbers of `other`, by part, and how likely that is by chance."""

    student: str
    other: str
    parts: tuple[str, ...]
    chance: float


@dataclass(frozen=True, slots=True)
class Report:
    """A graded problem set in sum; `missing` are students of the roster who handed in nothing; `shared` proves nothing."""

    handed_in: tuple[HandedIn, ...]
    parts: tuple[PartTally, ...]
    met: tuple[Met, ...]
    waiting: tuple[Waiting, ...]
    missing: tuple[str, ...]
    shared: tuple[Shared, ...] = ()

    @property
    def noticed(self) -> tuple[HandedIn, ...]:
        """The submissions of which something was noticed, such as an edited statement."""
        return tuple(one for one in self.handed_in if one.notes)

    @property
    def failed(self) -> tuple[HandedIn, ...]:
        """The submissions with which something went wrong as a whole."""
        return tuple(one for one in self.handed_in if one.trouble)

    @property
    def late(self) -> float:
        """The share of submissions that came late."""
        return fmean(one.late > 0 for one in self.handed_in) if self.handed_in else 0.0

    @property
    def mean(self) -> float | None:
        return fmean(one.points for one in self.handed_in) if self.handed_in else None

    @property
    def median(self) -> float | None:
        return median(one.points for one in self.handed_in) if self.handed_in else None

    @property
    def out_of(self) -> float:
        return max((one.out_of for one in self.handed_in), default=0.0)

    @property
    def isolation(self) -> dict[str, int]:
        """How many submissions ran behind which walls."""
        return dict(Counter(one.isolation for one in self.handed_in if one.isolation))
