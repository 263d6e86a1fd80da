"""PrairieLearn: what `server.py` draws and assigns, read as a syntax tree and not run, and the inputs of `question.html`."""

from __future__ import annotations

import ast
import os
import re
import warnings
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

from corollary.audit.readers.generate_body import GenerateBody
from corollary.audit.readers.html_tags import HtmlPiece, html_pieces
from corollary.audit.readers.python_names import DRAWN, PythonNames, names_of
from corollary.audit.readers.safe_xml import words_of
from corollary.audit.readers.straight_line import (
    MOST_ANSWERS,
    MOST_STATEMENTS,
    NotRead,
    PublishedFormula,
    StraightLine,
    known_unit,
)
from corollary.audit.record import ExerciseRecord
from corollary.audit.text_file import LARGEST_PROGRAM, text_of
from corollary.problem.diagnostic import Diagnostic, Malformed

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
        raise NotRead(f"the right option, {right[0]!r}, is no number")
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
            [Diagnostic(path, getattr(error, "lineno", 1) or 1, f"is no Python: {why}")]
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
