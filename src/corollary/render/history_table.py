"""The history of one student's marks as tables for a terminal."""

from __future__ import annotations

from datetime import datetime, tzinfo

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.records.student_history import PROGRAM, MarkEvent, SetHistory
from corollary.render.wording import points

LONGEST = 80


def history_table(histories: list[SetHistory], title: str, zone: tzinfo | None) -> RenderableType:
    """A table for each set, its lines in the order in which things happened."""
    if not histories:
        return Text(f"{title}: nothing is marked yet")
    return Group(*(_of_set(each, title, zone) for each in histories))


def _of_set(each: SetHistory, title: str, zone: tzinfo | None) -> Table:
    total = (
        ""
        if each.points is None or each.out_of is None
        else f": {points(each.points)} of {points(each.out_of)}"
    )
    table = Table(title=f"{title}, {each.set}{total}", title_justify="left", title_style="bold")
    for name in ("when", "part", "who", "what", "points", "answer, words"):
        table.add_column(name, overflow="fold")
    for one in each.events:
        cells = (_when(one.at, zone), one.part, _who(one), one.what, _points(one), _words(one))
        table.add_row(*(Text(visible(cell)) for cell in cells))
    return table


def _when(at: str, zone: tzinfo | None) -> str:
    try:
        return f"{datetime.fromisoformat(at).astimezone(zone):%Y-%m-%d %H:%M}"
    except ValueError:
        return "not known"


def _who(one: MarkEvent) -> str:
    return f"{one.by} ({one.kind})" if one.by and one.by != one.kind else one.kind


def _points(one: MarkEvent) -> str:
    if one.points is None:
        return ""
    return points(one.points) if one.out_of is None else f"{points(one.points)} of {points(one.out_of)}"


def _words(one: MarkEvent) -> str:
    ticked = "; ".join(one.rubric)
    text = "" if one.kind == PROGRAM else one.text  # the version of the program is in --json
    texts = (f"for: {one.answer}" if one.answer else "", ticked and f"items: {ticked}", text)
    return "\n".join(_short(each) for each in texts if each)


def _short(text: str) -> str:
    one_line = " ".join(text.split())
    return one_line if len(one_line) <= LONGEST else f"{one_line[: LONGEST - 1]}…"
