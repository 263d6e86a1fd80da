"""`corollary term`: totals over sets, who is missing, and misconceptions through the term."""

from __future__ import annotations

from pathlib import Path

from corollary.atomic import write_whole
from corollary.cli.ending import HOLDS, answer, say
from corollary.cli.told_dates import now
from corollary.messages import few
from corollary.nbgrader.written_marks import current_manual
from corollary.problem.csv_table import table_text
from corollary.records.files import ids_in, open_course
from corollary.records.misconception_history import by_misconception, followed, names_of
from corollary.records.settings import read_settings
from corollary.records.term import read_term
from corollary.records.term_tables import history_rows, mail_rows, term_record, totals_rows


def run(
    course: Path,
    as_json: bool,
    output: Path | None,
    csv: Path | None,
    missing: Path | None,
    misconceptions: Path | None,
    practice_sheets: Path | None,
    section: str | None,
    group: str | None,
) -> int:
    opened = open_course(course)
    rules = read_settings(opened.folder).term
    only = ids_in(opened, section, group)
    term = read_term(opened, rules, current_manual(opened), now(), only)
    names = names_of(term)
    if names.unread:
        say(
            f"misconceptions of {few(list(names.unread))} go by their sentences, since the solution cannot be read"
        )
    lines = followed(term, names)
    in_class = by_misconception(lines)
    tables = {
        csv: lambda: totals_rows(term),
        missing: lambda: mail_rows(term),
        misconceptions: lambda: history_rows(term, lines),
    }
    for place, rows in tables.items():
        if place is not None:
            _write(place, table_text(rows()))
    if output is not None:
        from corollary.render.term_page import term_page  # brings the templates

        _write(output, term_page(term, lines, in_class))
    if practice_sheets is not None:
        from corollary.cli.practice_sheets import write_practice_sheets  # brings the derivations

        write_practice_sheets(practice_sheets, opened, term, lines, names)
    if as_json:
        answer(term_record(term, lines, in_class))
    elif not any((csv, missing, misconceptions, output, practice_sheets)):
        from corollary.cli.terminal import console
        from corollary.render.term_page import terminal

        console().print(terminal(term, in_class))
    return HOLDS


def _write(place: Path, text: str) -> None:
    """For the instructor alone: marks and names stand in it."""
    write_whole(place, text, mode=0o600)
    say(f"written to {place}")
