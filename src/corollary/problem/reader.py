"""From a Markdown file to a problem; every failing is a complaint with its line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

from corollary.formula.ast import ZERO, Name, Relation
from corollary.formula.latex import tex_of_letter
from corollary.messages import did_you_mean
from corollary.problem.conditions import relations
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.figure import is_svg, read_lines
from corollary.problem.front_matter import ListNode, Reader, TableNode, TextNode, split
from corollary.problem.given import Given, Grid, decimal_places
from corollary.problem.givens import read_given
from corollary.problem.packed_pictures import count, packed
from corollary.problem.parts_markdown import read_parts
from corollary.problem.problem import Condition, Description, Problem
from corollary.problem.row_tables import columns_as_givens, letters_in, read_columns, without_values
from corollary.problem.statement import HOLE, LETTER, holes, misfit
from corollary.problem.variable import Variable
from corollary.problem.variable_rows import misfits_of_variables, read_variables
from corollary.units.constants import CONSTANTS
from corollary.units.unit import Unit

CODE = re.compile(r"[A-Za-z][A-Za-z0-9]*(\.[A-Za-z0-9]+)*$")
DIFFICULTIES = ("1", "2", "3", "4", "5")


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
    original, _, language = path.stem.rpartition(".")
    if not code and original and "of" in table.entries:
        alone = (
            f"this is {original}.md in another language ({language}), and {original}.md is not beside it; "
            "put it back, or remove this file"
        )
        raise Malformed([Diagnostic(path, 1, alone)])
    if code and not CODE.match(code):
        front.complain(
            code_line,
            f"code: {code} is not a valid code; use letters and digits, separated by points, such as X12.5",
        )
    rows = front.table_of("given").entries
    before = len(complaints)
    columns = read_columns(path, table.entries.get("rows"), complaints)
    front.seen.add("rows")
    faulty = len(complaints) > before
    of_rows = columns_as_givens(path, columns, rows, complaints)
    for symbol in without_values(rows, columns) if "rows" in table.entries else ():
        of_rows[symbol] = None
        if not faulty:
            why = f"{symbol} has no `value`, and no column of rows is called {symbol}"
            complaints.append(Diagnostic(path, rows[symbol].line, why))
    rows = rows | {
        symbol: TextNode("", column.line) for symbol, column in columns.items() if symbol not in rows
    }
    givens = tuple(
        given
        for symbol, node in rows.items()
        if (given := of_rows[symbol] if symbol in of_rows else read_given(path, symbol, node, complaints))
        is not None
    )
    known = frozenset(rows) | letters_in(table.entries.get("rows"))  # those with a fault too
    constants = [
        given
        for node in front.list_of("constants")
        if (given := _constant(path, node, {*known}, complaints)) is not None
    ]
    givens, known = (*givens, *constants), known | {given.symbol for given in constants}
    variables = read_variables(front, known, complaints)
    units = {given.symbol: given.unit for given in givens}
    nodes = [
        (node, hard) for name, hard in (("where", False), ("require", True)) for node in front.list_of(name)
    ]
    conditions = [
        condition
        for node, hard in (
            nodes if len(givens) == len(rows) + len(constants) else ()
        )  # one fault is one complaint
        for condition in _conditions(path, node, units, hard, variables, complaints)
    ]
    conditions += [
        Condition(Relation(">", Name(given.symbol), ZERO), f"{given.symbol} > 0", True, given.line)
        for given in constants
    ]
    (figure, figure_line), (alt, alt_line) = front.line_of("figure", ""), front.line_of("alt", "")
    description = _description(front)
    meant, printed = _meant(front), _printed_letters(front)
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
    body = packed(path, body, line, complaints)
    statement, parts, expected = read_parts(path, body, line, complaints)
    for text, first in ((body, line), (figure, first_line), (alt, alt_line)):
        _check_holes(
            path, text, first, {given.symbol: given for given in givens}, known, variables, complaints
        )
    for text, at in ((title, title_line), *((part.title, part.line) for part in parts)):
        if holes(text):
            complaints.append(
                Diagnostic(path, at, f"the title {text!r} has a hole; use holes in the text below it only")
            )
        if count(text):
            complaints.append(Diagnostic(path, at, "a picture stands in the text below a title, not in it"))
    for part in parts:
        if not part.answer_types:
            complaints.append(
                Diagnostic(
                    path,
                    part.line,
                    f"part {part.id} has no kind of answer; write one into the heading, such as .value",
                )
            )
        if "choice" not in part.answer_types and any(count(option.text) for option in part.options):
            complaints.append(
                Diagnostic(path, part.line, f"part {part.id} lists words, of which none can be a picture")
            )
    if not any(each.path == path and each.line in range(2, line) for each in complaints):
        complaints += misfits_of_variables(path, variables, parts)
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
        expected=expected,
        meant=meant,
        printed_letters=printed,
        variables=variables,
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


def _meant(front: Reader) -> tuple[str, ...]:
    """Numbers in the words that are meant for everybody, as they stand there."""
    found: list[str] = []
    for node in front.list_of("meant"):
        if isinstance(node, TextNode) and any(map(str.isdigit, node.text)):
            found.append(node.text.strip())
        else:
            front.complain(node.line, "meant: lists numbers as they stand in the words: meant: [50 km/h, 12]")
    return tuple(found)


def _printed_letters(front: Reader) -> tuple[tuple[str, str], ...]:
    """Letters with the TeX they are printed in."""
    found: list[tuple[str, str]] = []
    for name, node in front.table_of("shown").entries.items():
        try:
            if not isinstance(node, TextNode):
                raise ValueError("write one letter for each name: shown: {pH: pH, dv: Δv}")
            found.append((name, tex_of_letter(node.text.strip())))
        except ValueError as error:
            front.complain(node.line, f"shown: {name}: {error}")
    return tuple(found)


def _constant(
    path: Path, node: TableNode | TextNode | ListNode, known: set[str], complaints: list[Diagnostic]
) -> Given | None:
    symbol = node.text.strip() if isinstance(node, TextNode) else ""
    found = CONSTANTS.get(symbol)
    if found is None:
        sentence = f"constants: {symbol or 'this'} is not known{did_you_mean(symbol, CONSTANTS)}; choose one of {', '.join(CONSTANTS)}"
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
    variables: tuple[Variable, ...],
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
        domain = next(
            (
                f"; {each.symbol} is a variable, whose domain is its `from` and `to` below variables:"
                for each in variables
                if each.symbol in LETTER.findall(node.text)
            ),
            "",
        )
        complaints.append(Diagnostic(path, node.line, f"condition {node.text!r}: {error}{domain}"))
        return []


def _check_holes(
    path: Path,
    text: str,
    line: int,
    givens: Mapping[str, Given],
    known: frozenset[str],
    variables: tuple[Variable, ...],
    complaints: list[Diagnostic],
) -> None:
    """`known` are the givens with those that have a fault of their own: one fault is one complaint."""
    symbols = {each.symbol for each in variables}
    for hole in holes(text):
        if strange := sorted(set(LETTER.findall(hole.formula)) & symbols):
            why = f"{{{{{hole.text}}}}}: {strange[0]} is a variable and has no number; write ${strange[0]}$"
            complaints.append(Diagnostic(path, line + hole.line, why))
        elif not set(LETTER.findall(hole.formula)) & (known - givens.keys()) and (
            why := misfit(hole, givens)
        ):
            complaints.append(Diagnostic(path, line + hole.line, why))
    for at, words in enumerate(HOLE.sub("", text).splitlines()):
        if "{{" in words and "}}" in words:
            complaints.append(
                Diagnostic(
                    path,
                    line + at,
                    "a hole holds a given, or arithmetic of givens: {{m}}, {{m|number}}, {{2*m in g}}",
                )
            )
