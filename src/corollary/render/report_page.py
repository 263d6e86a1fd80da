"""The instructor's report, as a page and on a terminal: what waits for a person first, then the whole, the parts, and misconceptions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from statistics import fmean, median
from typing import TYPE_CHECKING, Final
from urllib.parse import quote

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.answers.explain.judging import by_teacher
from corollary.messages import few, visible
from corollary.problem.problem_set import ProblemSet
from corollary.records.collusion import SHARING
from corollary.records.marks import HandedIn, Row
from corollary.records.report_model import PartTally, Report
from corollary.records.stopped_table import StoppedRow
from corollary.render.marks_by_hand_tables import by_hand_tables, named, noticed_by, score
from corollary.render.page import page
from corollary.render.statistics_table import EFFECTS, between, in_all, p_value, percent_between
from corollary.render.wording import BY_HAND, LOOKS, Look, percent, points

if TYPE_CHECKING:
    from corollary.records.statistics import SetStatistics

MOST = 10
IN_WORDS = "an answer in words"  # in the place of the sentence that students read
MOST_IN_A_CELL = 4  # students in a cell


def terminal(report: Report, unmarked: Collection[str] = ()) -> RenderableType:
    """The report as tables for rich; colours disappear by themselves where there is no terminal. `unmarked` handed in, and
    their marks are not in the report."""
    return Group(*_pieces(report, unmarked))


def _pieces(report: Report, unmarked: Collection[str]) -> Iterator[RenderableType]:
    if unmarked:
        yield Text(f"{len(unmarked)} handed in what is not on record yet; on record:")
    if report.handed_in or not unmarked:
        yield Text(_headline(report))
    else:
        yield Text("nothing so far")
    if report.parts:
        yield _parts(report)
    if report.met:
        yield _table(
            "Misconceptions and slips met",
            ("part", "what", "students"),
            (
                (
                    f"{met.problem} {met.part}",
                    met.text,
                    f"{len(met.students)}: {report.some(met.students, MOST_IN_A_CELL)}",
                )
                for met in report.met[:MOST]
            ),
        )
        yield from _more(len(report.met))
    if report.stopped:
        yield _table(
            STOPPED,
            ("what", "students", "parts without an answer", "what to do"),
            ((row.what, row.who, parts_lost(row), row.to_do) for row in report.stopped[:MOST]),
        )
        yield from _more(len(report.stopped))
    if waiting := _waiting_answers(report):
        yield _table(
            "Waits for marking",
            ("part", "why", "students"),
            (
                (f"{problem} {part}", why, f"{len(whose)}: {report.some(whose, MOST_IN_A_CELL)}")
                for (problem, part, why), whose in list(waiting.items())[:MOST]
            ),
        )
        yield from _more(len(waiting))
    if report.near_misses:
        yield _table(
            "Near misses of reading (no points yet; accept a group with corollary mark SET --accept ID)",
            ("id", "part", "kind", "typed", "would be right as", "students"),
            (
                (
                    one.id,
                    f"{one.problem} {one.part}",
                    one.kind,
                    one.answers[0].typed,
                    one.answers[0].read,
                    f"{len(one.students)}: {report.some(one.students, MOST_IN_A_CELL)}",
                )
                for one in report.near_misses[:MOST]
            ),
        )
        yield from _more(len(report.near_misses))
    yield from by_hand_tables(report)
    if report.failed:
        yield from _cut(
            "Something went wrong",
            ("student", "why"),
            [(report.called(one.student), one.trouble) for one in report.failed],
        )
    if report.unusable:
        unusable = [(report.called(student), why) for student, why in report.unusable]
        yield from _cut("Handed in, but cannot be marked", ("student", "what"), unusable)
    if report.nobodys:
        yield from _cut("Collected, owner unknown", ("file", "what"), report.nobodys)
    if report.noticed:
        yield from _cut(
            "Noticed (no points were deducted)",
            ("student", "what"),
            [(report.called(one.student), note) for one in report.noticed for note in one.notes],
        )
    if report.shared:
        title = "Wrong, but right for another student's numbers (proves nothing by itself)"
        yield _table(
            title,
            ("student", "fits", "parts", "by chance"),
            (
                (
                    report.called(one.student),
                    report.called(one.other),
                    ", ".join(one.parts),
                    f"{one.chance:.2g}",
                )
                for one in report.shared[:MOST]
            ),
        )
        yield from _more(len(report.shared))
    if report.coincidences:
        yield Text(f"\n{coincidences(report)}")
    if missing := tuple(one for one in report.missing if one not in unmarked):
        yield Text(f"\nNot handed in by {len(missing)}: {report.some(missing, MOST)}")
    if report.excused:
        yield Text(f"\nExcused: {report.some(report.excused, MOST)}")
    for line, count in report.isolation.items():
        yield Text(f"\n{count} ran behind {line}", style="dim")


STOPPED: Final = "Stopped cells"


def parts_lost(row: StoppedRow) -> str:
    """The parts that have no answer because of a stopped cell, and whether they wait."""
    if not row.parts:
        return "none"
    return few(row.labels, MOST_IN_A_CELL) + (" (for marking)" if row.waits else "")


def columns(report: Report) -> dict[str, Look]:
    """The looks that a table of parts has a column for; what persons marked only where they did."""
    by_hand = any(part.counts[BY_HAND.name] for part in report.parts)
    return {**LOOKS, BY_HAND.name: BY_HAND} if by_hand else dict(LOOKS)


def _headline(report: Report) -> str:
    if report.mean is None or report.median is None:
        return "Nothing was handed in yet."
    if len(report.totals) > 1:
        marks = (
            f"mean {percent(fmean(report.shares))} and median {percent(median(report.shares))} of the own sheet's points, for "
            f"{different_totals(report)}"
        )
    else:
        marks = (
            f"mean {points(report.mean)} and median {points(report.median)} of {points(report.out_of)} points"
        )
    return (
        f"{len(report.handed_in)} handed in, {report.late_count} of them late; {marks}; "
        f"{_waiting(len(report.waiting))} for marking"
    )


def different_totals(report: Report) -> str:
    """What sheets are out of, where that is not the same for all."""
    *others, last = map(points, report.totals)
    return f"sheets are out of {', '.join(others)} or {last} points"


def coincidences(report: Report) -> str:
    """How many wrong answers fit somebody else's numbers, and that this means nothing."""
    count = report.coincidences
    times = "once" if count == 1 else f"{count} times"
    opening = f"Besides, {times}" if report.shared else times.capitalize()
    return f"{opening} a wrong answer fits another student's numbers, which chance explains."


