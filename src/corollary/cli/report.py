"""`corollary report`: what an instructor reads."""

from __future__ import annotations

import os
from pathlib import Path

from corollary.cli.console import console
from corollary.cli.ending import HOLDS, answer, say
from corollary.course.up_to_date import up_to_date
from corollary.records.files import open_course
from corollary.records.origin import set_of
from corollary.records.report_model import report_record
from corollary.records.settings import read_settings


def run(name: str, course: Path, bank: Path | None, as_json: bool, output: Path | None) -> int:
    opened = open_course(course)
    _, problem_set = set_of(opened, name, bank)
    found = up_to_date(opened, problem_set)
    if output is not None:
        from corollary.render.report_page import report_page  # brings the templates

        way = Path(os.path.relpath(opened.folder, output.resolve().parent)).as_posix()
        formgrader = read_settings(opened.folder).formgrader
        output.write_text(
            report_page(found, problem_set, formgrader=formgrader, course=way), encoding="utf-8"
        )
        say(f"written to {output}")
    if as_json:
        answer(report_record(found))
    elif output is None:
        from corollary.render.report_table import terminal

        console().print(terminal(found))
    return HOLDS
