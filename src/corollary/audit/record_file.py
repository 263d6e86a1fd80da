"""A file of records read: YAML, JSON or CSV, each complaint with its line; a piece that is no YAML costs no other record."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeVar

from corollary.audit.forgiven import forgiven_from
from corollary.audit.record import (
    MOST_RECORDS,
    AskedLetter,
    AssumedValue,
    ExerciseRecord,
    LawText,
    StatedGiven,
    WrongLaw,
)
from corollary.audit.text_file import text_of
from corollary.formula.errors import ParseError, sentence
from corollary.formula.numerals import TO_ASCII, Written, scan_number
from corollary.formula.syntax import author_formula
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import ListNode, Node, Reader, TableNode, TextNode, document
from corollary.problem.givens import SYMBOL
from corollary.units.constants import CONSTANTS
from corollary.units.unit import PURE, Unit, unit

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
            found += _read_piece(path, lines, piece, faults)
        if all(isinstance(each, TextNode) for each in found):
            raise
    if head is None:
        return ListNode(tuple(found), 1)
    top = document(path, "".join(lines[:head]), faults)
    entries = dict(top.entries) if isinstance(top, TableNode) else {}
    return TableNode(entries | {"records": ListNode(tuple(found), head + 1)}, 1)


def _read_piece(path: Path, lines: list[str], piece: Chunk, faults: list[Diagnostic]) -> Iterator[Node]:
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
            raise Malformed([Diagnostic(path, line + 1, f"is not CSV: {error}")]) from None
        items.append(TextNode(f"is not CSV from here on, and is not read to its end: {error}", line + 1))
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


RANGE = re.compile(r"\s*(\S+?)\s*(?:\.\.|…)\s*(.+)")
LETTER = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
ASSUMED = re.compile(r"\s*([A-Za-z][A-Za-z0-9_]*)\s*=\s*(.+)")
OR = re.compile(r"\s*(?:,|\bor\b)\s*")


def given_from(symbol: str, text: str) -> StatedGiven:
    """`2 kg`, `2..5 kg`, `30 deg`, `0.25`, or a unit alone. Raises ValueError with a sentence."""
    if not SYMBOL.match(symbol):
        raise ValueError(f"{symbol!r} is not a letter; use a letter, then letters, digits or _")
    typed = text.translate(TO_ASCII).strip()
    spread = RANGE.fullmatch(typed)
    if spread is not None:
        low, _ = _number(spread[1], text)
        high, rest = _number(spread[2], text)
        if not low.value < high.value:
            raise ValueError(f"{text!r} is not a range: the smaller number comes first, as in 2..5 kg")
        return StatedGiven(symbol, _unit(rest), low.value, high.value)
    if re.match(r"1\s*/\s*[^\d\s.,]", typed) or not re.match(r"[-+]?\s*[\d.,½⅓⅔¼¾]", typed):
        return StatedGiven(symbol, unit(typed), None, None)
    number, rest = _number(typed, text)
    return StatedGiven(symbol, _unit(rest), number.value, number.value, number.figures)


def asked_from(text: str) -> AskedLetter:
    """`v`, or `v in km/h`. Raises ValueError with a sentence."""
    letter, mark, its_unit = text.strip().partition(" in ")
    if not LETTER.match(letter.strip()):
        raise ValueError(
            f"{text!r} does not name the letter that is asked for; write one of the laws' letters, as in `v` or `v in km/h`"
        )
    return AskedLetter(letter.strip(), unit(its_unit.strip()) if mark else None)


def assumed_from(text: str) -> AssumedValue | None:
    """`g = 9.8 m/s^2`, `g = 9.8 or 9.81 m/s^2`; None for a convention in words. Raises ValueError with a sentence."""
    found = ASSUMED.fullmatch(text)
    if found is None or re.search(r"\d", found[2]) is None:
        return None
    *others, last = OR.split(found[2].strip())
    number, rest = _number(last, text)
    values = [_number(each, text)[0].value for each in others]
    return AssumedValue(found[1], _unit(rest), (*values, number.value))


def _number(text: str, whole: str) -> tuple[Written, str]:
    found = scan_number(text.strip())
    if isinstance(found, ParseError):
        raise ValueError(f"{whole!r}: {sentence(found)}")
    number, end = found
    return number, text.strip()[end:].strip()


def _unit(text: str) -> Unit:
    return unit(text) if text else PURE


LAST_LINE = 1 << 31
OF_A_FILE = ("source", "address", "licence")
NO_RECORD = "is not a record; write `id: …` and what belongs to it"
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class FileHead:
    """What holds for all records of a file."""

    texts: Mapping[str, str]
    conventions: tuple[Node, ...] = ()
    constants: tuple[str, ...] = ()
    laws: Mapping[str, LawText] = field(default_factory=dict[str, LawText])


def records_in(path: Path, answers: bool = True) -> tuple[ExerciseRecord, ...]:
    """The records of a file; without `answers` they are laws for the exercises of a bank, and need not publish anything.

    One that is not in order is `unread`, with its complaints; of laws, and where not one record is in order, Malformed is raised
    with all complaints, each with its line.
    """
    source = text_of(path)
    faults: list[Diagnostic] = []
    root = rows_in(path, source) if path.suffix.lower() == ".csv" else records_node(path, source, faults)
    of_file: list[Diagnostic] = []
    head, listed = _head(path, root, of_file)
    of_file += [each for each in faults if not listed or each.line < listed[0].line]
    ends = [*(each.line for each in listed[1:]), LAST_LINE]
    if len(listed) > MOST_RECORDS:
        raise Malformed([Diagnostic(path, 1, f"has more than {MOST_RECORDS} records; divide it")])
    found: dict[str, ExerciseRecord] = {}
    against: list[Diagnostic] = []
    for node, end in zip(listed, ends, strict=False):
        complaints = [each for each in faults if node.line <= each.line < end]
        broken = bool(complaints) and isinstance(node, TextNode)  # no YAML, and said so already
        record = None if broken else _record(path, node, head, complaints, answers)
        if record is not None and record.id in found:
            first = found[record.id].line
            complaints.append(
                Diagnostic(path, record.line, f"`{record.id}` is the id of two records (line {first})")
            )
        if record is None or complaints:
            name = _id(node) if isinstance(node, TableNode) else ""
            name = name if name and name not in found else f"{path.name}:{node.line}"
            record = ExerciseRecord(name, path, node.line, unread="; ".join(map(str, complaints)))
        found[record.id] = record
        against += complaints
    if of_file or (against and (not answers or all(each.unread for each in found.values()))):
        raise Malformed(of_file + against)
    return tuple(found.values())


def _head(path: Path, root: Node | None, complaints: list[Diagnostic]) -> tuple[FileHead, tuple[Node, ...]]:
    match root:
        case ListNode(items):
            return FileHead({}), items
        case TableNode(entries) if "records" in entries:
            row = Reader(path, root, "the file", complaints)
            texts = {name: row.text(name, "") for name in OF_A_FILE}
            conventions = row.list_of("convention")
            laws = {each.name: each for each in _laws(row, "laws", {})}
            constants = tuple(_texts(row, "constants"))
            listed = row.list_of("records")
            row.finish()
            return FileHead(texts, conventions, constants, laws), listed
        case TableNode():
            return FileHead({}), (root,)
        case _:
            raise Malformed([Diagnostic(path, 1, "is not a list of records; each begins with `- id: …`")])


def _record(
    path: Path, node: Node, head: FileHead, complaints: list[Diagnostic], answers: bool
) -> ExerciseRecord | None:
    if not isinstance(node, TableNode):
        why = node.text if isinstance(node, TextNode) and path.suffix.lower() == ".csv" else NO_RECORD
        complaints.append(Diagnostic(path, node.line, why))
        return None
    before = len(complaints)
    row = Reader(path, node, f"record {_id(node) or f'on line {node.line}'}", complaints)
    own_id = row.text("id")
    problem, laws = row.text("problem", ""), tuple(_laws(row, "laws", head.laws))
    if bool(problem) == bool(laws) and len(complaints) == before:
        row.complain(node.line, f"record {own_id} needs either `laws` or a `problem`")
    given = tuple(_given(row))
    asked = tuple(_read(row, "asked", asked_from))
    published = tuple(_texts(row, "published"))
    if not asked or (len(asked) != len(published) and (answers or published)):
        row.complain(
            node.line,
            f"record {own_id} asks for {len(asked)} and publishes {len(published)}; one answer each, please",
        )
    forgives = tuple(_read(row, "forgives", forgiven_from))
    if len(forgives) not in {0, len(asked)}:
        row.complain(
            node.line, f"record {own_id} asks for {len(asked)} and forgives {len(forgives)}; one each, please"
        )
    own = _conventions(row, row.list_of("convention"))
    for_all = _conventions(row, head.conventions)
    here = {given.symbol for given in given} | {each.symbol for each in own if isinstance(each, AssumedValue)}
    assumed = [each for each in own if isinstance(each, AssumedValue)]
    assumed += [each for each in for_all if isinstance(each, AssumedValue) and each.symbol not in here]
    constants = (*_texts(row, "constants"), *(each for each in head.constants if each not in here))
    for name in constants:
        if name not in CONSTANTS:
            row.complain(
                node.line, f"{name} is not a constant known here; choose one of {', '.join(CONSTANTS)}"
            )
    found = ExerciseRecord(
        own_id,
        path,
        node.line,
        given,
        laws,
        tuple(_texts(row, "where")),
        asked,
        published,
        tuple(assumed),
        any(isinstance(each, str) for each in (*own, *for_all)),
        _figures(row),
        tuple(_mistakes(row)),
        tuple(dict.fromkeys(constants)),
        problem,
        source=row.text("source", head.texts.get("source", "")),
        address=row.text("address", head.texts.get("address", "")),
        licence=row.text("licence", head.texts.get("licence", "")),
        statement=row.text("statement", ""),
        forgives=forgives,
    )
    row.finish()
    return found if len(complaints) == before else None


def _id(node: TableNode) -> str:
    named = node.entries.get("id")
    return named.text.strip() if isinstance(named, TextNode) else ""


def _texts(row: Reader, name: str) -> Iterator[str]:
    for node in row.list_of(name):
        if isinstance(node, TextNode) and node.text.strip():
            yield node.text.strip()
        else:
            row.complain(node.line, f"`{name}` of {row.what} holds texts")


def _read(row: Reader, name: str, read: Callable[[str], T]) -> Iterator[T]:
    for node in row.list_of(name):
        try:
            yield read(node.text if isinstance(node, TextNode) else "")
        except ValueError as error:
            row.complain(node.line, f"{row.what}: {error}")


def _given(row: Reader) -> Iterator[StatedGiven]:
    for symbol, node in row.table_of("given").entries.items():
        try:
            yield given_from(symbol, node.text if isinstance(node, TextNode) else "")
        except ValueError as error:
            row.complain(node.line, f"{row.what}, {symbol}: {error}")


def _conventions(row: Reader, nodes: tuple[Node, ...]) -> list[AssumedValue | str]:
    found: list[AssumedValue | str] = []
    for node in nodes:
        words = node.text if isinstance(node, TextNode) else ""
        try:
            found.append(assumed_from(words) or words)
        except ValueError as error:
            row.complain(node.line, f"{row.what}: {error}")
    return found


def _laws(row: Reader, name: str, bank: Mapping[str, LawText]) -> Iterator[LawText]:
    """Texts, `name: text`, or names of laws of the file's head; in the head a table of them."""
    row.seen.add(name)
    held = row.table.entries.get(name)
    nodes = (
        tuple(TableNode({each: node}, node.line) for each, node in held.entries.items())
        if isinstance(held, TableNode)
        else row.list_of(name)
    )
    for node in nodes:
        match node:
            case TextNode(words) if words.strip() in bank:
                yield bank[words.strip()]
            case TextNode(words, line):
                title, mark, formula = words.strip().partition(": ")
                named = (
                    mark and "=" not in title
                )  # `Energy: m*g*h = m*v^2/2` in quotation marks, as JSON has it
                title, formula = (title, formula) if named else (words, words)
                yield from _law(row, title.strip(), formula.strip(), line)
            case TableNode(entries, line) if len(entries) == 1:
                ((title, inside),) = entries.items()
                if isinstance(inside, TextNode):
                    yield from _law(row, title, inside.text.strip(), line)
                else:
                    row.complain(line, f"`{title}` of {row.what} is not a text of a law")
            case _:
                row.complain(node.line, f"a law of {row.what} is a text, or `name: text`")


