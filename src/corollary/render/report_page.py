"""The instructor's report as a page: what waits for a person first, then the whole, the parts, and every student."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from statistics import fmean, median
from typing import TYPE_CHECKING, Final
from urllib.parse import quote

from corollary.problem.problem_set import ProblemSet
from corollary.records.collusion import SHARING
from corollary.records.marks import HandedIn, Row
from corollary.records.report_model import PartTally, Report
from corollary.render.page import page
from corollary.render.report_table import coincidences, columns, different_totals
from corollary.render.statistics_text import EFFECTS, between, in_all, percent_between
from corollary.render.wording import BY_HAND, LOOKS

if TYPE_CHECKING:
    from corollary.records.statistics import SetStatistics

FORMGRADER: Final = "http://localhost:8888/formgrader"
"""Where formgrader is unless somebody says otherwise."""
WIDTHS: Final = (0.5, 1, 2, 5)
MOST_INTERVALS: Final = 12


@dataclass(frozen=True, slots=True)
class HistogramBin:
    """So many totals from `low` up to, and without, `high` points; the last interval holds its end too. `share` is that of
    the fullest, from 0 to 1."""

    low: float
    high: float
    count: int
    share: float


@dataclass(frozen=True, slots=True)
class Places:
    """Where a student's pages lie, as links: `course` leads from the report to the course folder."""

    set_name: str
    formgrader: str
    course: str

    def feedback(self, student: str) -> str:
        """Our page of feedback."""
        return f"{self.course}/feedback/{quote(student)}/{quote(self.set_name)}/{quote(self.set_name)}.html"

    def submission(self, student: str) -> str:
        """What formgrader has of a student in this set."""
        return f"{self.formgrader}/manage_students/{quote(student)}/{quote(self.set_name)}"

    @property
    def all_submissions(self) -> str:
        """All answers to the set in formgrader."""
        return f"{self.formgrader}/gradebook/{quote(self.set_name)}/{quote(self.set_name)}"


@dataclass(frozen=True, slots=True)
class StudentLine:
    """One line of the table of students, with what was said of each part."""

    about: HandedIn
    rows: tuple[Row, ...]
    waiting: int


@dataclass(frozen=True, slots=True)
class Segment:
    """A piece of a part's bar: `start` and `width` in per cent."""

    name: str
    start: float
    width: float


def report_page(
    report: Report,
    problem_set: ProblemSet,
    *,
    formgrader: str = "",
    course: str = "..",
    statistics: SetStatistics | None = None,
) -> str:
    """The report as one page of HTML that needs nothing beside it.

    `formgrader` is the address of nbgrader's page (empty: where Jupyter has it by itself), `course` the way from the report's
    folder to the course; `statistics` are what the marks tell of the parts, where that was asked for.
    """
    titles = {
        (problem.code, part.id): part.title for problem in problem_set.problems for part in problem.parts
    }
    uneven = len(report.totals) > 1
    return page(
        "report.html",
        title=f"{problem_set.title}: report",
        script="report.js",
        report=report,
        sharing=SHARING,
        coincidences=coincidences(report),
        different_totals=different_totals(report) if uneven else "",
        mean_share=fmean(report.shares) if report.shares else 0.0,
        median_share=median(report.shares) if report.shares else 0.0,
        problem_set=problem_set,
        looks=columns(report),
        all_looks={**LOOKS, BY_HAND.name: BY_HAND},
        titles=titles,
        intervals=intervals([100 * share for share in report.shares], 100)
        if uneven
        else intervals([one.points for one in report.handed_in], report.out_of),
        bars={(part.problem, part.part): tuple(_bar(part)) for part in report.parts},
        waiting=_waiting(report),
        rubrics={(one.problem, one.part): one.rubric for one in report.waiting if one.rubric},
        students=_lines(report),
        places=Places(problem_set.name, (formgrader or FORMGRADER).rstrip("/"), course),
        statistics=statistics,
        effects_title=EFFECTS,
        effects_in_all=in_all(statistics.effects) if statistics else "",
        between=between,
        percent_between=percent_between,
    )


def intervals(totals: list[float], out_of: float) -> list[HistogramBin]:
    """The totals counted in at most twelve intervals between round numbers, from 0 to what can be reached."""
    high = out_of if out_of > 0 else 1.0
    width = next(
        size for power in range(12) for base in WIDTHS if high / (size := base * 10**power) <= MOST_INTERVALS
    )
    many = max(1, -int(-high // width))
    counts = Counter(min(many - 1, max(0, int(total // width))) for total in totals)
    fullest = max(counts.values(), default=1)
    return [
        HistogramBin(width * at, min(width * (at + 1), high), counts[at], counts[at] / fullest)
        for at in range(many)
    ]


def _bar(part: PartTally) -> Iterator[Segment]:
    total, start = sum(part.counts.values()) or 1, 0.0
    for name in (*LOOKS, BY_HAND.name):
        if part.counts[name]:
            width = 100 * part.counts[name] / total
            yield Segment(name, round(start, 2), round(width, 2))
            start += width


def _waiting(report: Report) -> dict[tuple[str, str, str], list[str]]:
    """Whose answers wait, by problem, part and reason."""
    found: dict[tuple[str, str, str], list[str]] = {}
    for one in report.waiting:
        found.setdefault((one.problem, one.part, one.why), []).append(one.student)
    return found


def _lines(report: Report) -> list[StudentLine]:
    rows: dict[str, list[Row]] = {}
    for row in report.rows:
        rows.setdefault(row.student, []).append(row)
    waiting = Counter(one.student for one in report.waiting)
    return [
        StudentLine(one, tuple(rows.get(one.student, ())), waiting[one.student]) for one in report.handed_in
    ]
