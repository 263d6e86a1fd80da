"""Separation of one student's data from the rest of a file: records, journals, tables, logs, archives, databases."""

from __future__ import annotations

import bz2
import csv
import gzip
import io
import json
import lzma
import re
import tarfile
import zipfile
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, cast

from corollary.records.gradebook_rows import is_database, without_rows
from corollary.records.person import Person

REMOVED = "[removed]"
OWNER = frozenset(
    {"student", "other", "id", "username", "user", "email", "owner", "who", "student_id", "by_student"}
)
SENTENCES = frozenset({"why", "note", "notes", "trouble", "what", "remarks", "file", "sentence"})
"""Fields with a sentence of this program, in which a name can be taken out; what a person wrote stays, and is listed."""
ENTRY = re.compile(r"^(?=\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC )", re.MULTILINE)
MOST_BYTES, DEEPEST = 1 << 30, 3  # of a member of an archive, and archives within archives
TABLES = (".csv", ".tsv")
SHORT_CELL = 3  # letters of a cell that means somebody in whatever column
PACKING = {b"\x1f\x8b": gzip.compress, b"BZ": bz2.compress, b"\xfd7": lzma.compress}


@dataclass(frozen=True, slots=True)
class Separated:
    """`rest` is the file without the student's data (None: all of it was theirs), `theirs` their part as files by name,
    `entries` how many records, rows or members were theirs."""

    rest: bytes | None
    theirs: tuple[tuple[str, bytes], ...] = ()
    entries: int = 0

    @property
    def is_changed(self) -> bool:
        return self.rest is None or self.entries > 0


def separate(parts: Sequence[str], content: bytes, person: Person, depth: int = 0) -> Separated:
    """What of a file is one student's; `parts` is its path in the course or the archive. A file that cannot be read as its name
    says is left as it is."""
    name = parts[-1].lower()
    if person.owns_path(parts):
        return Separated(None, ((parts[-1], content),), 1)
    try:
        if zipfile.is_zipfile(io.BytesIO(content)):
            return _zip(content, person, depth)
        if is_database(content):
            rest, rows = without_rows(content, person.id)
            return Separated(rest, _as_json(rows), sum(map(len, rows.values())))
        if name.endswith((".tar", ".tgz", ".tar.gz", ".tar.xz", ".tar.bz2")):
            return _tar(content, person, depth)
        if name.endswith(".ipynb"):
            return _notebook(parts, content, person)
        if name.endswith(".jsonl"):
            return _journal(content, person)
        if name.endswith(".json"):
            return _json(content, person)
        if name.endswith(TABLES):
            return _table(content, person)
        if name.endswith(".log"):
            return _log(content, person)
    except (ValueError, csv.Error, zipfile.BadZipFile, tarfile.TarError, NotImplementedError, RuntimeError):
        return Separated(
            content
        )  # damaged, or not what its name says; a mention in it is found by the search afterwards
    return Separated(content)


def mentions(content: bytes, person: Person) -> int:
    """How often a text that is not the student's own names them; an archive is looked into by its members."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    return len(person.pattern.findall(text))


def _notebook(parts: Sequence[str], content: bytes, person: Person) -> Separated:
    """A notebook that says whose sheet it is; in another student's folder it is that student's."""
    about = json.loads(content).get("metadata", {}).get("corollary", {})
    if person.owns_path(parts) is None and person.is_named_by(about.get("student")):
        return Separated(None, ((parts[-1], content),), 1)
    return Separated(content)


def _json(content: bytes, person: Person) -> Separated:
    value = json.loads(content)
    rest, theirs = _split(value, person, "")
    if not theirs and rest == value:
        return Separated(content)
    if rest is _NOTHING:
        return Separated(None, _as_json(theirs), max(1, len(theirs)))
    written = _written(rest, content)
    return Separated(written, _as_json(theirs), max(1, len(theirs)))


def _written(value: object, before: bytes) -> bytes:
    """JSON in the layout that the file had."""
    if before.startswith((b"{\n", b"[\n")):
        indent = len(before.split(b"\n", 2)[1]) - len(before.split(b"\n", 2)[1].lstrip())
        end = b"\n" if before.endswith(b"\n") else b""
        return json.dumps(value, indent=indent, ensure_ascii=False).encode() + end
    tight = b'": ' not in before[:200]
    separators = (",", ":") if tight else (", ", ": ")
    return json.dumps(value, ensure_ascii=False, separators=separators).encode()


def _journal(content: bytes, person: Person) -> Separated:
    """Lines of JSON, of which each is whole; those of others stay as they are, byte by byte, unless they name the student."""
    rest, theirs = list[bytes](), list[object]()
    for line in content.splitlines(keepends=True):
        try:
            value = json.loads(line)
        except ValueError:
            if not mentions(line, person):  # cut short; nobody can say whose it is
                rest.append(line)
            continue
        left, own = _split(value, person, "")
        theirs += own
        if left is _NOTHING:
            continue
        rest.append(line if left == value else _written(left, line) + b"\n")
    joined = b"".join(rest)
    return Separated(joined, _as_json(theirs), max(len(theirs), joined != content))


_NOTHING = object()


def _split(value: Any, person: Person, key: str) -> tuple[Any, list[object]]:
    """What remains of a value, and the student's parts of it; `key` is the field that it stands in."""
    match value:
        case dict():
            record = cast(dict[str, Any], value)
            if _is_theirs(record, person):
                return _NOTHING, [record]
            by_student = bool(record) and record.keys() <= person.everybody
            rest, theirs = dict[str, Any](), list[object]()
            for name, each in record.items():
                if by_student and name == person.id:
                    theirs.append({name: each})
                    continue
                left, own = _split(each, person, name)
                theirs += own
                if left is not _NOTHING:
                    rest[name] = left
            return rest, theirs
        case list():
            items = cast(list[Any], value)
            names = all(isinstance(each, str) and each in person.everybody for each in items)
            others, theirs = list[Any](), list[object]()
            for each in items:
                if names and each == person.id:
                    theirs.append(each)
                    continue
                left, own = _split(each, person, key)
                theirs += own
                if left is not _NOTHING:
                    others.append(left)
            return others, theirs
        case str() if key in SENTENCES:
            return person.pattern.sub(REMOVED, value), []
        case _:
            return value, []


