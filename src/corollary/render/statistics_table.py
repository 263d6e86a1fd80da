"""The statistics of a set on a terminal, and estimates and effects in words, for a page too."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import visible
from corollary.render.wording import percent

if TYPE_CHECKING:  # a report without statistics is written without numpy
    from corollary.records.statistics import Estimate, FeatureEffect, SetStatistics
    from corollary.records.unlisted import SharedRule

TOO_FEW = "Too few answers to tell whether the numbers drawn made a difference."
EFFECTS = "Numbers drawn: effect on the odds, in logits for a standard deviation"


def between(each: Estimate) -> str:
    """The estimate and its interval."""
    return f"{each.value:.2f} ({each.low:.2f} to {each.high:.2f})".replace("-", "\N{MINUS SIGN}")


def p_value(p: float) -> str:
    """A probability with three decimals, so that a column of them is read by its length."""
    return "< 0.001" if p < 0.0005 else f"{p:.3f}"


def percent_between(each: Estimate) -> str:
    """The same of a share, in per cent."""
    return f"{percent(each.value)} ({percent(each.low)} to {percent(each.high)})"


def in_all(effects: Sequence[FeatureEffect]) -> str:
    """How many effects were looked for and found, and how many would have been missed."""
    if not effects:
        return TOO_FEW
    sure = sum(each.adjusted < 0.05 for each in effects)
    blind = sum(each.power < 0.8 for each in effects)
    return (
        f"{len(effects)} {'effect' if len(effects) == 1 else 'effects'} looked for, {sure} found at 5 % of all together; of {blind} half a logit would be missed"
        f" more than once in five times"
    )


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
            p_value(each.p),
            p_value(each.adjusted),
            percent(each.power),
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
    table = Table(title=title, title_justify="left", title_style="bold")
    for name in columns:
        numbers = name not in {"part", "what", "feature", "students"}
        table.add_column(name, justify="right" if numbers else "left", no_wrap=numbers or name == "part")
    return table
