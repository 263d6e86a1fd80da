"""`corollary export` of questions for an LMS: the files, and a table of what became of each part."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path

from corollary.atomic import write_files
from corollary.cli.ending import HOLDS, answer, say
from corollary.cli.export_options import USUAL_FOLDER, ExportOptions
from corollary.cli.left_out import course_around
from corollary.cli.open_sets import course_in
from corollary.cli.terminal import console
from corollary.course.item_export import Exported, export_items
from corollary.messages import few
from corollary.records.files import Course, NotACourse, open_course
from corollary.render.exports import Target


def run(chosen: Target, names: Sequence[str], given: ExportOptions) -> int:
    """Of each set, of the course too, or problem, by itself."""
    course = _course(given["course"])
    records: list[dict[str, object]] = []
    for name in names:
        made = export_items(chosen, given["bank"], name, given["variants"], given["apart"], course)
        written = [str(path) for path in write_files(given["output"] or USUAL_FOLDER, made.files)]
        records.append(
            {
                "set": name,
                "to": given["to"],
                "files": written,
                "variants": made.variants,
                "parts": [asdict(each) for each in made.parts],
                "lost": made.lost,
            }
        )
        if not given["as_json"]:
            _show(made, written, given["variants"])
    if given["as_json"]:
        answer(records[0] if len(records) == 1 else records)
    return HOLDS


def _course(named: Path | None) -> Course | None:
    """The one named, else the one around, where there is one in which something was generated."""
    if named is not None:
        return open_course(named)
    with suppress(NotACourse):
        return course_in(course_around())
    return None


def _show(made: Exported, written: Sequence[str], wanted: int | None) -> None:
    from rich.table import Table

    table = Table("part", "carried as", "not carried")
    for each in made.parts:
        table.add_row(f"{each.code} ({each.part})", each.how or "refused", each.lost)
    console().print(table)
    refused = sum(not each.how for each in made.parts)
    print(f"{len(made.parts) - refused} parts carried, {refused} refused. Of none is carried:")
    for each in made.lost:
        print(f"- {each}")
    print(f"{made.title}: {', '.join(written)}")
    fewer = [code for code, count in made.variants.items() if wanted is not None and count < wanted]
    if fewer:
        say(f"fewer than {wanted} variants exist of {few(fewer)}: all of them are written")
