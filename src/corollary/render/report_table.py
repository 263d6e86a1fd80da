"""The instructor's report on a terminal."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from statistics import fmean, median

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.records.report_model import Report
from corollary.render.wording import BY_HAND, LOOKS, Look, points

MOST = 15


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
                (f"{met.problem} {met.part}", met.text, f"{len(met.students)}: {_some(met.students)}")
                for met in report.met[:MOST]
            ),
        )
        yield from _more(len(report.met))
    if report.waiting:
        yield _table(
            "Waits for a person",
            ("student", "part", "why"),
            ((one.student, f"{one.problem} {one.part}", one.why) for one in report.waiting[:MOST]),
        )
        yield from _more(len(report.waiting))
    if report.near_misses:
        yield _table(
            "Near misses of reading (nothing was given; accept a group with corollary mark SET --accept ID)",
            ("id", "part", "kind", "typed", "would be right as", "students"),
            (
                (
                    one.id,
                    f"{one.problem} {one.part}",
                    one.kind,
                    one.answers[0].typed,
                    one.answers[0].read,
                    f"{len(one.students)}: {_some(one.students)}",
                )
                for one in report.near_misses[:MOST]
            ),
        )
        yield from _more(len(report.near_misses))
    if report.failed:
        yield _table(
            "Something went wrong", ("student", "why"), ((one.student, one.trouble) for one in report.failed)
        )
    if report.unusable:
        yield _table("Handed in, and cannot be used", ("student", "what"), iter(report.unusable))
    if report.nobodys:
        yield _table("Collected, and nobody knows whose", ("file", "what"), iter(report.nobodys))
    if report.noticed:
        yield _table(
            "Noticed (nothing was taken off for it)",
            ("student", "what"),
            ((one.student, note) for one in report.noticed for note in one.notes),
        )
    if report.shared:
        title = "Wrong here, right for somebody else's numbers (proves nothing by itself)"
        yield _table(
            title,
            ("student", "fits", "parts", "by chance"),
            (
                (one.student, one.other, ", ".join(one.parts), f"{one.chance:.2g}")
                for one in report.shared[:MOST]
            ),
        )
        yield from _more(len(report.shared))
    if report.coincidences:
        yield Text(f"\n{coincidences(report)}")
    if missing := tuple(one for one in report.missing if one not in unmarked):
        yield Text(f"\nNothing from {len(missing)}: {_some(missing, 12)}")
    if report.excused:
        yield Text(f"\nExcused: {_some(report.excused, 12)}")
    for line, count in report.isolation.items():
        yield Text(f"\n{count} ran behind {line}", style="dim")


def columns(report: Report) -> dict[str, Look]:
    """The looks that a table of parts has a column for; what persons marked only where they did."""
    by_hand = any(part.counts[BY_HAND.name] for part in report.parts)
    return {**LOOKS, BY_HAND.name: BY_HAND} if by_hand else dict(LOOKS)


def _headline(report: Report) -> str:
    if report.mean is None or report.median is None:
        return "Nothing was handed in yet."
    if len(report.totals) > 1:
        marks = (
            f"mean {fmean(report.shares):.0%} and median {median(report.shares):.0%} of the own sheet's points, for "
            f"{different_totals(report)}"
        )
    else:
        marks = (
            f"mean {points(report.mean)} and median {points(report.median)} of {points(report.out_of)} points"
        )
    return (
        f"{len(report.handed_in)} handed in, {report.late_count} of them late; {marks}; "
        f"{_waiting(len(report.waiting))} for a person"
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
    return f"{opening} a wrong answer fits somebody else's numbers, which chance explains."


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
            Text(f"{part.problem} {part.part}"), *counts, "–" if part.share is None else f"{part.share:.0%}"
        )
    return table


def _table(title: str, columns: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> Table:
    table = Table(*columns, title=title, title_justify="left", title_style="bold")
    for row in rows:
        table.add_row(*(Text(visible(each)) for each in row))
    return table


def _more(count: int) -> Iterator[Text]:
    if count > MOST:
        yield Text(f"and {count - MOST} more; --json has them all", style="dim")


def _some(names: tuple[str, ...], most: int = 4) -> str:
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
