"""Tables of CSV files, read by cells that know their row and column, and written so that no cell is taken for a formula."""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed

DELIMITERS = (",", ";", "\t", "|")
MOST_BYTES = 50 << 20
# What people save under the name of a CSV file, by its first bytes.
NO_TABLES = {
    b"PK\x03\x04": "an Excel or LibreOffice workbook",
    b"\xd0\xcf\x11\xe0": "an Excel workbook",
    b"%PDF": "a PDF",
    b"\x1f\x8b": "a compressed file",
}
# … and what its text begins with, for those that are text.
NO_TABLES_EITHER = {"<": "a web page", "{": "JSON", "[{": "JSON"}
MARKS = {b"\xef\xbb\xbf": "utf-8-sig", b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}


@dataclass(frozen=True, slots=True)
class Table:
    """The rows of a file that are not blank, each with the line it ends on. `encoding` is Python's name of the file's."""

    path: Path
    rows: tuple[tuple[int, tuple[str, ...]], ...]
    delimiter: str
    encoding: str
    newline: str

    @property
    def first(self) -> tuple[str, ...]:
        return self.rows[0][1] if self.rows else ()

    def written(self, rows: Collection[Collection[str]]) -> bytes:
        """Other rows in the form that this file has: its delimiter, encoding and ends of lines."""
        text = io.StringIO()
        csv.writer(text, delimiter=self.delimiter, lineterminator=self.newline).writerows(rows)
        return text.getvalue().encode(self.encoding, "replace")


def read_table(path: Path, headings: Collection[str] = ()) -> Table:
    """The table in a file. `headings` are names of columns that may be met, in lower case: they help to tell the delimiter.

    Raises Malformed for what cannot be read, or is no text.
    """
    try:
        with path.open("rb") as file:
            content = file.read(MOST_BYTES + 1)
    except OSError as error:
        folder = path.is_dir()
        why = "is a folder; name the CSV file itself" if folder else f"cannot be read: {error.strerror}"
        raise _refused(path.resolve() if folder else path, why) from None
    if len(content) > MOST_BYTES:
        raise _refused(path, f"has more than {MOST_BYTES >> 20} MB, too much for a roster")
    for mark, kind in NO_TABLES.items():
        if content.startswith(mark):
            raise _refused(path, f"is {kind}; save it as CSV, in UTF-8, and give that file")
    text, encoding = _decoded(path, content)
    for mark, kind in NO_TABLES_EITHER.items():
        if text.lstrip("\ufeff \t\r\n").startswith(mark):
            raise _refused(path, f"is {kind}; give the CSV file itself")
    newline = "\r\n" if "\r\n" in text else "\n"
    head, _, rest = text.partition("\n")
    if head.strip().lower().startswith("sep=") and len(head.strip()) == 5:  # what Excel understands
        delimiter, text, skipped = head.strip()[4], rest, 1
    else:
        delimiter, skipped = _delimiter(text, headings), 0
    rows: list[tuple[int, tuple[str, ...]]] = []
    line = 1 + skipped
    try:
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
        for row in reader:
            if any(cell.strip() for cell in row):
                rows.append((reader.line_num + skipped, tuple(cell.strip() for cell in row)))
            line = reader.line_num + skipped + 1
    except csv.Error as error:
        sentence = f"a quotation mark is out of place ({error}); save it as CSV in UTF-8"
        raise _refused(path, sentence, line) from None
    return Table(path, tuple(rows), delimiter, encoding, newline)


def _decoded(path: Path, content: bytes) -> tuple[str, str]:
    """The text and its encoding: by its mark, else UTF-8 where it is that, else UTF-16 or Windows' Western European."""
    found = next((encoding for mark, encoding in MARKS.items() if content.startswith(mark)), None)
    if found is None and b"\x00" in content[:200]:
        found = "utf-16-le" if content[1:2] == b"\x00" else "utf-16-be" if content[:1] == b"\x00" else None
    for encoding in [found] if found else ["utf-8", "cp1252"]:
        try:
            text = content.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\x00" in text:
            line = text[: text.index("\x00")].count("\n") + 1
            raise _refused(path, "holds a zero byte, so it is not text; save it as CSV in UTF-8", line)
        return text, encoding
    raise _refused(path, "is in an unknown encoding (UTF-8, UTF-16, Windows-1252); save it as CSV in UTF-8")


