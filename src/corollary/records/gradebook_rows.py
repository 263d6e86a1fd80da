"""Rows of one student in a database of nbgrader, found by its foreign keys, and removed with all free pages."""

from __future__ import annotations

import sqlite3
import tempfile
from collections import defaultdict
from contextlib import closing
from pathlib import Path

MAGIC = b"SQLite format 3\x00"
ROOT = "student"
Rows = dict[str, list[dict[str, object]]]


def is_database(content: bytes) -> bool:
    return content.startswith(MAGIC)


def rows_of(path: Path, student: str) -> Rows:
    """Every row that leads to a student by foreign keys, by table; none in a database without students."""
    with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=10)) as database:
        return _named(database, _found(database, student))


def remove_rows(path: Path, student: str) -> None:
    """Deletes them, overwrites what they held, and leaves no free page. Raises sqlite3.Error."""
    with closing(sqlite3.connect(path, timeout=10, isolation_level=None)) as database:
        database.execute("PRAGMA secure_delete = ON")
        database.execute("BEGIN IMMEDIATE")
        for table, numbers in reversed(list(_found(database, student).items())):
            database.executemany(
                f'DELETE FROM "{table}" WHERE rowid = ?', [(number,) for number in sorted(numbers)]
            )
        database.execute("COMMIT")
        database.execute("VACUUM")
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")


def without_rows(content: bytes, student: str) -> tuple[bytes, Rows]:
    """The same for a copy that lies in an archive, or beside the gradebook: the rest, and the rows."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "copy.db")
        path.write_bytes(content)
        try:
            rows = rows_of(path, student)
            if not any(rows.values()):
                return content, {}
            remove_rows(path, student)
        except sqlite3.Error as error:
            raise ValueError(f"a damaged database: {error}") from None
        return path.read_bytes(), rows


def _found(database: sqlite3.Connection, student: str) -> dict[str, set[int]]:
    """The row numbers by table, each after the tables that it refers to."""
    tables = [
        name
        for (name,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'")
        if not name.startswith("sqlite_")
    ]
    if ROOT not in tables:
        return {}
    keys: dict[str, list[tuple[str, str, str]]] = defaultdict(
        list
    )  # of a table: column, the other table, its column
    for table in tables:
        for row in database.execute(f'PRAGMA foreign_key_list("{table}")'):
            keys[row[2]].append((table, row[3], row[4] or "id"))
    found: dict[str, set[int]] = {
        ROOT: {row[0] for row in database.execute(f'SELECT rowid FROM "{ROOT}" WHERE id = ?', (student,))}
    }
    todo = [ROOT]
    while todo:
        parent = todo.pop(0)
        for table, column, other in keys[parent]:
            numbers = set[int]()
            for number in found[parent]:
                sentence = f'SELECT rowid FROM "{table}" WHERE "{column}" = (SELECT "{other}" FROM "{parent}" WHERE rowid = ?)'
                numbers |= {row[0] for row in database.execute(sentence, (number,))}
            if numbers - found.get(table, set()):
                found[table] = found.pop(table, set()) | numbers
                todo.append(table)
    return {table: numbers for table, numbers in found.items() if numbers}


def _named(database: sqlite3.Connection, found: dict[str, set[int]]) -> Rows:
    rows: Rows = {}
    for table, numbers in found.items():
        cursor = database.execute(f'SELECT * FROM "{table}" LIMIT 0')
        names = [each[0] for each in cursor.description]
        rows[table] = [
            dict(zip(names, row, strict=True))
            for number in sorted(numbers)
            for row in database.execute(f'SELECT * FROM "{table}" WHERE rowid = ?', (number,))
        ]
    return rows
