"""PrairieLearn: what `server.py` draws and assigns, read as a syntax tree and not run, and the inputs of its page."""

from __future__ import annotations

import ast
import os
import re
import warnings
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import partial
from html import unescape
from pathlib import Path
from typing import Literal

from corollary.audit.readers.python_names import DRAWN, PythonNames, names_of
from corollary.audit.readers.straight_line import (
    MOST_ANSWERS,
    MOST_NODES,
    MOST_STATEMENTS,
    NotRead,
    PublishedFormula,
    StraightLine,
    known_unit,
)
from corollary.audit.record import ExerciseRecord
from corollary.audit.text_file import LARGEST_PROGRAM, text_of, words_of
from corollary.problem.diagnostic import Diagnostic, Malformed

NAME = re.compile(r"/?[A-Za-z][^\s/>]*")
BETWEEN = re.compile(r"[\s/]*")
ATTRIBUTE = re.compile(r"=?[^\s/>=]*")
EQUALS = re.compile(r"\s*=\s*")
UNQUOTED = re.compile(r"[^\s>]*")
OF_TEXT = {name: re.compile(rf"(?i)</{name}(?=[\s/>])") for name in ("script", "style", "textarea", "title")}
"""Elements in which nothing is a tag but their own end."""


@dataclass(frozen=True, slots=True)
class HtmlPiece:
    """`content` is the name of an element, in small letters, or a text."""

    kind: Literal["start", "end", "text"]
    content: str
    attributes: Mapping[str, str] = field(default_factory=dict[str, str])


def html_pieces(source: str) -> Iterator[HtmlPiece]:
    """The tags and the texts of a page, without comments and declarations."""
    at, begun = 0, 0  # where to look for a tag, and where the text before it begins
    while (opened := source.find("<", at)) >= 0:
        name = NAME.match(source, opened + 1)
        if name is None and source[opened + 1 : opened + 2] not in {"!", "?", "/"}:
            at = opened + 1  # a sign, as in `a < b`
            continue
        if begun < opened:
            yield HtmlPiece("text", unescape(source[begun:opened]))
        if name is None:
            comment = source.startswith("<!--", opened)
            ended = source.find("-->" if comment else ">", opened + 2)
            if ended < 0:
                return
            at = begun = ended + (3 if comment else 1)
            continue
        attributes, at = _attributes(source, name.end())
        if at < 0:
            return
        begun, tag = at, name[0].lower()
        if tag.startswith("/"):
            yield HtmlPiece("end", tag[1:])
            continue
        yield HtmlPiece("start", tag, attributes)
        if tag in OF_TEXT:
            ends = OF_TEXT[tag].search(source, at)
            if ends is None:
                return
            at = begun = ends.start()
    if begun < len(source):
        yield HtmlPiece("text", unescape(source[begun:]))


def _attributes(source: str, at: int) -> tuple[dict[str, str], int]:
    """The attributes of a tag, the first of each name, and where it has ended; -1 where it does not."""
    found: dict[str, str] = {}
    while True:
        at = _end(BETWEEN, source, at)
        if at >= len(source):
            return found, -1
        if source[at] == ">":
            return found, at + 1
        end = _end(ATTRIBUTE, source, at)
        name, value, at = source[at:end].lower(), "", end
        if (equals := EQUALS.match(source, at)) is not None:
            at = equals.end()
            quote = source[at : at + 1]
            if quote in {'"', "'"}:
                end = source.find(quote, at + 1)
                if end < 0:
                    return found, -1
                value, at = source[at + 1 : end], end + 1
            else:
                end = _end(UNQUOTED, source, at)
                value, at = source[at:end], end
        found.setdefault(name, unescape(value))


def _end(pattern: re.Pattern[str], source: str, at: int) -> int:
    """Where a pattern that may be empty has ended."""
    found = pattern.match(source, at)
    return found.end() if found is not None else at


Where = Literal["letter", "shown", "answer"]
TABLES = ("params", "correct_answers")


@dataclass(frozen=True, slots=True)
class GenerateSetting:
    """A letter of the program, a letter that is drawn right into `params` (it counts only where a key needs it), or an answer."""

    where: Where
    name: str
    value: ast.expr


