"""The givens of a problem's front matter: constants, grids, lists of values, and words to choose among."""

from __future__ import annotations

import keyword
import re
from fractions import Fraction
from pathlib import Path

from corollary.formula.functions import SPELLINGS
from corollary.problem.diagnostic import Diagnostic
from corollary.problem.front_matter import ListNode, Node, Reader, TableNode, TextNode, exact
from corollary.problem.given import Given, Grid, decimal_places
from corollary.units.unit import PURE, unit

SYMBOL = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
RESERVED = {*SPELLINGS, *keyword.kwlist, "pi", "log", "answer"}
"""Words that formulas and solutions need for themselves."""


def read_given(
    path: Path, symbol: str, node: TableNode | TextNode | ListNode, complaints: list[Diagnostic]
) -> Given | None:
    """A row of `given:`; None, and complaints, where it will not do."""
    if not isinstance(node, TableNode):
        complaints.append(
            Diagnostic(
                path,
                node.line,
                f"{symbol} must be a table: {{is: …, value: …, from: …, to: …, step: …, unit: …}}",
            )
        )
        return None
    before = len(complaints)
    row = Reader(path, node, symbol, complaints)
    check_symbol(row, symbol)
    meaning, (unit_text, unit_line) = row.text("is"), row.line_of("unit", "1")
    listed = row.list_of("in")
    if "in" in node.entries:
        return _of_list(row, listed, symbol, meaning, unit_text, unit_line, before)
    value = row.fraction("value")
    first, last, step = (row.fraction(name, "") for name in ("from", "to", "step"))
    row.finish()
    try:
        measured_in = unit(unit_text)
    except ValueError as error:
        row.complain(unit_line, f"unit of {symbol}: {error}")
        return None
    if len(complaints) > before or value is None:
        return None
    if first is None and last is None and step is None:
        return Given(
            symbol,
            meaning,
            measured_in,
            value,
            Grid(value, Fraction(0), 1),
            node.line,
            written_decimals(node.entries["value"], decimal_places(value)),
        )
    if first is None or last is None or step is None:
        row.complain(
            node.line, f"{symbol} needs all of from, to and step, or none of them (then it is always {value})"
        )
        return None
    if step <= 0 or last < first:
        row.complain(
            node.line,
            f"{symbol} has no values from {first} to {last} in steps of {step}; from must not exceed to, and step be positive",
        )
        return None
    count = (last - first) // step + 1
    if first + (count - 1) * step != last:
        row.complain(
            node.line,
            f"{symbol} does not reach `to` in whole steps; the last value would be {float(first + (count - 1) * step):g}",
        )
        return None
    return Given(
        symbol,
        meaning,
        measured_in,
        value,
        Grid(first, step, int(count)),
        node.line,
        decimal_places(first, step),
    )


def check_symbol(row: Reader, symbol: str) -> None:
    """Complains where a given cannot be called so."""
    if not SYMBOL.match(symbol):
        row.complain(row.table.line, f"{symbol!r} is not a symbol; use a letter, then letters, digits or _")
    elif symbol in RESERVED:
        whose = (
            "is a function in formulas"
            if symbol in SPELLINGS
            else "has a meaning of its own in formulas or in Python"
        )
        row.complain(row.table.line, f"{symbol} {whose}; call it {symbol}_1, or use another letter")


def _of_list(
    row: Reader,
    nodes: tuple[Node, ...],
    symbol: str,
    meaning: str,
    unit_text: str,
    unit_line: int,
    before: int,
) -> Given | None:
    """A given that has one of the values of a list, or one of its words. `before`: how many complaints there were."""
    line = row.table.line
    texts = [node.text.strip() for node in nodes if isinstance(node, TextNode) and node.text.strip()]
    own = row.text("value", "")
    row.finish()
    numbers = [exact(text) for text in texts]
    if len(texts) < 2 or len(texts) < len(nodes) or len(set(texts)) < len(texts):
        row.complain(line, f"{symbol}: list at least two different values (or words) as in: [1, 2, 5]")
    elif any(number is not None for number in numbers) and None in numbers:
        row.complain(line, f"{symbol} lists numbers and words; it is either")
    elif None in numbers and unit_text != "1":
        row.complain(
            unit_line, f"{symbol} lists words, which have no unit; numbers are written as 0.43, -2, 1/3"
        )
    elif own and own.strip() not in texts:
        row.complain(line, f"value: {own} of {symbol} is not in its list ({', '.join(texts)})")
    try:
        measured_in = unit(unit_text)
    except ValueError as error:
        row.complain(unit_line, f"unit of {symbol}: {error}")
        return None
    if len(row.complaints) > before:
        return None
    which = texts.index(own.strip()) if own else 0
    if None in numbers:
        places = Grid(Fraction(0), Fraction(1), len(texts))
        return Given(symbol, meaning, PURE, Fraction(which), places, line, 0, words=tuple(texts))
    values = tuple(number for number in numbers if number is not None)
    return Given(
        symbol, meaning, measured_in, values[which], Grid.listing(values), line, decimal_places(*values)
    )


def written_decimals(node: Node, needed: int) -> int:
    """How many decimals a constant is written with, at least those it needs: 9.80 keeps its zero, and so do 1.20e-5 and 6.40e23,
    which has -21."""
    text = node.text if isinstance(node, TextNode) else ""
    written = re.fullmatch(r"\s*[-−]?\d*(?:\.(?P<decimals>\d+))?(?:[eE](?P<power>[+-]?\d+))?\s*", text)
    if not written or not (written["decimals"] or written["power"]):
        return needed
    places = len(written["decimals"] or "") - int(written["power"] or 0)
    return places if places < 0 and not needed else max(places, needed)
