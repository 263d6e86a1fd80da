"""A roster: the students of a course, from a CSV file as nbgrader has them."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed

COLUMNS = ("id", "first_name", "last_name", "email")
ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.@-]{0,99}$")


@dataclass(frozen=True, slots=True)
class Student:
    id: str
    first_name: str = ""
    last_name: str = ""
    email: str = ""

    @property
    def name(self) -> str:
        return " ".join(part for part in (self.first_name, self.last_name) if part) or self.id


def read_roster(path: Path) -> tuple[Student, ...]:
    """The students of a CSV file with the column `id`, in its order. Raises Malformed."""
    columns, rows = _rows(path)
    if not rows:
        raise Malformed(
            [
                Diagnostic(
                    path, 1, f"lists no students; the first line names the columns ({', '.join(COLUMNS)})"
                )
            ]
        )
    if "id" not in columns:
        raise Malformed([Diagnostic(path, 1, f"has no column `id`; its columns are {', '.join(columns)}")])
    complaints, students, lines = [], [], {}
    for line, row in rows:
        student = Student(*(row.get(name, "") for name in COLUMNS))
        if not ID.match(student.id):
            sentence = f"id {student.id!r} will not do as a folder's name; use letters, digits, _ . @ -"
            complaints.append(Diagnostic(path, line, sentence))
        elif (first := lines.setdefault(student.id, line)) != line:
            sentence = (
                f"id {student.id} stands on line {first} already; every student needs an id of their own"
            )
            complaints.append(Diagnostic(path, line, sentence))
        students.append(student)
    if complaints:
        raise Malformed(complaints)
    return tuple(students)


def _rows(path: Path) -> tuple[list[str], list[tuple[int, dict[str, str]]]]:
    """The columns, and each row that is not blank with the line it ends on."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            table = csv.reader(file)
            columns = [name.strip() for name in next(table, [])]
            cells = [(table.line_num, row) for row in table if any(row)]
    except OSError as error:
        raise Malformed([Diagnostic(path, 1, f"cannot be read: {error.strerror}")]) from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise Malformed([Diagnostic(path, 1, f"cannot be read: {error}; save it as CSV in UTF-8")]) from None
    return columns, [(line, dict(zip(columns, map(str.strip, row), strict=False))) for line, row in cells]