@dataclass(slots=True)
class GenerateBody:
    """`data` is the parameter of `generate`; `tables` are names that stand for its `params` or `correct_answers`, and `params` is what
    was put there, `texts` what of it is a text, `in_params` the letters in it."""

    data: str
    names: PythonNames
    tables: dict[str, str] = field(default_factory=dict[str, str])
    params: dict[str, ast.expr] = field(default_factory=dict[str, ast.expr])
    texts: set[str] = field(default_factory=set[str])
    in_params: set[str] = field(default_factory=set[str])

    def settings(self, statements: Sequence[ast.stmt]) -> Iterator[GenerateSetting]:
        """In their order, up to a return. Raises NotRead for whatever is no plain assignment."""
        for statement in statements:
            match statement:
                case ast.Return():
                    return
                case ast.Expr(ast.Constant()) | ast.Pass():
                    continue
                case ast.AnnAssign(target, _, ast.expr() as value):
                    yield from self._set(target, value)
                case ast.AugAssign(ast.Name(name), operator, value):
                    before = ast.copy_location(ast.Name(name, ast.Load()), statement)
                    changed = ast.copy_location(ast.BinOp(before, operator, value), statement)
                    yield from self._set(ast.Name(name, ast.Store()), changed)
                case ast.Assign(targets, value):
                    for target in sorted(targets, key=lambda each: not isinstance(each, ast.Name)):
                        yield from self._set(target, value)
                        if isinstance(target, ast.Name):
                            value = ast.copy_location(ast.Name(target.id, ast.Load()), value)
                case ast.Expr(ast.Call(ast.Attribute(table, "update"), args, keywords)) if self._table(table):
                    for each in args:
                        yield from self._set(table, each)
                    for keyword in keywords:
                        yield from self._enter(self._table(table), keyword.arg, keyword.value)
                case _:
                    raise NotRead(f"line {statement.lineno} of server.py is not an assignment")

    def _set(self, target: ast.expr, value: ast.expr) -> Iterator[GenerateSetting]:
        match target, value:
            case ast.Tuple(targets), ast.Tuple(values) if len(targets) == len(values):
                for one, other in zip(targets, values, strict=True):
                    yield from self._set(one, other)
            case ast.Name(name), _ if table := self._table(value):
                self.tables[name] = table
            case ast.Name(name), _:
                value = self._looked_up(value)
                if isinstance(value, ast.Name) and value.id == name:
                    return
                self.names.refuse_hidden(name)
                if name in self.tables or name in self.in_params:
                    raise NotRead(f"line {value.lineno} of server.py changes {name} after it is shown")
                yield GenerateSetting("letter", name, value)
            case ast.Subscript(inner, ast.Constant(str(name))), _ if table := self._table(inner):
                yield from self._enter(table, name, value)
            case _, ast.Dict(keys, values) if table := self._table(target):
                for key, each in zip(keys, values, strict=True):
                    name = key.value if isinstance(key, ast.Constant) and isinstance(key.value, str) else None
                    yield from self._enter(table, name, each)
            case _:
                raise NotRead(f"line {target.lineno} of server.py is not an assignment")

    def _enter(self, table: str, name: str | None, value: ast.expr) -> Iterator[GenerateSetting]:
        if name is None:
            raise NotRead(f"line {value.lineno} of server.py puts something into {table} under no plain name")
        if table == "correct_answers":
            yield GenerateSetting("answer", name, self._looked_up(value))
            return
        if name in self.params:
            raise NotRead(f"params[{name!r}] is set twice")
        if isinstance(value, ast.JoinedStr) or self.names.function(value) == "str":
            self.texts.add(name)
        self.params[name] = self.names.unrounded(self._looked_up(value))
        if self.names.function(value) in DRAWN:
            yield GenerateSetting("shown", name, value)
            self.params[name] = ast.copy_location(ast.Name(name, ast.Load()), value)
        self.in_params |= _letters(self.params[name])

    def _table(self, node: ast.expr) -> str:
        """Which table of `data` an expression is; "" for none."""
        match node:
            case ast.Subscript(ast.Name(owner), ast.Constant(str(name))) if (
                owner == self.data and name in TABLES
            ):
                return name
            case ast.Name(name):
                return self.tables.get(name, "")
            case _:
                return ""

    def _looked_up(self, value: ast.expr) -> ast.expr:
        body = self

        class LookUp(ast.NodeTransformer):
            def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
                match node.slice:
                    case ast.Constant(str(name)) if (
                        name in body.params and body._table(node.value) == "params"
                    ):
                        if name in body.texts:
                            raise NotRead(f"params[{name!r}] is a text, which is not a number in Python")
                        return deepcopy(body.params[name])
                    case _:
                        return node

        found: ast.expr = LookUp().visit(deepcopy(value))
        if sum(1 for _ in ast.walk(found)) > MOST_NODES:
            raise NotRead(f"line {value.lineno} of server.py is too long an expression with params put in")
        return found


def _letters(value: ast.expr) -> set[str]:
    return {node.id for node in ast.walk(value) if isinstance(node, ast.Name)}