def _law(row: Reader, title: str, formula: str, line: int) -> Iterator[LawText]:
    try:
        author_formula(formula, operators=True)
    except ValueError as error:
        row.complain(line, f"{row.what}: {error}")
        return
    if "=" not in formula:
        row.complain(line, f"{row.what}: {formula!r} has no = sign, and is not a law of the file's head")
        return
    yield LawText(title, formula, line)


def _mistakes(row: Reader) -> Iterator[WrongLaw]:
    for node in row.list_of("mistakes"):
        match node:
            case TableNode(entries, line) if {"says", "law"} <= entries.keys():
                inner = Reader(row.path, node, f"a mistake of {row.what}", row.complaints)
                says, formula, instead = inner.text("says"), inner.text("law"), inner.text("instead", "")
                inner.finish()
            case TableNode(entries, line) if len(entries) == 1:
                ((says, law),) = entries.items()
                formula, instead = law.text if isinstance(law, TextNode) else "", ""
            case _:
                row.complain(node.line, f"a mistake of {row.what} is `what was done: law`")
                continue
        for law in _law(row, says, formula, line):
            yield WrongLaw(says, law.formula, instead, line)


def _figures(row: Reader) -> int | None:
    text, line = row.line_of("figures", "")
    if text and not (text.isdecimal() and 0 < int(text) < 20):
        row.complain(line, f"`figures: {text}` of {row.what} is not a number of figures")
        return None
    return int(text) if text else None
