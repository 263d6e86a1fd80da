"""`corollary audit`: somebody else's answer key held against the laws."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from corollary.audit.audit import audit_each
from corollary.audit.limited_reading import LimitedReader
from corollary.audit.outcome import FAULTS, FINDINGS, AuditedAnswer
from corollary.audit.readers.server_draw import ServerRuns
from corollary.cli.ending import FAILS, HOLDS, REFUSED, answer, counted, say
from corollary.cli.terminal import bar, console
from corollary.messages import visible
from corollary.problem.bank import open_bank

COLOURS = {
    "agrees": "green",
    "last figure": "yellow",
    "ambiguous": "yellow",
    "cannot say": "dim",
}  # the rest is red


def run(
    files: list[str],
    laws: Path | None,
    bank: Path | None,
    report: Path | None,
    running: bool,
    seeds: int,
    require: int,
    as_json: bool,
) -> int:
    with (
        ServerRuns(seeds, require) as servers,
        LimitedReader(laws, servers if running else None) as reader,
    ):
        read = [reader.read(Path(name)) for name in files]
    records = [record for each in read for record in each.records]
    found: list[AuditedAnswer] = []
    with (
        bar("auditing", len(records)) as progress,
        audit_each(records, open_bank(bank), formulas=report is not None) as each_found,
    ):
        for record, outcomes in zip(records, each_found, strict=True):
            progress(record.id)
            found += outcomes
    if report is not None:
        from corollary.render.audit_page import audit_page

        report.write_text(audit_page(found), encoding="utf-8")
    if as_json:
        answer([each.as_json() for each in found])
    else:
        _show(found)
        if report is not None:
            print(f"{report} is written")
    for each in read:
        if each.trouble:
            say(f"corollary: {each.trouble}")
    if any(each.finding in FAULTS for each in found):
        return FAILS
    nothing_read = all(each.trouble for each in read)
    return REFUSED if nothing_read or any(each.no_such_file for each in read) else HOLDS


def _show(found: list[AuditedAnswer]) -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for heading in ("id", "asked", "published", "derived", "finding", "why"):
        table.add_column(heading, overflow="fold")
    for each in found:
        colour = COLOURS.get(each.finding, "red")
        cells: list[Any] = [each.record.id, each.asked, each.published, each.derived]
        table.add_row(
            *map(Text, map(visible, cells)), Text(each.finding, colour), Text(visible(each.sentence))
        )
    out = console()
    out.print(table)
    counts = Counter(each.finding for each in found)
    words = ", ".join(f"{counts[name]} {name}" for name in FINDINGS if counts[name])
    out.print(f"{counted(len(found), 'published answer')}: {words}")
    for isolation in dict.fromkeys(each.record.isolation for each in found if each.record.isolation):
        out.print(f"server.py was run at isolation {isolation}", highlight=False, soft_wrap=True)
