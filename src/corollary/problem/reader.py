"""From a Markdown file to a problem; every failing is a complaint with its line."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

from corollary.formula.ast import Name, Number, Relation
from corollary.formula.functions import SPELLINGS
from corollary.problem.conditions import relations
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.figure import is_svg
from corollary.problem.figure_lines import read_lines
from corollary.problem.front_matter import ListNode, Reader, TableNode, TextNode, split
from corollary.problem.given import Given, Grid, decimal_places
from corollary.problem.parts_markdown import read_parts
from corollary.problem.problem import Condition, Description, Problem
from corollary.problem.statement import HOLE, holes
from corollary.units.constants import CONSTANTS
from corollary.units.unit import Unit, unit

CODE = re.compile(r"[A-Za-z][A-Za-z0-9]*(\.[A-Za-z0-9]+)*$")
SYMBOL = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
DIFFICULTIES = ("1", "2", "3", "4", "5")
RESERVED = {*SPELLINGS, *keyword.kwlist, "pi", "log", "answer"}
"""Words that formulas and solutions need for themselves."""


def read_problem(path: Path) -> Problem:
    """The problem a file holds. Raises Malformed with every complaint found."""
    table, body, line = split(path)
    complaints: list[Diagnostic] = []
    front = Reader(path, table, "the front matter", complaints)
    (code, code_line), (title, title_line), source = (
        front.line_of("code"),
        front.line_of("title"),
        front.text("source", ""),
    )
    if code and not CODE.match(code):
        front.complain(
            code_line, f"code: {code} is no code; use letters and digits, parted by points, such as X12.5"
        )
    rows = front.table_of("given").entries
    givens = tuple(
        given
        for symbol, node in rows.items()
        if (given := _given(path, symbol, node, complaints)) is not None
    )
    known = frozenset(rows)  # those with a fault too
    constants = [
        given
        for node in front.list_of("constants")
        if (given := _constant(path, node, {*known}, complaints)) is not None
    ]
    givens, known = (*givens, *constants), known | {given.symbol for given in constants}
    units = {given.symbol: given.unit for given in givens}
    nodes = [
        (node, hard) for name, hard in (("where", False), ("require", True)) for node in front.list_of(name)
    ]
    conditions = [
        condition
        for node, hard in (
            nodes if len(givens) == len(rows) + len(constants) else ()
        )  # one fault is one complaint
        for condition in _conditions(path, node, units, hard, complaints)
    ]
    conditions += [
        Condition(
            Relation(">", Name(given.symbol), Number(Fraction(0))), f"{given.symbol} > 0", True, given.line
        )
        for given in constants
    ]
    (figure, figure_line), (alt, alt_line) = front.line_of("figure", ""), front.line_of("alt", "")
    description = _description(front)
    front.finish()
    node = table.entries.get("figure")
    first_line = figure_line + (node.block if isinstance(node, TextNode) else 0)
    if is_svg(figure):
        if figure and not alt:
            front.complain(
                figure_line, "the figure has no `alt`; describe it in a sentence for those who cannot see it"
            )
    else:
        letters = tuple((given.symbol, given.unit.dimension) for given in givens)
        for at, sentence in read_lines(figure, letters)[1] if len(letters) == len(known) else ():
            front.complain(first_line + at, sentence)
    statement, parts = read_parts(path, body, line, complaints)
    for text, first in ((body, line), (figure, first_line), (alt, alt_line)):
        _check_holes(path, text, first, known, complaints)
    for text, at in ((title, title_line), *((part.title, part.line) for part in parts)):
        if holes(text):
            complaints.append(
                Diagnostic(path, at, f"the title {text!r} has a hole; numbers stand in the text below it")
            )
    if not parts:
        complaints.append(
            Diagnostic(path, line, 'asks nothing; add a part: ## Title {#a .value unit="m/s" points=1}')
        )
    if complaints:
        raise Malformed(complaints)
    return Problem(
        code,
        path.stem,
        title,
        source,
        path.parent.name,
        statement,
        givens,
        tuple(conditions),
        parts,
        figure,
        alt,
        path,
        figure_line,
        description=description,
    )


def _description(front: Reader) -> Description:
    difficulty, line = front.line_of("difficulty", "")
    if difficulty and difficulty not in DIFFICULTIES:
        front.complain(line, f"difficulty: {difficulty}: say a whole number from 1 (easiest) to 5")
        difficulty = ""
    tags: list[str] = []
    for node in front.list_of("tags"):
        if isinstance(node, TextNode) and node.text.strip():
            tags.append(node.text.strip())
        else:
            front.complain(node.line, "a tag is a word or a few; list them as tags: [energy, two steps]")
    author, licence, version = (front.text(name, "") for name in ("author", "licence", "version"))
    return Description(int(difficulty or 0), tuple(tags), author, licence, version)


def _given(
    path: Path, symbol: str, node: TableNode | TextNode | ListNode, complaints: list[Diagnostic]
) -> Given | None:
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
    if not SYMBOL.match(symbol):
        row.complain(node.line, f"{symbol!r} is no symbol; use a letter, then letters, digits or _")
    elif symbol in RESERVED:
        row.complain(
            node.line, f"{symbol} has a meaning of its own in formulas or in Python; use another letter"
        )
    meaning, (unit_text, unit_line) = row.text("is"), row.line_of("unit", "1")
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
            Grid(value, type(value)(0), 1),
            node.line,
            max(decimal_places(value), _decimals(node.entries["value"])),
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


def _constant(
    path: Path, node: TableNode | TextNode | ListNode, known: set[str], complaints: list[Diagnostic]
) -> Given | None:
    symbol = node.text.strip() if isinstance(node, TextNode) else ""
    found = CONSTANTS.get(symbol)
    if found is None:
        sentence = f"constants: {symbol or 'this'} is not known; there are {', '.join(CONSTANTS)}"
        complaints.append(Diagnostic(path, node.line, sentence))
        return None
    if symbol in known:
        complaints.append(
            Diagnostic(path, node.line, f"constants: {symbol} is a given, too; keep one of them")
        )
        return None
    grid, places = Grid(found.value, Fraction(0), 1), decimal_places(found.value)
    return Given(symbol, found.name, found.unit, found.value, grid, node.line, places, found.source)


def _conditions(
    path: Path,
    node: TableNode | TextNode | ListNode,
    givens: Mapping[str, Unit],
    hard: bool,
    complaints: list[Diagnostic],
) -> list[Condition]:
    if not isinstance(node, TextNode):
        complaints.append(
            Diagnostic(path, node.line, "a condition must be one relation, such as abs(v - w) > 1.5 m/s")
        )
        return []
    try:
        return [Condition(relation, text, hard, node.line) for relation, text in relations(node.text, givens)]
    except ValueError as error:
        complaints.append(Diagnostic(path, node.line, f"condition {node.text!r}: {error}"))
        return []


def _decimals(node: TableNode | TextNode | ListNode) -> int:
    """How many decimals a constant is written with: 9.80 keeps its zero."""
    written = re.fullmatch(r"\s*[-−]?\d*\.(\d+)\s*", node.text if isinstance(node, TextNode) else "")
    return len(written[1]) if written else 0


def _check_holes(
    path: Path, text: str, line: int, known: frozenset[str], complaints: list[Diagnostic]
) -> None:
    for symbol, style, at in holes(text):
        if symbol not in known:
            complaints.append(
                Diagnostic(
                    path, line + at, f"{{{{{symbol}}}}} is not among the givens ({', '.join(sorted(known))})"
                )
            )
        if style not in {"", "number", "svg"}:
            complaints.append(
                Diagnostic(path, line + at, f"{{{{{symbol}|{style}}}}}: the styles are number and svg")
            )
    for at, words in enumerate(HOLE.sub("", text).splitlines()):
        if "{{" in words and "}}" in words:
            complaints.append(
                Diagnostic(path, line + at, "a hole must hold one symbol: {{m}} or {{m|number}}")
            )
