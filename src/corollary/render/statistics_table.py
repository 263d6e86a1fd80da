"""The statistics of a set on a terminal: what each part tells, what is held by how many, and which numbers made a difference."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.records.estimate import Estimate
from corollary.records.fairness import FeatureEffect
from corollary.records.set_statistics import SetStatistics

MOST = 15


def statistics_table(found: SetStatistics) -> RenderableType:
    """Tables for rich, after those of the report."""
    return Group(*_pieces(found))


def _pieces(found: SetStatistics) -> Iterator[RenderableType]:
    table = _empty("Parts, with 95 % intervals", "part", "answers", "all points", "tells students apart")
    for part in found.parts:
        apart = "–" if part.discrimination is None else _between(part.discrimination)
        table.add_row(
            f"{part.problem} {part.part}", str(part.answers), _between(part.difficulty, percent=True), apart
        )
    yield table
    if found.misconceptions:
        table = _empty("Misconceptions and slips by share", "part", "what", "share", "students")
        for one in found.misconceptions[:MOST]:
            whose = ", ".join(one.students[:4]) + (" …" if len(one.students) > 4 else "")
            cells = (f"{one.problem} {one.part}", one.text, _between(one.share, percent=True), whose)
            table.add_row(*(Text(visible(cell)) for cell in cells))
        yield table
    if not found.effects:
        yield Text("\nToo few answers to tell whether the numbers drawn made a difference.")
        return
    table = _empty(
        "Numbers drawn: effect on the odds, in logits for a standard deviation",
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
            _between(each.effect),
            f"{each.p:.2g}",
            f"{each.adjusted:.2g}",
            f"{each.power:.0%}",
        )
    yield table
    yield Text(_sum(found.effects))


def _sum(effects: tuple[FeatureEffect, ...]) -> str:
    sure = sum(each.adjusted < 0.05 for each in effects)
    blind = sum(each.power < 0.8 for each in effects)
    return (
        f"{len(effects)} effects looked for, {sure} found at 5 % of all together; of {blind} half a logit would be missed"
        f" more than once in five times"
    )


def _between(each: Estimate, *, percent: bool = False) -> str:
    if percent:
        return f"{each.value:.0%} ({each.low:.0%} to {each.high:.0%})"
    return f"{each.value:.2f} ({each.low:.2f} to {each.high:.2f})"


def _empty(title: str, *columns: str) -> Table:
    return Table(*columns, title=title, title_justify="left", title_style="bold")
