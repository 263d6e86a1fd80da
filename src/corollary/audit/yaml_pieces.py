"""A YAML file of records of which one is no YAML: the others are read from their own lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import ListNode, Node, TableNode, TextNode, document

DOCUMENT = re.compile(r"---(\s|$)")
ITEM = re.compile(r"( *)- ")
RECORDS = re.compile(r"records:\s*(#.*)?$")
MOST_LINES = (
    1_000_000  # read again, over all pieces: each is read behind as many empty lines as stand above it
)


@dataclass(frozen=True, slots=True)
class Chunk:
    """Lines of a file, from `start` (0 is the first) up to `end`."""

    start: int
    end: int


def records_node(path: Path, source: str, faults: list[Diagnostic]) -> Node | None:
    """The nodes of a file, as `document` gives them.

    Where the whole of it is no YAML, or several documents, its pieces are read alone. One that is no YAML has an empty text in place
    of its record, and a fault. Raises Malformed where the file has no pieces, and where what stands before them is no YAML.
    """
    try:
        return document(path, source, faults)
    except Malformed:
        lines = source.splitlines(keepends=True)
        head, pieces = _pieces(lines)
        if len(pieces) < 2 or len(lines) * len(pieces) > MOST_LINES:
            raise
        found: list[Node] = []
        for piece in pieces:
            found += _read(path, lines, piece, faults)
        if all(isinstance(each, TextNode) for each in found):
            raise
    if head is None:
        return ListNode(tuple(found), 1)
    top = document(path, "".join(lines[:head]), faults)
    entries = dict(top.entries) if isinstance(top, TableNode) else {}
    return TableNode(entries | {"records": ListNode(tuple(found), head + 1)}, 1)


def _read(path: Path, lines: list[str], piece: Chunk, faults: list[Diagnostic]) -> Iterator[Node]:
    """The records of a piece."""
    try:
        node = document(path, "\n" * piece.start + "".join(lines[piece.start : piece.end]), faults)
    except Malformed as error:
        for each in error.complaints:  # an end that is missing is missed behind the last line
            faults.append(replace(each, line=min(max(each.line, piece.start + 1), piece.end)))
        yield TextNode("", piece.start + 1)
        return
    if isinstance(node, ListNode):
        yield from node.items
    elif node is not None:
        yield node


def _pieces(lines: list[str]) -> tuple[int | None, list[Chunk]]:
    """The documents of a stream, or the records of a list; before a list of `records:`, how many lines are its head."""
    marks = [at for at, line in enumerate(lines) if DOCUMENT.match(line)]
    if any(_says_something(lines[:at]) for at in marks[:2]):
        return None, _between([0, *(at + 1 for at in marks)], lines)
    head = next((at for at, line in enumerate(lines) if RECORDS.match(line)), None)
    first = next((at for at in range(head or 0, len(lines)) if ITEM.match(lines[at])), None)
    if first is None:
        return None, []
    begins = ITEM.match(lines[first])
    assert begins is not None
    mark = f"{begins[1]}- "
    return head, _between([at for at in range(first, len(lines)) if lines[at].startswith(mark)], lines)


def _says_something(lines: list[str]) -> bool:
    """True if there is more than empty lines, comments and marks of documents."""
    return any(line.strip() and not line.startswith("#") and not DOCUMENT.fullmatch(line) for line in lines)


def _between(starts: list[int], lines: list[str]) -> list[Chunk]:
    """From each start to the next, without those that are empty, and without the mark of the next document."""
    found = list[Chunk]()
    for start, end in zip(starts, [*starts[1:], len(lines)], strict=True):
        last = end - 1 if end > start and DOCUMENT.match(lines[end - 1]) else end
        if _says_something(lines[start:last]):
            found.append(Chunk(start, last))
    return found
