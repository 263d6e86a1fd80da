"""Tables and matrices, asked for and read: a list of rows, a dictionary, an array, or a text such as `1, 2; 3, 4`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Blank, Entries, Formulas, Numbers, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.components import pieces_of
from corollary.answers.numbers import PLACEHOLDERS, scalar, turned_away
from corollary.answers.question import Question
from corollary.answers.table.entry import entry_question, heads, numbered, units_of
from corollary.formula.errors import ParseError
from corollary.formula.value import Items, Named, Nothing, Refused, Text, Value
from corollary.messages import catalogue
from corollary.units.unit import read_unit, show

_ = catalogue(__name__)

LONGEST = 2000
INNER = re.compile(r"[\[(]([^\[\]()]*)[\])]")
MATRIX = re.compile(r"\\(?:begin|end)\s*\{[a-zA-Z]*(?:matrix|array|tabular)\*?\}(?:\{[lcr|]*\})?|\$")
CALLED = re.compile(
    r"\A\s*(?:[a-zA-Z_]\w*\s*=\s*)?(?:(?:np|numpy|sp|sympy)\.)?(?:array|matrix|Matrix)\s*\((?P<inside>.*)\)\s*\Z",
    re.DOTALL,
)
UNIT_BEHIND = re.compile(r"\A(?P<rows>.*[\])])\s*\*?\s*(?P<unit>[A-Za-zµΩ°%].*)\Z", re.DOTALL)
ROWS = re.compile(r"\\\\|;|\n")
RULED = re.compile(
    r"\A(?P<head>[^\n]*\|[^\n]*)\n[\s|:]*-{2,}[-\s|:]*\n(?P<rows>.*)\Z", re.DOTALL
)  # as Markdown has it
CELLS = re.compile(r"\s*[|&]\s*|\t+")
Row = Sequence[Value]


@final
class TableType(AnswerType):
    name, word = "table", "table"
    accepts = needs = frozenset({"rows"})
    lists_components = False

    def instructions(self, question: Question) -> str:
        if numbered(question):
            rows, columns = len(question.rows), len(question.columns)
            return _("Answer with a matrix: {rows} rows, {columns} columns.", rows=rows, columns=columns)
        return _(
            "Answer with a table. Its rows: {rows}. Its columns: {columns}.",
            rows=", ".join(question.rows),
            columns=", ".join(heads(question)),
        )

    def blank(self, question: Question) -> str:
        nones = ", ".join("None" for _column in question.columns)
        columns = ", ".join(heads(question))
        remark = _("a list for each row: numbers, or texts with a unit")
        lines = [f"{question.name} = [   # {remark}" + ("" if numbered(question) else f"; {columns}")]
        for row in question.rows:
            lines.append(f"    [{nones}]," + ("" if numbered(question) else f"   # {row}"))
        return "\n".join([*lines, "]"])

    def read(self, value: Value, question: Question) -> Answer:
        match value:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Refused():
                return turned_away(value)
            case _:
                rows = _rows(value, question)
        if isinstance(rows, Unclear):
            return rows
        found = [
            scalar(item, entry_question(question, place))
            for place, item in enumerate(item for row in rows for item in row)
        ]
        if all(isinstance(each, Blank) for each in found):
            return Blank()
        return Entries(tuple(found), _as_read(found, question))


def _as_read(found: Sequence[Numbers | Formulas | Blank | Unclear], question: Question) -> str:
    width, lines = len(question.columns), list[str]()
    for place, label in enumerate(question.rows):
        row = ", ".join(each.as_read or "—" for each in found[place * width : (place + 1) * width])
        lines.append(f"({row})" if numbered(question) else f"{label}: ({row})")
    return "; ".join(lines)


def _rows(value: Value, question: Question) -> list[Row] | Unclear:
    """The entries as they stand, row by row."""
    height, width = len(question.rows), len(question.columns)
    match value:
        case Text(text) if len(text) <= LONGEST and (ruled := RULED.search(text)):
            named = _of_markdown(ruled, question)
            return named if isinstance(named, Unclear) else _rows(named, question)
        case Text(text) if len(text) <= LONGEST and (named := _labelled(_lines(text), question)) is not None:
            return _by_name(*named, question)
        case Text(text) if len(text) <= LONGEST:
            rows: list[Row] = [[Text(row)] for row in _lines(text)]
        case Named(names, items):
            return _by_name(names, items, question)
        case Items(items) if len(items) == height * width and not any(map(_several, items)):
            rows = [items[place * width : (place + 1) * width] for place in range(height)]
        case Items(items):
            rows = [_row(item, question) for item in items]
        case _:
            rows = [[value]]
    rows = [_opened(row, width) for row in rows]
    if len(rows) != height or any(len(row) != width for row in rows):
        return _another_shape(rows, question)
    return rows


def _several(item: Value) -> bool:
    return isinstance(item, Items | Named)


def _row(item: Value, question: Question) -> Row:
    match item:
        case Items(inside):
            return inside
        case Named(names, inside) if (places := _places(names, question.columns)) is not None:
            return [inside[places.index(place)] for place in range(len(inside))]
        case _:
            return [item]


def _opened(row: Row, width: int) -> Row:
    """A row that is one text, opened where that gives as many entries as there are columns."""
    if width == 1 or len(row) != 1 or not isinstance(text := row[0], Text):
        return row
    cells = [cell for cell in CELLS.split(text.text.strip(" |")) if cell]
    if len(cells) > 1:
        return [Text(cell) for cell in cells]
    pieces = pieces_of(text.text, width)
    return [Text(piece) for piece in pieces] if isinstance(pieces, list) else row


def _lines(text: str) -> list[str]:
    """One text for each row: `[[1, 2], [3, 4]]`, `1, 2; 3, 4`, or a row a line."""
    text = MATRIX.sub(" ", text)
    text = called["inside"] if (called := CALLED.match(text)) else text
    if (behind := UNIT_BEHIND.match(text.strip())) and not isinstance(read_unit(behind["unit"]), ParseError):
        return [f"({row}) {behind['unit']}" for row in _lines(behind["rows"])]
    inner = INNER.findall(text)
    if len(inner) > 1 and not INNER.sub("", text).strip(" \n\t,;[]()"):
        return inner
    bare = text.strip()
    if bare[:1] in ("[", "(") and bare[-1:] in ("]", ")") and len(inner) <= 1:
        bare = bare[1:-1]
    return [line.strip().rstrip(",") for line in ROWS.split(bare) if line.strip()]


def _labelled(lines: Sequence[str], question: Question) -> tuple[tuple[str, ...], tuple[Value, ...]] | None:
    """The labels and the entries of `left: 1, 2; right: 3, 4`, where each row begins with a label asked for."""
    pairs = [re.split(r"\s*[:=]\s*", line, maxsplit=1) for line in lines]
    if not all(len(pair) == 2 for pair in pairs):
        return None
    labels = tuple(pair[0] for pair in pairs)
    return (
        (labels, tuple(Text(pair[1]) for pair in pairs))
        if _places(labels, question.rows) is not None
        else None
    )


def _of_markdown(ruled: re.Match[str], question: Question) -> Value | Unclear:
    """A table whose heads name the columns asked for, in their units, and its rows under their names where it has these."""
    lines = [ruled["head"], *ruled["rows"].splitlines()]
    head, *rows = [[cell.strip() for cell in _unframed(line).split("|")] for line in lines if line.strip()]
    named = len(head) == len(question.columns) + 1
    columns = [_head(each, question) for each in head[named:]]
    if sorted(columns) != sorted(question.columns) or any(len(row) != len(head) for row in rows):
        return _other_names(tuple(head[named:]), question)
    order = [named + columns.index(column) for column in question.columns]
    found = tuple(Items(tuple(Text(row[place]) for place in order), (len(order),)) for row in rows)
    return Named(tuple(row[0] for row in rows), found) if named else Items(found, (len(found),))


def _unframed(line: str) -> str:
    return line.strip().removeprefix("|").removesuffix("|")


def _head(typed: str, question: Question) -> str:
    """The column that a head names, alone or with the unit asked for; "" for none."""
    bare = re.sub(r"[\s\[\]()*_]+|\bin\b", "", typed).casefold()
    for column, unit in zip(question.columns, units_of(question), strict=True):
        ways = (column, column + show(unit), f"{column}/{show(unit)}")
        if bare in {re.sub(r"\s+", "", each).casefold() for each in ways}:
            return column
    return ""


def _by_name(names: tuple[str, ...], items: tuple[Value, ...], question: Question) -> list[Row] | Unclear:
    """A dictionary by rows, each a list; or by columns, as a data frame gives them."""
    if (places := _places(names, question.rows)) is not None:
        ordered = [items[places.index(place)] for place in range(len(items))]
        return _rows(Items(tuple(ordered), (len(ordered),)), question)
    if (places := _places(names, question.columns)) is not None:
        columns = [items[places.index(place)] for place in range(len(items))]
        turned = replace(question, rows=question.columns, columns=question.rows)
        found = _rows(Items(tuple(columns), (len(columns),)), turned)
        return found if isinstance(found, Unclear) else [list(row) for row in zip(*found, strict=True)]
    return _other_names(names, question)


def _other_names(names: tuple[str, ...], question: Question) -> Unclear:
    return Unclear(
        _(
            "the rows are {rows}, the columns {columns}; your names are {given}",
            rows=", ".join(question.rows),
            columns=", ".join(question.columns),
            given=", ".join(names)[:80],
        ),
        _("a table"),
    )


def _places(names: Sequence[str], labels: Sequence[str]) -> list[int] | None:
    """Where each name stands among the labels; None unless they are the same."""
    known = [label.strip().casefold() for label in labels]
    typed = [name.strip().casefold() for name in names]
    return [known.index(name) for name in typed] if sorted(typed) == sorted(known) else None


def _another_shape(rows: list[Row], question: Question) -> Unclear:
    widths = sorted({len(row) for row in rows})
    return Unclear(
        _(
            "a table of {rows} rows with {columns} entries each is asked for, as a list of lists; these are {given} rows with {widths}",
            rows=len(question.rows),
            columns=len(question.columns),
            given=len(rows),
            widths=", ".join(map(str, widths)) or "0",
        ),
        _("a table"),
    )


TYPE = TableType()
