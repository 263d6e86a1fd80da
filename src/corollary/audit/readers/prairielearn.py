"""PrairieLearn: what `server.py` draws and assigns, read as a syntax tree and not run, and the inputs of `question.html`."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from html.parser import HTMLParser
from pathlib import Path

from corollary.audit.readers.generate_body import DRAWN, GenerateBody, called, unrounded
from corollary.audit.readers.safe_xml import words_of
from corollary.audit.readers.straight_line import NotRead, StraightLine
from corollary.audit.record import ExerciseRecord
from corollary.audit.record_file import text_of
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

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag.startswith("pl-") and tag.endswith(("-input", "-choice", "-checkbox")):
            self.found.append({"tag": tag, **{name: value or "" for name, value in attrs}})


def prairielearn_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The exercise of a folder, from its `question.html`; `server.py` beside it is read, too. Raises Malformed."""
    if path.name != "question.html":
        raise Malformed([Diagnostic(path, 1, "is read when it is the question.html of an exercise's folder")])
    name, source = path.resolve().parent.name, text_of(path)
    inputs = _inputs_in(source)
    statement = words_of(re.sub(r"\{\{.*?\}\}", "…", source))
    bare = ExerciseRecord(name, path, 1, statement=statement)
    try:
        if len(inputs) != 1:
            raise NotRead(f"it has {len(inputs)} inputs, and one is read")
        (element,) = inputs
        if element["tag"] not in INPUTS:
            raise NotRead(f"{element['tag']} is not read")
        unit = element.get("suffix", "").replace("$", "").strip()
        if "correct-answer" in element:
            published = f"{element['correct-answer']} {unit}".strip()
            return (ExerciseRecord(name, path, 1, published=(published,), statement=statement),)
        program, keys = _program(path.parent / "server.py")
        answers_name = element.get("answers-name", "")
        if answers_name not in keys:
            raise NotRead(f"server.py assigns no correct answer {answers_name!r}")
        formula, drawn = program.key(keys[answers_name])
        return (ExerciseRecord(name, path, 1, drawn, published=(formula,), statement=statement),)
    except NotRead as error:
        return (ExerciseRecord(name, path, 1, statement=bare.statement, unread=str(error)),)


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
        tree = ast.parse(text_of(path))
    except (SyntaxError, ValueError, RecursionError) as error:
        raise Malformed(
            [Diagnostic(path, getattr(error, "lineno", 1) or 1, f"is no Python: {error}")]
        ) from None
    functions = [each for each in tree.body if isinstance(each, ast.FunctionDef) and each.name == "generate"]
    if len(functions) != 1:
        raise NotRead("server.py has no function generate(data)")
    program, keys, unread = StraightLine(), dict[str, str](), dict[str, str]()
    for each in GenerateBody().settings([*_constants(tree), *functions[0].body]):
        if each.where == "answer":
            keys[each.name] = _arithmetic(unrounded(each.value))
            continue
        if each.where == "shown":
            program.refuse_again(each.name)  # else a key could mean either
        elif each.name in unread:
            raise NotRead(unread[each.name])
        try:
            _assign(program, each.name, unrounded(each.value))
        except NotRead as error:
            if each.where == "letter":
                raise
            unread[each.name] = str(error)  # it counts only where the key needs it
    return program, keys


def _constants(tree: ast.Module) -> list[ast.stmt]:
    """Numbers that stand before the functions, such as `g = 9.81`."""
    return [
        each for each in tree.body if isinstance(each, ast.Assign) and isinstance(each.value, ast.Constant)
    ]


def _assign(program: StraightLine, letter: str, value: ast.expr) -> None:
    scale = ""
    if isinstance(value, ast.BinOp) and (sign := SIGNS.get(type(value.op))) is not None:
        drawn = unrounded(value.left)
        if called(drawn) in DRAWN and isinstance(value.right, ast.Constant):
            value, scale = drawn, f"{sign}({value.right.value})"
    name = called(value)
    if not isinstance(value, ast.Call) or name not in DRAWN:
        program.assign(letter, _arithmetic(value))
        return
    inside = value.args
    if name == "choice" and len(inside) == 1 and isinstance(inside[0], ast.List | ast.Tuple):
        program.draw_among(letter, [f"({ast.unparse(each)}){scale}" for each in inside[0].elts])
    elif name in {"randint", "uniform", "randrange"} and len(inside) in {2, 3}:
        program.draw(letter, *(f"({ast.unparse(each)}){scale}" for each in inside[:2]))
    else:
        raise NotRead(f"line {value.lineno} of server.py draws {letter} in a way that is not read")


def _arithmetic(value: ast.expr) -> str:
    """The text of an expression that means in Python what it means in a formula: `^` and `//`, for instance, do not."""
    for node in ast.walk(value):
        if not isinstance(node, ARITHMETIC):
            raise NotRead(f"line {value.lineno} of server.py has what no formula has ({type(node).__name__})")
    return ast.unparse(value)
