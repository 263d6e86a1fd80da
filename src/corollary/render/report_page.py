"""The instructor's report as a page: every plot has its table beside it."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from markupsafe import Markup

from corollary.figure.plots import Layer, histogram, interval_counts, stacked_bars
from corollary.problem.problem_set import ProblemSet
from corollary.records.collusion import SHARING
from corollary.records.report_model import PartTally, Report
from corollary.render.page import page
from corollary.render.wording import LOOKS, points


@dataclass(frozen=True, slots=True)
class HistogramBin:
    """So many totals from `low` to `high` points."""

    low: float
    high: float
    count: int


def report_page(report: Report, problem_set: ProblemSet) -> str:
    """The report as one page of HTML that needs nothing beside it."""
    intervals = _intervals(report)
    titles = {
        (problem.code, part.id): part.title for problem in problem_set.problems for part in problem.parts
    }
    return page(
        "report.html",
        title=f"{problem_set.title}: report",
        report=report,
        sharing=SHARING,
        problem_set=problem_set,
        looks=LOOKS.values(),
        titles=titles,
        intervals=intervals,
        totals=Markup(_totals(report, intervals)) if report.handed_in else "",
        verdicts=Markup(_verdicts(report)) if report.parts else "",
        waiting=_waiting(report),
        waiting_of=Counter(one.student for one in report.waiting),
    )


def _intervals(report: Report) -> list[HistogramBin]:
    """One interval a point while that makes at most 20; else 20."""
    high = report.out_of or 1.0
    bins = round(high) if 4 <= high <= 20 and high == round(high) else 20 if high > 20 else 10
    counts = interval_counts([one.points for one in report.handed_in], 0, high, bins)
    return [HistogramBin(high * at / bins, high * (at + 1) / bins, count) for at, count in enumerate(counts)]


def _waiting(report: Report) -> dict[tuple[str, str, str], list[str]]:
    """Whose answers wait, by problem, part and reason."""
    found: dict[tuple[str, str, str], list[str]] = {}
    for one in report.waiting:
        found.setdefault((one.problem, one.part, one.why), []).append(one.student)
    return found


def _totals(report: Report, intervals: list[HistogramBin]) -> str:
    mean, median = report.mean or 0.0, report.median or 0.0
    return histogram(
        [one.points for one in report.handed_in],
        low=0,
        high=intervals[-1].high,
        bins=len(intervals),
        x_label=f"points of {points(report.out_of)}",
        y_label="students",
        alt=f"Histogram of the totals of {len(report.handed_in)} students: mean {points(mean)}, median {points(median)} of"
        f" {points(report.out_of)} points. The table beside it has the numbers.",
    )


def _verdicts(report: Report) -> str:
    layers = [
        Layer(look.short, tuple(part.counts[look.name] for part in report.parts), look.colour)
        for look in LOOKS.values()
    ]
    return stacked_bars(
        [_label(part) for part in report.parts],
        layers,
        x_label="students",
        alt=f"Bars for {len(report.parts)} parts: how many answers were right, followed, mistaken, a slip, wrong, unread"
        " or are waiting. The table below has the numbers.",
    )


def _label(part: PartTally) -> str:
    return f"{part.problem} {part.part}"
