"""Front matter read node by node: every value is text with a line number, so YAML never guesses a type."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import yaml

from corollary.messages import did_you_mean
from corollary.problem.diagnostic import Diagnostic, Malformed


@dataclass(frozen=True, slots=True)
class TextNode:
    """`block` is 1 where the text begins on the next line, behind `|` or `>`."""

    text: str
    line: int
    block: int = 0


@dataclass(frozen=True, slots=True)
class TableNode:
    entries: dict[str, Node]
    line: int


@dataclass(frozen=True, slots=True)
class ListNode:
    items: tuple[Node, ...]
    line: int


Node = TextNode | TableNode | ListNode
DEEPEST = 50
MOST_ALIASES = 1000  # each is taken out of its line, which may be the whole file
REMEDIES = {
    "mapping values are not allowed": "put a text with a colon between quotation marks",
    "found character '\\t'": "indent with blanks, not with a tab",
    "cannot start any token": "put a text that begins with a sign of YAML (%, @, `, a tab) between quotation marks",
    "found undefined alias": "put a text that begins with * between quotation marks",
    "unexpected end of stream": "a quotation mark or a bracket is not closed",
    "expected ',' or '}'": "put a comma between two entries, or close the braces; a text with a comma or brackets needs quotation marks",
    "expected ',' or ']'": "put a comma between two entries, or close the brackets; a text with a comma or brackets needs quotation marks",
    "expected <block end>": "indent the lines of one table alike, and put a text with quotation marks, brackets or a colon between quotation marks",
    "could not find expected ':'": "each line is `name: value`, with a blank behind the colon",
}
"""What an author meant mostly, by what libyaml and PyYAML say."""
LONG = 100_000  # characters, which take PyYAML itself, without libyaml, seconds


def split(path: Path) -> tuple[TableNode, str, int]:
    """The front matter of a Markdown file, the body, and the line on which the body begins.

    Raises Malformed when the file cannot be read, has no front matter, or the front matter is not YAML.
    """
    if path.exists() and not path.is_file():
        raise Malformed([Diagnostic(path, 1, "is a folder, a pipe or a device; a problem is a file")])
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except UnicodeDecodeError as error:
        raise Malformed([Diagnostic(path, *not_utf8(error))]) from None
    except OSError as error:
        raise Malformed([Diagnostic(path, 1, f"cannot be read: {error.strerror}")]) from None
    if not lines or lines[0].strip() != "---":
        raise Malformed([Diagnostic(path, 1, "begins without front matter; the first line must be ---")])
    end = next((i for i, line in enumerate(lines[1:], 1) if line.strip() == "---"), None)
    if end is None:
        raise Malformed([Diagnostic(path, 1, "has front matter that never ends; close it with a line ---")])
    return _table(path, "\n".join(lines[1:end])), "\n".join(lines[end + 1 :]), end + 2


def not_utf8(error: UnicodeDecodeError) -> tuple[int, str]:
    """The line of the first byte that is no UTF-8, and what to do."""
    line = error.object[: error.start].count(b"\n") + 1
    return (
        line,
        f"is not in UTF-8 (byte {error.object[error.start]:#04x}); save the file in the encoding UTF-8",
    )


def _not_yaml(what: str, error: yaml.MarkedYAMLError) -> str:
    """What is wrong in PyYAML's own words, and what an author means mostly."""
    problem = error.problem or str(error)
    remedy = next((words for sign, words in REMEDIES.items() if sign in problem), "")
    return f"{what} is not YAML: {problem}{remedy and '; '}{remedy}"


def _compose(source: str) -> yaml.Node | None:
    """The tree of nodes: by libyaml where it is there, ten times as fast. Raises YAMLError in PyYAML's own words.

    libyaml composes recursively and without a guard: what is nested deeper than any front matter goes to PyYAML, too, which
    raises RecursionError where libyaml would end the process.
    """
    if yaml.__with_libyaml__:
        with suppress(yaml.YAMLError):
            depth = deepest = 0
            for event in yaml.parse(source, Loader=yaml.CSafeLoader):
                depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(
                    event, yaml.CollectionEndEvent
                )
                deepest = max(deepest, depth)
                if deepest > DEEPEST:
                    break
            else:
                return yaml.compose(source, Loader=yaml.CSafeLoader)
    return yaml.compose(source, Loader=yaml.SafeLoader)