def _waiting(count: int) -> str:
    return "1 answer waits" if count == 1 else f"{count} answers wait"


def _parts(report: Report) -> Table:
    table = Table(title="Parts", title_justify="left", title_style="bold")
    table.add_column("part", no_wrap=True)
    looks = columns(report)
    for look in looks.values():
        table.add_column(look.short, justify="right")
    table.add_column("points", justify="right")
    for part in report.parts:
        counts = [str(part.counts[name]) if part.counts[name] else "·" for name in looks]
        table.add_row(
            Text(f"{part.problem} {part.part}"), *counts, "–" if part.share is None else percent(part.share)
        )
    return table


def _table(title: str, columns: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> Table:
    table = Table(*columns, title=title, title_justify="left", title_style="bold")
    for row in rows:
        table.add_row(*(Text(visible(each)) for each in row))
    return table


def _cut(title: str, columns: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> Iterator[RenderableType]:
    """The first rows of a table, and how many more there are."""
    yield _table(title, columns, iter(rows[:MOST]))
    yield from _more(len(rows))


def _more(count: int) -> Iterator[Text]:
    if count > MOST:
        yield Text(f"and {count - MOST} more, in the report's page and with --json", style="dim")


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
        style="report.css",
        report=report,
        sharing=SHARING,
        parts_lost=parts_lost,
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
        waiting=_waiting_answers(report),
        rubrics={(one.problem, one.part): one.rubric for one in report.waiting if one.rubric},
        students=_lines(report),
        places=Places(problem_set.name, (formgrader or FORMGRADER).rstrip("/"), course),
        statistics=statistics,
        names={one.student: one.name for one in report.handed_in},
        named=named,
        score=score,
        noticed_by=noticed_by,
        effects_title=EFFECTS,
        effects_in_all=in_all(statistics.effects) if statistics else "",
        between=between,
        percent_between=percent_between,
        p_value=p_value,
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


def _waiting_answers(report: Report) -> dict[tuple[str, str, str], list[str]]:
    """Whose answers wait, by problem, part and reason."""
    found: dict[tuple[str, str, str], list[str]] = {}
    for one in report.waiting:
        why = IN_WORDS if one.why == by_teacher() else one.why
        found.setdefault((one.problem, one.part, why), []).append(one.student)
    return found


def _lines(report: Report) -> list[StudentLine]:
    rows: dict[str, list[Row]] = {}
    for row in report.rows:
        rows.setdefault(row.student, []).append(row)
    waiting = Counter(one.student for one in report.waiting)
    return [
        StudentLine(one, tuple(rows.get(one.student, ())), waiting[one.student]) for one in report.handed_in
    ]