def _delimiter(text: str, headings: Collection[str]) -> str:
    """The delimiter by which the first line holds most known headings, then the one that gives all rows as many cells."""

    def merit(delimiter: str) -> tuple[int, float, int]:
        rows = [row for row in csv.reader(io.StringIO(text, newline=""), delimiter=delimiter) if any(row)][
            :200
        ]
        widths = Counter(map(len, rows))
        width, often = widths.most_common(1)[0] if widths else (1, 0)
        known = sum(cell.strip().lower() in headings for cell in rows[0]) if rows else 0
        return known, often / max(1, len(rows)) if width > 1 else 0.0, width

    try:
        return max(DELIMITERS, key=merit)
    except csv.Error:
        return ","


def _refused(path: Path, sentence: str, line: int = 1) -> Malformed:
    return Malformed([Diagnostic(path, line, sentence)])


# With the mark of the encoding left in the text, so that it is written again.
ENCODINGS = {"utf-8-sig": "utf-8", "utf-16": "utf-16-le"}


@dataclass(frozen=True, slots=True)
class TableCell:
    """What is in a cell, and where it stands in the file's text, its quotation marks included."""

    text: str
    start: int
    end: int
    quoted: bool


@dataclass(frozen=True, slots=True)
class Cells:
    """The rows of a file that are not blank."""

    path: Path
    rows: tuple[tuple[TableCell, ...], ...]
    delimiter: str
    _text: str
    _encoding: str

    def values(self, row: int) -> tuple[str, ...]:
        return tuple(cell.text for cell in self.rows[row])

    def changed(self, texts: Mapping[tuple[int, int], str]) -> bytes:
        """The file with other texts in some cells, by row and column from 0."""
        parts, at = list[str](), 0
        for row, column in sorted(texts):
            cell = self.rows[row][column]
            parts += [self._text[at : cell.start], self._written(texts[row, column], cell.quoted)]
            at = cell.end
        return "".join([*parts, self._text[at:]]).encode(self._encoding)

    def _written(self, text: str, quoted: bool) -> str:
        if not quoted and not any(mark in text for mark in (self.delimiter, '"', "\n", "\r")):
            return text
        return '"' + text.replace('"', '""') + '"'


def read_cells(path: Path, headings: frozenset[str] = frozenset()) -> Cells:
    """The cells of a file; `headings` help to tell the delimiter. Raises Malformed for what is no table."""
    table = read_table(path, headings)
    content = path.read_bytes()
    encoding = ENCODINGS.get(table.encoding, table.encoding)
    if content.startswith(b"\xfe\xff"):
        encoding = "utf-16-be"
    text = content.decode(encoding)
    start = 1 if text.startswith("\ufeff") else 0
    if text[start : start + 4].lower() == "sep=":  # what Excel understands, and read_table too
        start = text.find("\n", start) + 1
    rows = _rows(text, start, table.delimiter)
    filled = tuple(row for row in rows if any(cell.text for cell in row))
    return Cells(path, filled, table.delimiter, text, encoding)


def _rows(text: str, at: int, delimiter: str) -> list[tuple[TableCell, ...]]:
    rows, row = list[tuple[TableCell, ...]](), list[TableCell]()
    while at < len(text):
        end = _end(text, at, delimiter)
        row.append(_cell(text, at, end))
        at = end + 1
        if text[end : end + 1] != delimiter:
            at += text[end : end + 2] == "\r\n"
            rows.append(tuple(row))
            row = []
    # A delimiter with nothing behind it, at the end of the file.
    return [*rows, (*row, TableCell("", at, at, quoted=False))] if row else rows


def _end(text: str, at: int, delimiter: str) -> int:
    """Where the cell that begins here ends: at a delimiter or the end of a line outside of quotation marks."""
    within = quoted = text[at] == '"'
    for place in range(at + quoted, len(text)):
        mark = text[place]
        if (
            mark == '"' and quoted
        ):  # of a doubled one, the first ends the quotation and the second takes it up again
            within = not within
        elif not within and mark in (delimiter, "\n", "\r"):
            return place
    return len(text)


def _cell(text: str, start: int, end: int) -> TableCell:
    raw = text[start:end]
    quoted = len(raw) > 1 and raw.startswith('"') and raw.endswith('"')
    return TableCell((raw[1:-1].replace('""', '"') if quoted else raw).strip(), start, end, quoted)


# What Excel, LibreOffice and Google's tables calculate; a number with a sign, and a dash, are none.
FORMULA = re.compile(r"\s*[=@]|[\t\r]|\s*[+-](?!$|\d+(?:[.,]\d+)?$)")


def table_text(rows: Iterable[Sequence[str]]) -> str:
    """The text of a file. A name such as `=HYPERLINK(…)` gets an apostrophe in front, by which spreadsheets take it as text."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerows([_harmless(cell) for cell in row] for row in rows)
    return text.getvalue()


def _harmless(cell: str) -> str:
    return f"'{cell}" if FORMULA.match(cell) else cell
