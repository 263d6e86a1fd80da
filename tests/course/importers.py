"""What Moodle's and Canvas's importers do with a file of marks, by rules read in their sources; each raises Refused where they do.

Moodle: `lib/csvlib.class.php`, `grade/import/csv/classes/load_data.php`. Canvas: `lib/gradebook_importer.rb`. Rules, not their code.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping


class Refused(Exception):
    """The importer takes nothing of the file."""


def moodle(
    content: bytes, map_from: str, users: Mapping[str, str], column: str, decimal: str = "."
) -> dict[str, float | None]:
    """The marks that come into an assignment, by user, from a column; `users` by what they are in the column `map_from`.

    UTF-8 with or without its mark and commas, as the form has them at first; the separator of decimals is the language's.
    """
    text = content.decode("utf-8").removeprefix("\ufeff")
    head, *rows = list(csv.reader(io.StringIO(text, newline="")))
    head = [cell.strip() for cell in head]
    if any(len(row) != len(head) for row in rows):
        raise Refused("a row has another number of cells than the first")
    if head.count(map_from) != 1 or head.count(column) != 1:
        raise Refused("a column that is mapped is not there, or twice")
    found: dict[str, float | None] = {}
    user = None
    for row in rows:
        given, mark = row[head.index(map_from)].strip(), row[head.index(column)].strip()
        if given not in ("", "0"):  # a blank leaves the user of the row above
            if given not in users:
                raise Refused(f"nobody is {given}")
            user = users[given]
        if user is None:
            raise Refused("no user in the first row")
        if mark in ("", "-"):
            found[user] = None
            continue
        number = mark.replace(decimal, ".")
        if not re.fullmatch(r"[+-]?(\d+(\.\d*)?|\.\d+)", number):
            raise Refused(f"{mark} is not a number")
        if float(number) > 100:
            raise Refused(f"{mark} is too large")
        found[user] = float(number)
    return found


class Canvas:
    """A course of Canvas's: students by Canvas's number, each with a name, a SIS id and a login."""

    def __init__(self, students: Mapping[str, tuple[str, str, str]]):
        self.students = students

    def taken(self, content: bytes, title: str) -> tuple[dict[str, str], list[str], float | None]:
        """Marks by number of the student, names of whom it would ask, and what the assignment is out of then."""
        lines = content.decode("utf-8").splitlines()[:3]
        widths = {mark: {len(row) for row in csv.reader(lines, delimiter=mark)} for mark in ";,"}
        counts = {mark: next(iter(each)) if len(each) == 1 else 0 for mark, each in widths.items()}
        delimiter = ";" if counts[";"] > counts[","] else ","
        rows = list(csv.reader(io.StringIO(content.decode("utf-8"), newline=""), delimiter=delimiter))
        head, *rows = [[self._number(cell) for cell in row] for row in rows]
        if len(head) <= 3 or "Student" not in head[0] or "ID" not in head[1]:
            raise Refused("the first columns are not Student and ID")
        columns = (
            4
            if "SIS Login ID" in head[2]
            else 5
            if "SIS User ID" in head[2] and "SIS Login ID" in head[3]
            else 3
        )
        if "Section" not in head[columns - 1]:
            raise Refused("no Section before the assignments")
        at = next(
            place for place in range(columns, len(head)) if re.sub(r" \(\d+\)$", "", head[place]) == title
        )
        found: dict[str, str] = {}
        asked: list[str] = []
        out_of = None
        for row in rows:
            if "Points Possible" in row[0]:
                out_of = float(row[at])
                continue
            number = self._student(row, columns)
            if number is None:
                asked.append(row[0])
            else:
                found[number] = row[at].strip()
        return found, asked, out_of

    def _student(self, row: list[str], columns: int) -> str | None:
        if row[1] in self.students:
            return row[1]
        sis, login = (row[2], row[3]) if columns == 5 else ("", row[2] if columns == 4 else "")
        for place, given in ((1, sis), (2, login)):
            for number, about in self.students.items():
                if given and about[place] == given:
                    return number
        for number, (name, *_) in self.students.items():
            last, first = name.split(", ")
            if row[0] in (name, f"{first} {last}"):
                return number
        return None

    @staticmethod
    def _number(cell: str) -> str:
        """`1.234,5` and `1,234.5` are one number for it; text stays."""
        if not re.fullmatch(r"-?[0-9.,]+%?", cell):
            return cell
        *before, last = re.split("[,.]", cell)
        return f"{''.join(before)}.{last}" if before else last
