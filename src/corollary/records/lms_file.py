"""Files of marks as an LMS exports them, filled in: columns, ids, encoding, and whom each row is about."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from pathlib import Path

from corollary.messages import few, visible
from corollary.problem.csv_table import Cells, read_cells
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.roster import HEADINGS, columns_of, is_nobody
from corollary.records.lms_names import Directory
from corollary.records.marks_table import Column, MarksTable, Notation

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


# The column of Moodle's grading worksheet, in a few languages; the next one says what it is out of.
WORKSHEET = frozenset({"grade", "bewertung", "karakter", "note", "calificación"})
# Moodle's "Assignment: Week 1 (Real)", Canvas's "Week 1 (1234)".
KIND = re.compile(r"[^:]{1,40}:\s*(?=\S)")
AS_POINTS = re.compile(r"\s*\((?:real|\d+)\)$")
MARK = re.compile(r"-?\d+(?:[.,]\d+)?$")
WITH_COMMA = re.compile(r"-?\d+,\d+$")
DECIMAL = re.compile(r"-?\d+[.,]\d+$")
NO_MARK = ("", "-")
POINTS = "points possible"


@dataclass(frozen=True, slots=True)
class FilledIn:
    """`strangers` are people of the file who are not in the course, `absent` ids of students who are not in the file, `notes`
    what else is to be known."""

    content: bytes
    strangers: tuple[str, ...]
    absent: tuple[str, ...]
    notes: tuple[str, ...]


def fill_in(path: Path, table: MarksTable, headings: Sequence[str] = ()) -> FilledIn:
    """The file with the marks of the table. `headings` name the file's columns (or give their numbers from 1) for those of the
    table, in their order; when left out they are found by their titles. Raises Malformed."""
    cells = read_cells(path, HEADINGS)
    if not cells.rows:
        raise _refused(path, "is empty; export the marks from the LMS and give that file")
    first = cells.values(0)
    places = _named(path, first, table, headings) if headings else _by_title(path, first, table)
    rows = [(row, cells.values(row)) for row in range(1, len(cells.rows))]
    people = row_owners(Directory(table.students), first, rows)
    if not people.students:
        raise _refused(path, f"names no student of the course; its columns are {', '.join(first)}")
    notation = replace(table.notation, point="," if _with_commas(rows, places) else ".")
    texts, overlooked = _texts(cells, replace(table, notation=notation), places, people)
    present = set(people.students.values())
    notes = [
        *_on_people(rows, people),
        *_on_scale(rows, first, places, notation),
        *_on_excused(rows, first, places, people),
        *(f"{column}: the file has a mark and the course has none, so it is unchanged: {few(who)}"
          for column, who in overlooked.items()),
    ]  # fmt: skip
    return FilledIn(
        cells.changed(texts),
        tuple(_called(cells.values(row)) for row in people.strangers),
        tuple(student.id for student in table.students if student.id not in present),
        tuple(notes),
    )


def _texts(
    cells: Cells, table: MarksTable, places: dict[int, Column], people: RowOwners
) -> tuple[dict[tuple[int, int], str], dict[str, list[str]]]:
    """What is written where; and whose marks in the file are not touched, by heading.

    Whoever has no mark here keeps what the file says (Moodle's -, Canvas's EX); an excused student's mark goes.
    """
    texts: dict[tuple[int, int], str] = {}
    overlooked: dict[str, list[str]] = {}
    roster = {student.id: student for student in table.students}
    for row, owner in people.students.items():
        student = roster[owner]
        for at, column in places.items():
            there = cells.rows[row][at].text if at < len(cells.rows[row]) else None
            if there is None:
                raise _refused(
                    cells.path, f"the row of {student.name} has too few cells; export the file again"
                )
            is_mark = MARK.match(there) is not None
            if student.id in column.marks or (student.id in column.excused and is_mark):
                texts[row, at] = table.cell(student, column)
            elif is_mark:
                overlooked.setdefault(cells.rows[0][at].text, []).append(student.name)
    return texts, overlooked


def _by_title(path: Path, first: Sequence[str], table: MarksTable) -> dict[int, Column]:
    found: dict[int, Column] = {}
    for column in table.columns:
        titles = {folded(title) for title in (column.title, *column.also)}
        at = [place for place, heading in enumerate(first) if titles & set(_titles(heading))]
        if not at and len(table.columns) == 1:
            at = [place for place, heading in enumerate(first) if folded(heading) in WORKSHEET]
        if len(at) != 1:
            sentence = "several columns" if at else "no column"
            raise _refused(
                path,
                f"has {sentence} for {column.title}; its columns are {', '.join(first)}; say which with --column",
            )
        found[at[0]] = column
    return found


def _named(path: Path, first: Sequence[str], table: MarksTable, headings: Sequence[str]) -> dict[int, Column]:
    if len(headings) != len(table.columns):
        titles = ", ".join(column.title for column in table.columns)
        raise _refused(path, f"is to get {titles}: name a column for each with --column, in this order")
    lower, found = [folded(heading) for heading in first], dict[int, Column]()
    for heading, column in zip(headings, table.columns, strict=True):
        if folded(heading) in lower:
            found[lower.index(folded(heading))] = column
        elif heading.isdecimal() and 1 <= int(heading) <= len(first):
            found[int(heading) - 1] = column
        else:
            raise _refused(path, f"has no column {heading}; its columns are {', '.join(first)}")
    return found


def _titles(heading: str) -> Iterator[str]:
    """What a heading may be the title of."""
    heading = folded(heading)
    for text in (heading, AS_POINTS.sub("", heading)):
        yield text
        yield KIND.sub("", text, count=1)


def _on_people(rows: Sequence[tuple[int, Sequence[str]]], people: RowOwners) -> Iterator[str]:
    called = {row: _called(values) for row, values in rows}
    if people.unclear:
        who = [called[row] for row in people.unclear]
        yield f"the ids name different students, so nothing is written for: {few(who)}"
    if people.by_name:
        who = [called[row] for row in people.by_name]
        yield f"matched by name alone, since no id is known: {few(who)}"


def _on_scale(
    rows: Sequence[tuple[int, Sequence[str]]],
    first: Sequence[str],
    places: dict[int, Column],
    notation: Notation,
) -> Iterator[str]:
    """Where the file says that marks are out of something else than they are here."""
    for at, column in places.items():
        if folded(first[at]) in WORKSHEET:
            cells = [values[at + 1] for _, values in rows[:1] if at + 1 < len(values)]
        else:
            cells = [values[at] for _, values in rows if POINTS in folded(values[0]) and at < len(values)]
        theirs = next((float(cell.replace(",", ".")) for cell in cells if MARK.match(cell)), None)
        ours = column.out_of if notation.out_of is None else notation.out_of
        if theirs is not None and abs(theirs - ours) > 1e-6:
            yield (
                f"{first[at]} is out of {theirs:g} in the file and out of {ours:g} here; --out-of {theirs:g} scales the marks"
            )


def _on_excused(
    rows: Sequence[tuple[int, Sequence[str]]],
    first: Sequence[str],
    places: dict[int, Column],
    people: RowOwners,
) -> Iterator[str]:
    """Whose mark stays in Moodle (4.1, 4.5), which leaves a mark alone where its worksheet is blank."""
    worksheet = {at: column for at, column in places.items() if folded(first[at]) in WORKSHEET}
    who = [
        _called(values)
        for row, values in rows
        for at, column in worksheet.items()
        if people.students.get(row) in column.excused and MARK.match(values[at])
    ]
    if who:
        yield (
            "excused, with a mark in the worksheet: the cell is blank now, and Moodle keeps the mark then; take it away there: "
            f"{few(who)}"
        )


def _with_commas(rows: Sequence[tuple[int, Sequence[str]]], places: Collection[int]) -> bool:
    """Whether the file writes decimal commas: in the columns to fill in, or else in one that holds nothing but marks; an id may
    be `12,5` anywhere."""
    columns = {at: [cell for cell in column if cell not in NO_MARK]
               for at, column in enumerate(zip_longest(*(values for _, values in rows), fillvalue=""))}  # fmt: skip
    own = [cell for at in places for cell in columns.get(at, []) if DECIMAL.match(cell)]
    if own:
        return any(WITH_COMMA.match(cell) for cell in own)
    marks = (cells for cells in columns.values() if all(MARK.match(cell) for cell in cells))
    return any(WITH_COMMA.match(cell) for cells in marks for cell in cells)


def _called(values: Sequence[str]) -> str:
    """What a person of the file is called, by the first cells that are filled."""
    return visible(" ".join([value for value in values if value][:2]))


def folded(text: str) -> str:
    """Equal for headings that differ in capitals and spaces."""
    return " ".join(text.casefold().split())


def _refused(path: Path, sentence: str) -> Malformed:
    return Malformed([Diagnostic(path, 1, sentence)])
