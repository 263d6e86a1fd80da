"""PrairieLearn: what `server.py` draws and assigns, read as a syntax tree and not run, and the inputs of `question.html`."""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from html.parser import HTMLParser
from pathlib import Path

from corollary.audit.readers.generate_body import GenerateBody
from corollary.audit.readers.python_names import DRAWN, PythonNames, names_of
from corollary.audit.readers.safe_xml import words_of
from corollary.audit.readers.straight_line import NotRead, StraightLine, known_unit
from corollary.audit.record import ExerciseRecord
from corollary.audit.text_file import text_of
from corollary.problem.diagnostic import Diagnostic, Malformed

INPUTS = {"pl-number-input", "pl-units-input", "pl-symbolic-input"}
ARITHMETIC = (
    ast.Constant, ast.Name, ast.Attribute, ast.Call, ast.BinOp, ast.UnaryOp, ast.Load,
    ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow, ast.USub, ast.UAdd,
)  # fmt: skip
SIGNS: Mapping[type[ast.operator], str] = {ast.Mult: "*", ast.Div: "/", ast.Add: "+", ast.Sub: "-"}


class InputElements(HTMLParser):
    """The elements of a question that take an answer."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[dict[str, str]] = []
        self.in_right_option = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag.startswith("pl-") and tag.endswith(("-input", "-choice", "-checkbox")):
            self.found.append({"tag": tag, "right": "", **{name: value or "" for name, value in attrs}})
        elif tag == "pl-answer" and self.found and (dict(attrs).get("correct") or "").lower() == "true":
            self.found[-1]["right"] += "\n" * bool(self.found[-1]["right"])
            self.in_right_option = True

    def handle_endtag(self, tag: str) -> None:
        if tag == "pl-answer":
            self.in_right_option = False

    def handle_data(self, data: str) -> None:
        if self.in_right_option:
            self.found[-1]["right"] += " ".join(data.split())


def prairielearn_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The exercise of a folder, from its `question.html`; `server.py` beside it is read, too. Raises Malformed."""
    if path.name != "question.html":
        raise Malformed([Diagnostic(path, 1, "is read when it is the question.html of an exercise's folder")])
    name, source = path.resolve().parent.name, text_of(path)
    bare = ExerciseRecord(name, path, 1, statement=words_of(re.sub(r"\{\{.*?\}\}", "…", source)))
    try:
        return (_read(bare, _inputs_in(source), path.parent / "server.py"),)
    except NotRead as error:
        return (replace(bare, unread=str(error)),)


def _read(bare: ExerciseRecord, inputs: list[dict[str, str]], server: Path) -> ExerciseRecord:
    if len(inputs) != 1:
        raise NotRead(f"it has {len(inputs)} inputs, and one is read")
    (element,) = inputs
    unit = element.get("suffix", "").replace("$", "").strip()
    if element["tag"] == "pl-multiple-choice":
        return replace(bare, published=(_right_option(element),))
    if element["tag"] not in INPUTS:
        raise NotRead(f"{element['tag']} is not read")
    if "correct-answer" in element:
        if server.is_file() and "correct_answers" in text_of(server):
            raise NotRead("its answer stands in question.html, and server.py sets answers, too")
        return replace(bare, published=(f"{element['correct-answer']} {unit}".strip(),))
    program, keys = _program(server)
    answers_name = element.get("answers-name", "")
    if answers_name not in keys:
        raise NotRead(f"server.py assigns no correct answer {answers_name!r}")
    key = program.key(keys[answers_name])
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
    """The attributes of each input of a `question.html`, its tag among them. Raises Malformed."""
    return _inputs_in(text_of(path))


def _inputs_in(source: str) -> list[dict[str, str]]:
    elements = InputElements()
    elements.feed(source)
    elements.close()
    return elements.found


def _program(path: Path) -> tuple[StraightLine, dict[str, str]]:
    """What `generate` draws and assigns, and the correct answers by name. Raises NotRead, and Malformed where it is no Python."""
    if not path.is_file():
        raise NotRead("there is no server.py beside it, and no correct-answer in it")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of somebody else's style
            tree = ast.parse(text_of(path))
    except (SyntaxError, ValueError, RecursionError) as error:
        raise Malformed(
            [Diagnostic(path, getattr(error, "lineno", 1) or 1, f"is no Python: {error}")]
        ) from None
    names, generate = names_of(tree)
    if len(generate.args.args) != 1:
        raise NotRead("generate of server.py takes something else than data")
    program, keys = StraightLine(), dict[str, str]()
    body = GenerateBody(generate.args.args[0].arg, names)
    constants = [
        ast.copy_location(ast.Assign([ast.Name(name, ast.Store())], value), value)
        for name, value in names.constants.items()
    ]
    for each in body.settings([*constants, *generate.body]):
        if each.where == "answer":
            keys[each.name] = _arithmetic(names, names.unrounded(each.value))
            continue
        if each.where == "shown" and each.name in program.formulas:
            raise NotRead(f"{each.name} is given a value twice")  # a key could mean either
        program.attempt(each.name, partial(_assign, program, names, each.name, each.value))
        if each.where == "letter" and each.name in program.unread:
            raise program.unread[each.name]  # it may have changed what is shown
    for name, printed in body.params.items():
        if name in program.drawn and not (isinstance(printed, ast.Name) and printed.id == name):
            raise NotRead(f"params[{name!r}] is another number than {name}")
    return program, keys


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
