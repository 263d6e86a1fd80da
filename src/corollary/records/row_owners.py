"""Whom each row of an LMS's table is about: by any id that is known of a student, else by a name that only one has."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.problem.roster import is_nobody
from corollary.problem.roster_columns import columns_of
from corollary.records.lms_names import Directory

# Canvas writes a name that begins with = as a formula that gives it.
AS_FORMULA = re.compile(r'="(.*)"$')


@dataclass(frozen=True, slots=True)
class RowOwners:
    """`students` are ids by row; `by_name`: recognized by the name alone; `strangers` are rows of somebody who is not known,
    `unclear` those whose ids contradict each other. Rows of nobody (Canvas's points, its test student) are in none."""

    students: dict[int, str]
    by_name: tuple[int, ...]
    strangers: tuple[int, ...]
    unclear: tuple[int, ...]


def row_owners(
    directory: Directory, headings: Sequence[str], rows: Sequence[tuple[int, Sequence[str]]]
) -> RowOwners:
    """Whom rows, each with its number, of a table with these headings are about."""
    columns = columns_of(headings)
    found: dict[int, str] = {}
    by_name, strangers, unclear = list[int](), list[int](), list[int]()
    for number, row in rows:

        def cell(at: int | None, row: Sequence[str] = row) -> str:
            return row[at] if at is not None and at < len(row) else ""

        names = _names(cell(columns.name), cell(columns.first_name), cell(columns.last_name))
        ids = {value for at in columns.ids if (value := cell(at))}
        if is_nobody(row) or not (ids or names):
            continue
        meant = {student for value in ids if (student := directory.by_id(value)) is not None}
        if not meant:
            meant = {student for name in names if (student := directory.by_name(name)) is not None}
            by_name += [number] if len(meant) == 1 else []
        if len(meant) == 1:
            found[number] = meant.pop()
        else:
            (unclear if meant else strangers).append(number)
    return RowOwners(found, tuple(by_name), tuple(strangers), tuple(unclear))


def _names(full: str, first: str, last: str) -> set[str]:
    formula = AS_FORMULA.match(full)
    given = formula[1] if formula else full
    return {name for name in (given, f"{first} {last}".strip()) if name}
