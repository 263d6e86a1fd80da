"""Tables of the front matter whose rows are drawn whole: materials, gases, nuclides, each with its numbers and words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic
from corollary.problem.front_matter import ListNode, Node, Reader, TableNode, TextNode, exact
from corollary.problem.given import Given, Grid, decimal_places
from corollary.problem.givens import check_symbol, written_decimals
from corollary.units.unit import PURE, unit

MOST_ROWS = 200
MOST_SETS_OF_ROWS = 2000
"""Of several tables: claims that do not hold for all their numbers at once are proven for one set of rows after the other."""
DECLARE = "say what it means and its unit once: given: {{{0}: {{is: …, unit: …}}}}"


@dataclass(frozen=True, slots=True)
class RowColumn:
    """The cells of one column, as they stand in the table of this name."""

    table: str
    cells: tuple[TextNode, ...]

    @property
    def line(self) -> int:
        return self.cells[0].line


def read_columns(path: Path, node: Node | None, complaints: list[Diagnostic]) -> dict[str, RowColumn]:
    """The columns of `rows:`, which is a table, or several by name; without those that have a fault."""
    named: dict[str, Node] = {}
    match node:
        case None:
            return {}
        case ListNode():
            named = {"rows": node}
        case TableNode(entries):
            named = dict(entries)
        case TextNode():
            pass
    found: dict[str, RowColumn] = {}
    sets = 1
    for name, each in named.items():
        rows = _rows(path, name, each, complaints)
        sets *= max(1, len(rows))
        for symbol in rows[0] if rows else ():
            column = RowColumn(name, tuple(row[symbol] for row in rows))
            if symbol in found:
                why = f"{symbol} is a column of {found[symbol].table}, too; call one of them otherwise"
                complaints.append(Diagnostic(path, column.line, why))
            found[symbol] = column
    if not named:
        why = "rows: lists rows such as - {body: a hoop, k: 1}, or tables of rows by name"
        complaints.append(Diagnostic(path, node.line, why))
    elif sets > MOST_SETS_OF_ROWS:
        why = f"rows: the tables have {sets} sets of rows, more than {MOST_SETS_OF_ROWS}; leave rows out"
        complaints.append(Diagnostic(path, node.line, why))
    return found


def _rows(path: Path, name: str, node: Node, complaints: list[Diagnostic]) -> list[dict[str, TextNode]]:
    """The rows of one table, all with the same columns; none where one has a fault."""

    def complain(line: int, why: str) -> list[dict[str, TextNode]]:
        complaints.append(Diagnostic(path, line, f"{name}: {why}"))
        return []

    items = node.items if isinstance(node, ListNode) else ()
    if not 2 <= len(items) <= MOST_ROWS:
        return complain(
            node.line, f"list 2 to {MOST_ROWS} rows, each with the same columns: - {{body: a hoop, k: 1}}"
        )
    rows: list[dict[str, TextNode]] = []
    met: dict[tuple[str, ...], int] = {}
    for at, item in enumerate(items, 1):
        entries = item.entries if isinstance(item, TableNode) else {}
        cells = {
            symbol: cell
            for symbol, cell in entries.items()
            if isinstance(cell, TextNode) and cell.text.strip()
        }
        if not cells or len(cells) < len(entries):
            return complain(item.line, f"row {at} holds one value for each column: {{body: a hoop, k: 1}}")
        first = rows[0] if rows else cells
        if missing := [symbol for symbol in first if symbol not in cells]:
            return complain(item.line, f"row {at} has no {', '.join(missing)}, which the first row has")
        if strange := [symbol for symbol in cells if symbol not in first]:
            return complain(item.line, f"row {at} has {', '.join(strange)}, which the first row has not")
        values = tuple(str(_value(cells[symbol])) for symbol in first)
        if values in met:
            return complain(item.line, f"row {at} is the same as row {met[values]}; leave one of them out")
        met[values] = at
        rows.append(cells)
    return rows


def _value(cell: TextNode) -> Fraction | str:
    number = exact(cell.text)
    return " ".join(cell.text.split()) if number is None else number


def column_given(
    path: Path, symbol: str, column: RowColumn, declared: Node | None, complaints: list[Diagnostic]
) -> Given | None:
    """The given that a column is, of numbers or of words; `declared` is what `given:` says of it. None, and complaints, where it will not
    do."""
    before = len(complaints)
    if declared is not None and not isinstance(declared, TableNode):
        why = f"{symbol} is a column of {column.table}: {DECLARE.format(symbol)}"
        complaints.append(Diagnostic(path, declared.line, why))
        return None
    row = Reader(path, declared or TableNode({}, column.line), symbol, complaints)
    check_symbol(row, symbol)
    drawn = [each for each in ("value", "from", "to", "step", "in") if each in row.table.entries]
    if drawn:
        row.complain(
            row.table.line,
            f"{symbol} has its values in {column.table}; leave {', '.join(drawn)} out under given",
        )
        return None
    numbers = [exact(each.text) for each in column.cells]
    of_words = all(each is None for each in numbers)
    meaning = row.text("is", "" if of_words else None) if declared is not None else ""
    unit_text, unit_line = row.line_of("unit", "1")
    row.finish()
    if of_words and unit_text != "1":
        row.complain(unit_line, f"{symbol} has words in {column.table}, which have no unit")
    elif not of_words and None in numbers:
        cell = column.cells[
            next(at for at, each in enumerate(numbers) if (each is None) != (numbers[0] is None))
        ]
        row.complain(
            cell.line,
            f"{symbol} has numbers and words in {column.table} ({cell.text.strip()!r}); it is either, and a number has no unit there",
        )
    elif not of_words and declared is None:
        row.complain(column.line, f"{symbol} has numbers in {column.table}: {DECLARE.format(symbol)}")
    try:
        measured_in = unit(unit_text)
    except ValueError as error:
        row.complain(unit_line, f"unit of {symbol}: {error}")
        return None
    if len(complaints) > before:
        return None
    line = row.table.line
    if of_words:
        words = tuple(" ".join(each.text.split()) for each in column.cells)
        places = Grid(Fraction(0), Fraction(1), len(words))
        return Given(symbol, meaning, PURE, Fraction(0), places, line, 0, words=words, table=column.table)
    values = tuple(number for number in numbers if number is not None)
    as_written = tuple(
        (value, written_decimals(cell, decimal_places(value)))
        for value, cell in zip(values, column.cells, strict=True)
    )
    return Given(
        symbol,
        meaning,
        measured_in,
        values[0],
        Grid.listing(values),
        line,
        decimal_places(*values),
        table=column.table,
        as_written=as_written,
    )


def columns_as_givens(
    path: Path, columns: Mapping[str, RowColumn], declared: Mapping[str, Node], complaints: list[Diagnostic]
) -> dict[str, Given | None]:
    """Each column as a given, None for one with a fault."""
    return {
        symbol: column_given(path, symbol, column, declared.get(symbol), complaints)
        for symbol, column in columns.items()
    }


def without_values(declared: Mapping[str, Node], columns: Mapping[str, RowColumn]) -> list[str]:
    """The givens that have no values of their own and are no column."""
    return [
        symbol
        for symbol, node in declared.items()
        if symbol not in columns and isinstance(node, TableNode)
        if not {"value", "in"} & node.entries.keys()
    ]


def letters_in(node: Node | None) -> frozenset[str]:
    """The names of all columns, those of a table with a fault too."""
    match node:
        case ListNode(items):
            rows = [item for item in items if isinstance(item, TableNode)]
            return frozenset(symbol for row in rows for symbol in row.entries)
        case TableNode(entries):
            return frozenset[str]().union(*map(letters_in, entries.values()))
        case _:
            return frozenset()