def _table(path: Path, source: str) -> TableNode:
    node = _document(path, source, "front matter", first=2)
    if node is None:
        return TableNode({}, 2)
    if not isinstance(node, TableNode):
        raise Malformed([Diagnostic(path, 2, "front matter must be a list of `name: value` lines")])
    return node


def document(path: Path, source: str, faults: list[Diagnostic] | None = None) -> Node | None:
    """A whole file of YAML (or JSON, which is YAML) from somebody else: without anchors, which can make much of little.

    Raises Malformed; where `faults` are collected, not for what is wrong with one node.
    """
    depth = 0
    aliases: list[yaml.AliasEvent] = []
    try:
        for event in yaml.parse(
            source, Loader=yaml.SafeLoader if not yaml.__with_libyaml__ else yaml.CSafeLoader
        ):
            line: int = event.start_mark.line + 1
            if isinstance(event, yaml.AliasEvent):
                aliases.append(event)
            depth += isinstance(event, yaml.CollectionStartEvent)
            depth -= isinstance(event, yaml.CollectionEndEvent)
            if depth > DEEPEST:
                raise Malformed([Diagnostic(path, line, "is nested too deeply")])
    except yaml.YAMLError as error:
        if len(source) > LONG and isinstance(error, yaml.MarkedYAMLError) and error.problem_mark:
            line = int(error.problem_mark.line) + 1
            raise Malformed([Diagnostic(path, line, _not_yaml("the file", error))]) from None
        return _document(path, source, "the file", first=1)  # which says what is wrong in PyYAML's own words
    if len(aliases) > MOST_ALIASES:
        raise Malformed(
            [Diagnostic(path, 1, f"refers to other places (*name) more than {MOST_ALIASES} times")]
        )
    found, source = _without_aliases(path, source, aliases)
    if found and faults is None:
        raise Malformed(found)
    if faults is not None:
        faults += found
    return _document(path, source, "the file", first=1, faults=faults)


def _without_aliases(path: Path, source: str, aliases: list[yaml.AliasEvent]) -> tuple[list[Diagnostic], str]:
    """A complaint for each alias, and the source with them as plain texts, which refer to nothing."""
    if not aliases:
        return [], source
    found: list[Diagnostic] = []
    lines = source.splitlines(keepends=True)
    for each in reversed(aliases):
        row: int = each.start_mark.line
        start, end = each.start_mark.column, each.end_mark.column
        found.insert(0, Diagnostic(path, row + 1, "refers to another place (*name); write it out"))
        lines[row] = f"{lines[row][:start]}'{lines[row][start:end]}'{lines[row][end:]}"
    return found, "".join(lines)


def _document(
    path: Path, source: str, what: str, first: int, faults: list[Diagnostic] | None = None
) -> Node | None:
    """The nodes of a text whose first line has this number; None for an empty one. Raises Malformed."""
    try:
        root = _compose(source)
    except RecursionError:
        raise Malformed([Diagnostic(path, first, f"{what} is nested too deeply")]) from None
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + first if error.problem_mark else 1
        raise Malformed([Diagnostic(path, line, _not_yaml(what, error))]) from None
    except yaml.YAMLError as error:
        raise Malformed([Diagnostic(path, 1, f"{what} is not YAML: {error}")]) from None
    if root is None:
        return None
    complaints: list[Diagnostic] = []
    node = _node(path, root, complaints, what, first, depth=0)
    if complaints and faults is None:
        raise Malformed(complaints)
    if faults is not None:
        faults += complaints
    return node


