"""A roster: the students of a course, from a CSV file as nbgrader has them."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.complaint import Complaint, Malformed

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
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = list(csv.DictReader(file))
            columns = rows[0].keys() if rows else ()
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Malformed([Complaint(path, 1, f"cannot be read: {error}")]) from None
    if not rows:
        raise Malformed([Complaint(path, 1, "lists no students; the first line names the columns (id, first_name, last_name, email)")])
    if "id" not in columns:
        raise Malformed([Complaint(path, 1, f"has no column `id`; its columns are {', '.join(str(name) for name in columns)}")])
    complaints, students, lines = [], [], {}
    for line, row in enumerate(rows, 2):
        id = (row["id"] or "").strip()
        if not ID.match(id):
            complaints.append(Complaint(path, line, f"id {id!r} will not do as a folder's name; use letters, digits, _ . @ -"))
        elif id in lines:
            complaints.append(Complaint(path, line, f"id {id} stands on line {lines[id]} already; every student needs an id of their own"))
        lines.setdefault(id, line)
        students.append(Student(id, *((row.get(name) or "").strip() for name in ("first_name", "last_name", "email"))))
    if complaints:
        raise Malformed(complaints)
    return tuple(students)
