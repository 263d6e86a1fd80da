"""The rows of `variables:` in a problem's front matter, and what does not fit between them and the parts."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic
from corollary.problem.front_matter import Node, Reader, TableNode
from corollary.problem.givens import check_symbol
from corollary.problem.part import Part
from corollary.problem.variable import Variable
from corollary.units.unit import unit

FORM = "{is: time after it is switched on, from: 0, to: 10, unit: s}"


def read_variables(
    front: Reader, others: Iterable[str], complaints: list[Diagnostic]
) -> tuple[Variable, ...]:
    """The rows of `variables:` in the front matter; `others` are the letters that stand for something else."""
    known, found = set(others), list[Variable]()
    for symbol, node in front.table_of("variables").entries.items():
        if symbol in known:
            front.complain(node.line, f"variables: {symbol} is a given, too; keep one of them")
        elif (variable := _variable(front.path, symbol, node, complaints)) is not None:
            found.append(variable)
    return tuple(found)


def _variable(path: Path, symbol: str, node: Node, complaints: list[Diagnostic]) -> Variable | None:
    if not isinstance(node, TableNode):
        complaints.append(Diagnostic(path, node.line, f"variables: write {symbol} as a table: {FORM}"))
        return None
    before = len(complaints)
    row = Reader(path, node, symbol, complaints)
    check_symbol(row, symbol)
    if strange := [name for name in ("value", "step", "in") if name in node.entries]:
        row.seen.add(strange[0])
        sentence = f"{symbol} is a variable and has no `{strange[0]}`: no number is dealt for it; a number belongs to given:"
        row.complain(node.entries[strange[0]].line, sentence)
    meaning, (unit_text, unit_line) = row.text("is"), row.line_of("unit", "1")
    if "to" not in node.entries:
        row.complain(
            node.line, f"{symbol} has no `to`; say up to where its formulas hold and are compared: {FORM}"
        )
    first, last = row.fraction("from", "0"), row.fraction("to", "1")
    row.finish()
    try:
        measured_in = unit(unit_text)
    except ValueError as error:
        row.complain(unit_line, f"unit of {symbol}: {error}")
        return None
    if len(complaints) > before or first is None or last is None:
        return None
    if first >= last:
        row.complain(node.line, f"{symbol} has no values from {first} to {last}; from must be less than to")
        return None
    return Variable(symbol, meaning, measured_in, first, last, "from" not in node.entries, node.line)


def misfits_of_variables(
    path: Path, variables: Iterable[Variable], parts: Iterable[Part]
) -> list[Diagnostic]:
    """Parts that are of a letter which is no variable, and variables of which no part is."""
    symbols = [each.symbol for each in variables]
    asked = [letter for part in parts for letter in part.of]
    found = [
        Diagnostic(
            path,
            part.line,
            f"part {part.id} is a formula of {letter}, which is not among the variables; declare it in the front matter, "
            f"below a line `variables:`, as {letter}: {FORM}",
        )
        for part in parts
        for letter in part.of
        if letter not in symbols
    ]
    return found or [
        Diagnostic(
            path,
            each.line,
            f'no part asks for a formula of the variable {each.symbol}; say so in a heading, as {{#a .expression of="{each.symbol}"}}, '
            "or make it a given",
        )
        for each in variables
        if each.symbol not in asked
    ]
