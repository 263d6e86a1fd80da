"""Tables on marks by hand for a terminal: scores changed in the gradebook, requests for regrading, items of rubrics."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.problem.roster import name_with_id
from corollary.records.outside_changes import OutsideChange
from corollary.records.report_model import Report
from corollary.render.wording import percent, points

MOST = 10
LONGEST = 100


def outside_table(outside: Sequence[OutsideChange], names: Mapping[str, str] | None = None) -> Table:
    """Who has what, and what stands in the gradebook."""
    rows = (
        (
            named(each.student, names or {}),
            each.part,
            score(each.before),
            score(each.after),
            noticed_by(each),
        )
        for each in outside
    )
    return _table(
        "Changed in the gradebook (not counted until you agree)",
        ("student", "part", "has", "gradebook", "noticed"),
        rows,
    )


def by_hand_tables(report: Report) -> Iterator[Table]:
    """What the report has of all this; none of what there is nothing of."""
    names = {one.student: one.name for one in report.handed_in}
    if report.outside:
        yield outside_table(report.outside[:MOST], names)
    if report.requests:
        yield _table(
            f"Requests for regrading: {len(report.requests)} (answer them with corollary mark)",
            ("student", "part", "request"),
            (
                (named(each.student, names), each.part, " ".join(each.text.split())[:LONGEST])
                for each in report.requests[:MOST]
            ),
        )
    if report.rubric:
        yield _table(
            "Items of rubrics, among marks given by them",
            ("part", "item", "students"),
            (
                (
                    f"{one.problem} {one.part}",
                    one.text[:LONGEST],
                    f"{len(one.students)} of {one.of} ({percent(len(one.students) / one.of)})",
                )
                for one in report.rubric
            ),
        )


def named(student: str, names: Mapping[str, str]) -> str:
    """Name and id."""
    return name_with_id(names.get(student, student), student)


def score(value: float | None) -> str:
    """Points, or that there are none."""
    return "none" if value is None else points(value)


def noticed_by(each: OutsideChange) -> str:
    """Who noticed it, and when."""
    by = f"{each.by}, " if each.by else ""
    return f"{by}{each.at[:16].replace('T', ' ')} UTC"


def _table(title: str, columns: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Table:
    table = Table(*columns, title=title, title_justify="left", title_style="bold")
    for row in rows:
        table.add_row(*(Text(visible(each)) for each in row))
    return table
