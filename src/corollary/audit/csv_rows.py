"""A CSV file as a list of records: its first row names the fields."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import ListNode, Node, TableNode, TextNode

SEPARATOR = ";"
IN_WORDS = {"statement", "source", "address", "licence"}  # texts that may have a semicolon
FIELDS = IN_WORDS | {
    "id", "problem", "laws", "given", "asked", "published", "where", "convention", "constants", "figures", "mistakes", "forgives",
}  # fmt: skip


def rows_in(path: Path, source: str) -> ListNode:
    """The rows of a file; `;` parts what has several values.

    Cells are parted by commas, or by what else parts the first row: semicolons or tabs. A row that is not in order is a text in
    place of a table. Raises Malformed where the first row is not in order.
    """
    first = source.partition("\n")[0]
    parted_by = next((each for each in ",;\t" if each in first), ",")
    reader = csv.reader(io.StringIO(source), delimiter=parted_by, strict=True)
    items: list[Node] = []
    line = 1
    try:
        header = [each.strip().lower() for each in next(reader, list[str]())]
        if twice := sorted(name for name in set(header) if name and header.count(name) > 1):
            raise Malformed([Diagnostic(path, 1, f"has two columns `{twice[0]}`")])
        if unknown := sorted(set(header) - FIELDS - {""}):
            known = ", ".join(sorted(FIELDS))
            raise Malformed([Diagnostic(path, 1, f"column `{unknown[0]}` is not known; known are {known}")])
        while (cells := next(reader, None)) is not None:
            line = reader.line_num
            if any(cell.strip() for cell in cells):
                items.append(_row(header, cells, line))
    except csv.Error as error:
        if not items:
            raise Malformed([Diagnostic(path, line + 1, f"is no CSV: {error}")]) from None
        items.append(TextNode(f"is no CSV from here on, and is not read to its end: {error}", line + 1))
    return ListNode(tuple(items), 1)


def _row(header: Sequence[str], cells: Sequence[str], line: int) -> TextNode | TableNode:
    if len(cells) > len(header) and any(cell.strip() for cell in cells[len(header) :]):
        why = "has more cells than the first row; put a cell with a comma into quotation marks"
        return TextNode(why, line)
    entries: dict[str, Node] = {}
    for name, cell in zip(header, cells, strict=False):
        pieces = [TextNode(each.strip(), line) for each in cell.split(SEPARATOR) if each.strip()]
        if not pieces:
            continue
        if name == "given":
            parted = [each.text.partition("=") for each in pieces]
            letters = [left.strip() for left, _, _ in parted]
            if len(set(letters)) < len(letters):
                return TextNode(f"gives a letter twice: {cell.strip()}", line)
            entries[name] = TableNode(
                {left.strip(): TextNode(right.strip(), line) for left, _, right in parted}, line
            )
        elif name in IN_WORDS:
            entries[name] = TextNode(cell.strip(), line)
        else:
            entries[name] = ListNode(tuple(pieces), line) if len(pieces) > 1 else pieces[0]
    return TableNode(entries, line)