def _is_theirs(record: dict[str, Any], person: Person) -> bool:
    owners = [value for key, value in record.items() if key in OWNER and isinstance(value, str)]
    if any(map(person.is_identified_by, owners)):
        return True
    if any(map(person.is_named_by, owners)) and not any(map(person.is_another, owners)):
        return True
    if record.get("number") in person.own_number:
        return True
    file = record.get("file")  # a file that came and of which nobody knew whose it is
    return isinstance(file, str) and not record.get("student") and person.owns_path(file.split("/")) is True


def _as_json(theirs: object) -> tuple[tuple[str, bytes], ...]:
    if not theirs:
        return ()
    return (("records.json", json.dumps(theirs, indent=1, ensure_ascii=False, default=str).encode()),)


def _table(content: bytes, person: Person) -> Separated:
    """Rows of a CSV file; those that remain keep their bytes."""
    encoding = "utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8"
    try:
        text = content.decode(encoding)
    except UnicodeDecodeError:
        encoding, text = "latin-1", content.decode("latin-1")
    first = text.partition("\n")[0]
    delimiter = max(",;\t|", key=first.count)
    lines = text.splitlines(keepends=True)
    reader, start = csv.reader(lines, delimiter=delimiter), 0
    rows = [(row, reader.line_num) for row in reader]
    columns = _columns_of_ids([row for row, _ in rows], person)
    rest, theirs, head = list[str](), list[object](), list[str]()
    for row, end in rows:
        if not head:
            head = [cell.strip().lower().lstrip("\ufeff") for cell in row]
        elif _row_is_theirs(head, row, person, columns):
            theirs.append(dict(zip(head, row, strict=False)))
            start = end
            continue
        rest += lines[start:end]
        start = end
    return Separated("".join(rest).encode(encoding) if theirs else content, _as_json(theirs), len(theirs))


def _row_is_theirs(head: Sequence[str], row: Sequence[str], person: Person, columns: Collection[int]) -> bool:
    """By an id, an address or a number, unless somebody else's stands before it (the first of a pair has the row); by the name where
    none of these is another's. `columns` are those in which the table has the student's id: whoever has another one there is another."""
    cells = [cell.strip() for cell in row]
    moodles = {number.partition(" ")[2] for number in person.own_number if number.startswith("moodle ")}
    theirs = {number.partition(" ")[2] for number in person.strangers if number.startswith("moodle ")}
    named = another = False
    for at, (heading, cell) in enumerate(zip((*head, *[""] * len(row)), cells, strict=False)):
        of_ids = any(word in heading for word in ("id", "user", "student", "mail", "login", "number"))
        others = person.is_of_another(cell) or (not named and cell in person.others_names)
        if others and (heading in OWNER or len(cell) >= SHORT_CELL):
            return False
        if of_ids or len(cell) >= SHORT_CELL:
            if person.is_identified_by(cell):
                return True
            named = named or person.is_named_by(cell)
        if heading.startswith("identifier"):
            number = cell.rpartition(" ")[2]
            if number in moodles:
                return True
            another = another or number in theirs
        another = another or (of_ids and person.is_another(cell)) or (at in columns and bool(cell))
    if another or person.namesakes:
        return False
    first, last = person.student.first_name, person.student.last_name
    return named or (
        bool(first and last) and any(pair in ((first, last), (last, first)) for pair in pairwise(cells))
    )