INPUTS = {"pl-number-input", "pl-units-input", "pl-symbolic-input"}
TAKES_ANSWER = ("-input", "-choice", "-checkbox")
HOLE = re.compile(r"\{\{[^{}]*\}\}")
ARITHMETIC = (
    ast.Constant, ast.Name, ast.Attribute, ast.Call, ast.BinOp, ast.UnaryOp, ast.Load,
    ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow, ast.USub, ast.UAdd,
)  # fmt: skip
SIGNS: Mapping[type[ast.operator], str] = {ast.Mult: "*", ast.Div: "/", ast.Add: "+", ast.Sub: "-"}


def prairielearn_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The answers of the exercise of a folder, each a record: `fall` where it is the only one, else `fall#v`, by its name.

    Read from `question.html`, and `server.py` beside it. Raises Malformed.
    """
    if path.name != "question.html":
        raise Malformed([Diagnostic(path, 1, "is read when it is the question.html of an exercise's folder")])
    name, source = folder_name(path), text_of(path, LARGEST_PROGRAM)
    bare = ExerciseRecord(name, path, 1, statement=words_of(HOLE.sub("…", source)))
    try:
        inputs = _inputs_in(source)
        if not inputs:
            raise NotRead("it has no input")
    except NotRead as error:
        return (replace(bare, unread=str(error)),)
    server = PrairieLearnServer(path.parent / "server.py")
    if len(inputs) == 1:
        return (_record(bare, inputs[0], server),)
    names = [each.get("answers-name", "") for each in inputs]
    if "" in names or len(set(names)) < len(names):
        names = [str(place) for place in range(1, len(inputs) + 1)]
    return tuple(
        _record(replace(bare, id=f"{name}#{one}"), element, server)
        for one, element in zip(names, inputs, strict=True)
    )


def folder_name(path: Path) -> str:
    """The name of the folder of a question, wherever its path leads."""
    return os.path.basename(os.path.dirname(os.path.realpath(path)))


class PrairieLearnServer:
    """The `server.py` of a question, read once, and only where an answer needs it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._read: (
            tuple[StraightLine, dict[str, PublishedFormula | NotRead], frozenset[str]] | NotRead | None
        ) = None

    def key(self, name: str) -> PublishedFormula:
        """What is assigned to the correct answer of this name. Raises NotRead, and Malformed where the file is no Python."""
        if self._read is None:
            try:
                self._read = _program(self.path)
            except NotRead as error:
                self._read = error
        if isinstance(self._read, NotRead):
            raise self._read
        program, keys, in_params = self._read
        found = keys.get(name, NotRead(f"server.py assigns no correct answer {name!r}"))
        if isinstance(found, NotRead):
            raise found
        return PublishedFormula(
            found.text, tuple(program.drawn.values()), in_params | program.formulas.keys()
        )

    @property
    def answers(self) -> bool:
        """Whether it sets correct answers, for all that can be seen."""
        return self.path.is_file() and "correct_answers" in text_of(self.path, LARGEST_PROGRAM)


def _record(bare: ExerciseRecord, element: Mapping[str, str], server: PrairieLearnServer) -> ExerciseRecord:
    try:
        return _read(bare, element, server)
    except NotRead as error:
        return replace(bare, unread=str(error))


def _read(bare: ExerciseRecord, element: Mapping[str, str], server: PrairieLearnServer) -> ExerciseRecord:
    unit = element.get("suffix", "").replace("$", "").strip()
    if element["tag"] == "pl-multiple-choice":
        return replace(bare, published=(_right_option(element),))
    if element["tag"] not in INPUTS:
        raise NotRead(f"{element['tag']} is not read")
    if "correct-answer" in element:
        if server.answers:
            raise NotRead("its answer stands in question.html, and server.py sets answers, too")
        return replace(bare, published=(f"{element['correct-answer']} {unit}".strip(),))
    key = server.key(element.get("answers-name", ""))
    return replace(
        bare,
        given=key.drawn,
        published=(key.text,),
        worked_out=key.worked_out,
        key_unit=unit if known_unit(unit) else "",
    )


def _right_option(element: Mapping[str, str]) -> str:
    """The text of the option that is right. Raises NotRead."""
    right = element["right"].splitlines()
    if len(right) != 1 or "{{" in right[0]:
        raise NotRead(f"{len(right)} of its options are marked as right in question.html")
    if not re.search(r"\d", right[0]):
        raise NotRead(f"the right option, {right[0]!r}, is not a number")
    return right[0]


def inputs_of(path: Path) -> list[dict[str, str]]:
    """The attributes of each input of a `question.html`, its tag among them. Raises Malformed and NotRead."""
    return _inputs_in(text_of(path, LARGEST_PROGRAM))