def _node(
    path: Path, node: yaml.Node, complaints: list[Diagnostic], what: str, first: int, depth: int
) -> Node:
    line = node.start_mark.line + first  # the mark counts from 0
    match node:
        case _ if depth > 6:
            complaints.append(Diagnostic(path, line, f"{what} is nested too deeply (or refers to itself)"))
            return TextNode("", line)
        case yaml.ScalarNode():
            return TextNode(node.value, line, int(node.style in ("|", ">")))
        case yaml.SequenceNode():
            items = (_node(path, item, complaints, what, first, depth + 1) for item in node.value)
            return ListNode(tuple(items), line)
        case yaml.MappingNode():
            entries: dict[str, Node] = {}
            for key, value in node.value:
                name, at = key.value if isinstance(key, yaml.ScalarNode) else "", key.start_mark.line + first
                if not name:
                    complaints.append(Diagnostic(path, at, "a name on the left of a colon must be one word"))
                elif name in entries:
                    complaints.append(Diagnostic(path, at, f"`{name}` is given twice; keep one of them"))
                else:
                    entries[name] = _node(path, value, complaints, what, first, depth + 1)
            return TableNode(entries, line)
        case _:
            complaints.append(Diagnostic(path, line, "this kind of YAML node is not supported here"))
            return TextNode("", line)


class Reader:
    """Takes entries out of one table, collecting complaints instead of stopping at the first."""

    def __init__(self, path: Path, table: TableNode, what: str, complaints: list[Diagnostic]):
        self.path, self.table, self.what, self.complaints = path, table, what, complaints
        self.seen: set[str] = set()

    def complain(self, line: int, sentence: str) -> None:
        self.complaints.append(Diagnostic(self.path, line, sentence))

    def text(self, name: str, default: str | None = None) -> str:
        return self.line_of(name, default)[0]

    def line_of(self, name: str, default: str | None = None) -> tuple[str, int]:
        self.seen.add(name)
        match self.table.entries.get(name):
            case TextNode(text, line) if text.strip() or default == "":
                return text, line
            case TextNode(line=line):
                self.complain(
                    line, f"`{name}` of {self.what} is empty; say what it is, or leave the line out"
                )
                return default or "", line
            case None if default is not None:
                return default, self.table.line
            case None:
                self.complain(self.table.line, f"{self.what} has no `{name}`")
            case TableNode(_, line) | ListNode(_, line):
                self.complain(line, f"`{name}` of {self.what} must be one value")
        return "", self.table.line

    def fraction(self, name: str, default: str | None = None) -> Fraction | None:
        text, line = self.line_of(name, default)
        if text == "" and default == "":
            return None
        number = exact(text)
        if number is None and text:
            self.complain(
                line, f"`{name}: {text}` of {self.what} is not a number; write it as 0.43, -2, 1/3 or 1.2e3"
            )
        return number

    def table_of(self, name: str) -> TableNode:
        self.seen.add(name)
        match self.table.entries.get(name):
            case TableNode() as table:
                return table
            case None:
                return TableNode({}, self.table.line)
            case TextNode(line=line) | ListNode(_, line):
                self.complain(line, f"`{name}` of {self.what} must hold `name: value` lines")
                return TableNode({}, line)

    def list_of(self, name: str) -> tuple[Node, ...]:
        self.seen.add(name)
        match self.table.entries.get(name):
            case ListNode(items, _):
                return items
            case None:
                return ()
            case TextNode() as one:
                return (one,)
            case TableNode(_, line):
                self.complain(line, f"`{name}` of {self.what} must be a list of `- …` lines")
                return ()

    def finish(self) -> None:
        """Complains about every entry nobody asked for."""
        for name, node in self.table.entries.items():
            if name not in self.seen:
                hint, known = did_you_mean(name, self.seen), ", ".join(sorted(self.seen))
                self.complain(node.line, f"`{name}` of {self.what} is not known{hint}; known are {known}")


def exact(text: str) -> Fraction | None:
    """The exact rational a plain decimal or fraction stands for, or None. Bounded: no exponent beyond 400."""
    text = text.strip().replace("−", "-")
    if len(text) > 60 or not text.isascii():
        return None
    _, mark, power = text.lower().partition("e")
    if mark and not (re.fullmatch(r"[+-]?\d{1,9}", power) and abs(int(power)) <= 400):
        return None
    if "_" in text:
        return None
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        return None