def _columns_of_ids(rows: Sequence[Sequence[str]], person: Person) -> frozenset[int]:
    """The columns in which a row has the student's id, address or number."""
    found = (
        (at, cell.strip()) for row in rows for at, cell in enumerate(row) if len(cell.strip()) >= SHORT_CELL
    )
    return frozenset(at for at, cell in found if person.is_identified_by(cell))


def _log(content: bytes, person: Person) -> Separated:
    """Entries that begin with a moment and a student; in others' the name is taken out."""
    text = content.decode("utf-8", "surrogateescape")
    rest, theirs = list[str](), list[str]()
    for entry in ENTRY.split(text):
        whose = re.match(r"\S+ \S+ UTC ([^\n]*?): ", entry)
        if whose and (person.is_named_by(whose[1]) or person.owns_path(whose[1].split("/"))):
            theirs.append(entry)
        else:
            rest.append(person.pattern.sub(REMOVED, entry))
    written = "".join(rest).encode("utf-8", "surrogateescape")
    return Separated(written, _as_json(theirs), max(len(theirs), written != content))


def _zip(content: bytes, person: Person, depth: int) -> Separated:
    if depth >= DEEPEST:
        return Separated(content)
    target, theirs = io.BytesIO(), list[tuple[str, bytes]]()
    with zipfile.ZipFile(io.BytesIO(content)) as archive, zipfile.ZipFile(target, "w") as rest:
        rest.comment = archive.comment
        for member in archive.infolist():
            parts = [part for part in member.filename.split("/") if part]
            if not parts or member.file_size > MOST_BYTES:
                raise ValueError("a member that cannot be read")
            if member.is_dir():
                if not person.owns_path(parts):
                    rest.writestr(member, b"")
                continue
            held = archive.read(member)
            done = _member(parts, held, person, depth)
            theirs += [
                (member.filename if done.rest is None else f"{member.filename}/{name}", each)
                for name, each in done.theirs
            ]
            if done.rest is not None:
                rest.writestr(member, done.rest, member.compress_type)
    return Separated(target.getvalue() if theirs else content, tuple(theirs), len(theirs))


def _member(parts: Sequence[str], held: bytes, person: Person, depth: int) -> Separated:
    """One file of an archive; what stands below another student's name is that student's, whatever it holds."""
    if person.owns_path(parts) is False:
        return Separated(held)
    return separate(parts, held, person, depth + 1)


def _tar(content: bytes, person: Person, depth: int) -> Separated:
    if depth >= DEEPEST:
        return Separated(content)
    target, theirs = io.BytesIO(), list[tuple[str, bytes]]()
    with (
        tarfile.open(fileobj=io.BytesIO(content)) as archive,
        tarfile.open(fileobj=target, mode="w") as rest,
    ):
        for member in archive:
            parts = [part for part in member.name.split("/") if part not in ("", ".")]
            file = archive.extractfile(member) if member.isfile() and member.size <= MOST_BYTES else None
            if file is None:
                if not (parts and person.owns_path(parts)):
                    rest.addfile(member)
                continue
            held = file.read()
            done = _member(parts, held, person, depth)
            theirs += [(member.name, each) for _, each in done.theirs]
            if done.rest is not None:
                member.size = len(done.rest)
                rest.addfile(member, io.BytesIO(done.rest))
    if not theirs:
        return Separated(content)
    packing = PACKING.get(content[:2])
    written = packing(target.getvalue()) if packing else target.getvalue()
    return Separated(written, tuple(theirs), len(theirs))


def texts_within(parts: Sequence[str], content: bytes, depth: int = 0) -> Iterator[tuple[str, bytes]]:
    """A file as it can be searched: an archive by its members, with the way to each."""
    where = "/".join(parts)
    if depth < DEEPEST and zipfile.is_zipfile(io.BytesIO(content)):
        try:
            with zipfile.ZipFile(io.BytesIO(content)) as archive:
                for member in archive.infolist():
                    if not member.is_dir() and member.file_size <= MOST_BYTES:
                        yield f"{where}/{member.filename}", member.filename.encode()
                        yield from texts_within((where, member.filename), archive.read(member), depth + 1)
        except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError):
            yield where, content
    else:
        yield where, content
