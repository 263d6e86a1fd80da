"""The statistics of a set on a terminal: what each part tells, what is held by how many, and which numbers made a difference."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.records.statistics import SetStatistics
from corollary.records.unlisted import SharedRule
from corollary.render.statistics_text import EFFECTS, between, in_all, percent_between

MOST = 15


def statistics_table(found: SetStatistics) -> RenderableType:
    """Tables for rich, after those of the report."""
    return Group(*_pieces(found))


def _pieces(found: SetStatistics) -> Iterator[RenderableType]:
    table = _empty("Parts, with 95 % intervals", "part", "answers", "all points", "tells students apart")
    for part in found.parts:
        apart = "–" if part.discrimination is None else between(part.discrimination)
        table.add_row(
            f"{part.problem} {part.part}", str(part.answers), percent_between(part.difficulty), apart
        )
    yield table
    if found.misconceptions:
        table = _empty("Misconceptions and slips by share", "part", "what", "share", "students")
        for one in found.misconceptions[:MOST]:
            whose = ", ".join(one.students[:4]) + (" …" if len(one.students) > 4 else "")
            cells = (f"{one.problem} {one.part}", one.text, percent_between(one.share), whose)
            table.add_row(*(Text(visible(cell)) for cell in cells))
        yield table
    for offer in found.unlisted:
        yield _offer(offer)
    if not found.effects:
        yield Text(f"\n{in_all(found.effects)}")
        return
    table = _empty(
        EFFECTS,
        "part",
        "feature",
        "effect",
        "p",
        "p of all",
        "finds 0.5",
    )
    for each in found.effects[:MOST]:
        table.add_row(
            f"{each.problem} {each.part}",
            each.feature,
            between(each.effect),
            f"{each.p:.2g}",
            f"{each.adjusted:.2g}",
            f"{each.power:.0%}",
        )
    yield table
    yield Text(in_all(found.effects))


def _offer(offer: SharedRule) -> Text:
    """What an author may want to list; nobody is marked by it."""
    held = f"{len(offer.students)} of {offer.wrong} wrong answers that nobody listed"
    lines = [
        f"\n{offer.problem} {offer.part}: {held} ({offer.expected:.2g} expected by chance)",
        *(f"  {rule.words}: {rule.formula}" for rule in offer.rules),
        f"  students: {', '.join(offer.students)}",
        f"  listed, {offer.points:g} points would move; a draft for the solution, to be looked at:",
        f"  {offer.rules[0].draft}",
    ]
    return Text("\n".join(visible(line) if line[0] != "\n" else line for line in lines))


def _empty(title: str, *columns: str) -> Table:
    return Table(*columns, title=title, title_justify="left", title_style="bold")
