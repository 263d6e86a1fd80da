"""`corollary audit`: somebody else's answer key held against the laws."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from corollary.audit.audit import audit_each
from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.outcome import FAULTS, FINDINGS, AuditedAnswer
from corollary.audit.readers.server_draw import ServerRuns
from corollary.cli.console import console
from corollary.cli.ending import FAILS, HOLDS, answer, counted, refuse
from corollary.cli.progress import bar
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
    stated = laws_by_id(laws)
    with ServerRuns(seeds, require) as servers:
        records = [
            record
            for name in files
            for record in records_of(Path(name), stated, servers if running else None)
        ]
    if not records:
        refuse(f"{', '.join(files)}: there are no records in it; `docs/audit.md` shows how they are written")
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
    return FAILS if any(each.finding in FAULTS for each in found) else HOLDS


def _show(found: list[AuditedAnswer]) -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for heading in ("id", "asked", "published", "derived", "finding", "why"):
        table.add_column(heading, overflow="fold")
    for each in found:
        colour = COLOURS.get(each.finding, "red")
        cells: list[Any] = [each.record.id, each.asked, each.published, each.derived]
        table.add_row(*map(Text, cells), Text(each.finding, colour), Text(each.sentence))
    out = console()
    out.print(table)
    counts = Counter(each.finding for each in found)
    words = ", ".join(f"{counts[name]} {name}" for name in FINDINGS if counts[name])
    out.print(f"{counted(len(found), 'published answer')}: {words}")
    for isolation in dict.fromkeys(each.record.isolation for each in found if each.record.isolation):
        out.print(f"server.py was run at isolation {isolation}", highlight=False, soft_wrap=True)