def _inputs_in(source: str) -> list[dict[str, str]]:
    """The elements that take an answer: their attributes, `tag`, and, a line each, the options that are `right`. Raises NotRead."""
    found: list[dict[str, str]] = []
    right: list[list[str]] = []
    in_right_option = False
    for piece in html_pieces(source):
        match piece:
            case HtmlPiece("start", tag, attributes) if tag.startswith("pl-") and tag.endswith(TAKES_ANSWER):
                if len(found) >= MOST_ANSWERS:
                    raise NotRead(f"it has more than {MOST_ANSWERS} inputs")
                found.append({"tag": tag, **attributes})
                right.append([])
            case HtmlPiece("start", "pl-answer", attributes) if found:
                if attributes.get("correct", "").lower() == "true":
                    right[-1].append("\n")
                    in_right_option = True
            case HtmlPiece("end", "pl-answer"):
                in_right_option = False
            case HtmlPiece("text", words) if in_right_option:
                right[-1].append(" ".join(words.split()))
            case _:
                continue
    pairs = zip(found, right, strict=True)
    return [{**element, "right": "".join(pieces).lstrip("\n")} for element, pieces in pairs]


def _program(path: Path) -> tuple[StraightLine, dict[str, PublishedFormula | NotRead], frozenset[str]]:
    """What `generate` draws and assigns, the correct answers by name, each as it is where it is assigned, and what else is shown.

    Raises NotRead, and Malformed where it is no Python.
    """
    if not path.is_file():
        raise NotRead("there is no server.py beside it, and no correct-answer in it")
    source = text_of(path, LARGEST_PROGRAM)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of somebody else's style
            tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        why = str(error) or "it is nested too deeply"
        raise Malformed(
            [Diagnostic(path, getattr(error, "lineno", 1) or 1, f"is not Python: {why}")]
        ) from None
    names, generate = names_of(tree)
    if len(generate.args.args) != 1:
        raise NotRead("generate of server.py takes something else than data")
    if len(generate.body) > MOST_STATEMENTS:
        raise NotRead(f"generate of server.py has more than {MOST_STATEMENTS} statements")
    program, keys = StraightLine(), dict[str, PublishedFormula | NotRead]()
    body = GenerateBody(generate.args.args[0].arg, names)
    constants = [
        ast.copy_location(ast.Assign([ast.Name(name, ast.Store())], value), value)
        for name, value in names.constants.items()
    ]
    for each in body.settings([*constants, *generate.body]):
        if each.where == "answer":
            keys[each.name] = _key(program, names, each.value)
            continue
        if each.where == "shown" and each.name in program.formulas:
            raise NotRead(f"{each.name} is given a value twice")  # a key could mean either
        program.attempt(each.name, partial(_assign, program, names, each.name, each.value))
        if each.where == "letter" and each.name in program.unread:
            raise program.unread[each.name]  # it may have changed what is shown
    for name, printed in body.params.items():
        if name in program.drawn and not (isinstance(printed, ast.Name) and printed.id == name):
            raise NotRead(f"params[{name!r}] is another number than {name}")
    return program, keys, frozenset(body.params.keys() - program.drawn.keys())


def _key(program: StraightLine, names: PythonNames, value: ast.expr) -> PublishedFormula | NotRead:
    """An answer with its letters as they are where it is assigned, or why it is not made out."""
    try:
        return program.key(_arithmetic(names, names.unrounded(value)))
    except NotRead as error:
        return error


def _assign(program: StraightLine, names: PythonNames, letter: str, value: ast.expr) -> None:
    value, scale = names.unrounded(value), ""
    if isinstance(value, ast.BinOp) and (sign := SIGNS.get(type(value.op))) is not None:
        drawn = names.unrounded(value.left)
        if names.function(drawn) in DRAWN and isinstance(value.right, ast.Constant):
            value, scale = drawn, f"{sign}({value.right.value})"
    name = names.function(value)
    if not isinstance(value, ast.Call) or name not in DRAWN:
        program.assign(letter, _arithmetic(names, value))
        return
    match name, value.args:
        case "choice", [ast.List(values) | ast.Tuple(values)] if not value.keywords:
            program.draw_among(letter, [f"({_arithmetic(names, each)}){scale}" for each in values])
        case ("randint" | "uniform" | "randrange", [low, high]) | ("randrange", [low, high, _]) if (
            not value.keywords
        ):
            program.draw(letter, *(f"({_arithmetic(names, each)}){scale}" for each in (low, high)))
        case _:
            raise NotRead(f"line {value.lineno} of server.py draws {letter} in a way that is not read")


def _arithmetic(names: PythonNames, value: ast.expr) -> str:
    """The text of an expression that means in Python what it means in a formula: `^` and `//`, for instance, do not."""
    expression = names.in_formula_names(value)
    for node in ast.walk(expression):
        if not isinstance(node, ARITHMETIC):
            raise NotRead(f"line {value.lineno} of server.py has what no formula has ({type(node).__name__})")
    return ast.unparse(expression)
