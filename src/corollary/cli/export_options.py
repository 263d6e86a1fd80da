"""The options of `corollary export`, and which of them belong to what a target is made of."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import TypedDict

from corollary.cli.ending import refuse
from corollary.course.export import By
from corollary.render.exports import Target

USUAL_FOLDER = Path("export")


class ExportOptions(TypedDict):
    """As they were given; `sets` are also codes and topics, and for a site the folder behind them."""

    sets: Sequence[str]
    to: str | None
    person: str | None
    archive: bool
    keep_until: datetime | None
    course: Path | None
    roster: Path | None
    bank: Path | None
    variants: int | None
    solution: bool
    columns: By | None
    decimals: int | None
    out_of: float | None
    blank: str | None
    template: Path | None
    headings: Sequence[str]
    output: Path | None
    as_json: bool
    ids: Path | None
    forms: int | None
    formula_sheet: bool
    large_print: bool
    apart: bool
    left_out: Sequence[str]
    pyodide: Path | None
    practice: Path | None


def refuse_what_is_for_others(chosen: Target, given: ExportOptions) -> None:
    """Refuses the first option that the target has no use for."""
    to = given["to"]
    _refuse_options_of_paper(
        chosen, ("--formula-sheet", given["formula_sheet"]), ("--large-print", given["large_print"])
    )
    if given["practice"] is not None and chosen.feedback is None:
        refuse(f"--practice goes with feedback-zip; leave it out for {to}")
    of_students = given["roster"] is not None or given["forms"] is not None
    if given["solution"] and (chosen.site or chosen.items is not None):
        refuse(f"--solution is for sheets, and {to} always has the worked solutions; leave it out")
    if given["solution"] and (chosen.marks is not None or chosen.feedback is not None):
        refuse(f"--solution is for sheets; leave it out for {to}")
    if chosen.site:
        refuse_options_of_marks(given)
        if given["apart"]:
            refuse(f"--apart is for questions of an LMS; leave it out for {to}")
        if of_students:  # a course says what is not due yet
            refuse(f"{to} is for everybody; say how many variants of each problem with --variants")
        return
    if given["left_out"] or given["pyodide"]:
        refuse(f"--except and --pyodide are for a site; leave them out for {to}")
    if chosen.items is not None:
        refuse_options_of_marks(given)
        if of_students:
            refuse(f"{to} is a pool for everybody; say how many variants of each problem with --variants")
        return
    if given["apart"]:
        refuse(f"--apart is for questions of an LMS; leave it out for {to}")
    numbers = (given["course"], given["roster"], given["variants"], given["forms"])
    if sum(each is not None for each in numbers) > 1:
        refuse("--course, --roster, --variants and --forms each choose the numbers; give one of them")
    _refuse_options_of_paper(chosen, ("--forms", given["forms"]))


def _refuse_options_of_paper(chosen: Target, *options: tuple[str, object]) -> None:
    for option, value in options:
        if value and chosen.paper is None:
            refuse(f"{option} is for paper; leave it out, or export --to pdf")


def refuse_options_of_marks(given: ExportOptions, *, template: bool = False) -> None:
    """Refuses the first option that only marks have; `template` says that a file of the LMS is wanted all the same."""
    for option, value in (
        ("--columns", given["columns"]),
        ("--round", given["decimals"]),
        ("--out-of", given["out_of"]),
        ("--blank", given["blank"]),
        ("--column", given["headings"]),
        ("--template", None if template else given["template"]),
    ):
        if value not in (None, [], ()):
            refuse(f"{option} is for marks, and {given['to']} holds none; leave it out")
