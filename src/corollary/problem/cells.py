"""A CSV file in which single cells are changed, and everything else stays as it is, byte for byte."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.table import read_table

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
