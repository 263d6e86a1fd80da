"""One-place mutants of grading, formula and answers: every place that can be changed, and those drawn with a fixed seed."""

from __future__ import annotations

import ast
import copy
import random
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from mutant_server import ROOMS

Record = dict[str, Any]
TOP = Path(__file__).resolve().parents[1]
SEED = 12

COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
COMPUTED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult, ast.FloorDiv: ast.Div,
    ast.Mod: ast.Mult, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Mutant:
    """One place that can be changed: `source` is its line as it is, and `changed` the node that comes to stand there."""

    file: str
    line: int
    column: int
    what: str
    source: str
    node: ast.AST
    changed: ast.AST

    def text(self) -> str | None:
        """The whole module with the change; None where what comes out is no Python, or the same."""
        lines = (TOP / self.file).read_text(encoding="utf-8").splitlines(keepends=True)
        text = _written(lines, self.node, self.changed)
        return None if text == "".join(lines) else text


def mutants(path: Path) -> Iterator[Mutant]:
    """Every one-place mutant of a module; annotations and docstrings are left alone."""
    source = path.read_text(encoding="utf-8")
    lines, tree, file = source.splitlines(), ast.parse(source), path.relative_to(TOP).as_posix()
    left_alone = {id(node) for node in _annotations(tree)}
    for node in ast.walk(tree):
        if id(node) not in left_alone:
            for what, changed in _changes(node):
                line, column = _place(node)
                yield Mutant(file, line, column, what, lines[line - 1].strip(), node, changed)


def _annotations(tree: ast.Module) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        for name in ("annotation", "returns"):
            if (found := getattr(node, name, None)) is not None:
                yield from ast.walk(found)
        if (
            isinstance(node, ast.Assign)
            and isinstance(node.value, ast.BinOp)
            and isinstance(node.value.op, ast.BitOr)
        ):
            yield from ast.walk(node.value)  # a union of types
        if isinstance(node, ast.JoinedStr):
            yield from ast.walk(node)


def _changes(node: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """The node, changed in one way each."""
    match node:
        case ast.Compare(ops=[op]) if type(op) in COMPARED:
            other = COMPARED[type(op)]
            yield f"{type(op).__name__} → {other.__name__}", _with(node, ops=[other()])
        case ast.BinOp(op=op) if type(op) in COMPUTED:
            other = COMPUTED[type(op)]
            yield f"{type(op).__name__} → {other.__name__}", _with(node, op=other())
        case ast.BoolOp(op=op):
            other = ast.Or() if isinstance(op, ast.And) else ast.And()
            yield f"{type(op).__name__} → {type(other).__name__}", _with(node, op=other)
        case ast.UnaryOp(op=ast.Not() | ast.USub(), operand=operand):
            yield "sign or not dropped", operand
        case ast.Constant(value=bool() as value):
            yield f"{value} → {not value}", _with(node, value=not value)
        case ast.Constant(value=int() | float() as value):
            yield f"{value} → {value + 1}", _with(node, value=value + 1)
        case ast.If(test=test):
            yield "condition negated", _with(node, test=ast.UnaryOp(ast.Not(), test))
        case ast.IfExp(test=test):
            yield "condition negated", _with(node, test=ast.UnaryOp(ast.Not(), test))
        case ast.Return(value=value) if value is not None and not isinstance(value, ast.Constant):
            yield "returns None", _with(node, value=ast.Constant(None))
        case ast.Expr(value=ast.Call()) | ast.AugAssign():
            yield "statement removed", ast.Pass()
        case _:
            return


def _place(node: ast.AST) -> tuple[int, int]:
    assert isinstance(node, ast.expr | ast.stmt)
    return node.lineno, node.col_offset


def _with(node: ast.AST, **fields: object) -> ast.AST:
    changed = copy.copy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def _written(lines: list[str], node: ast.AST, changed: ast.AST) -> str | None:
    """The module with this node's text replaced; None where what comes out is no Python."""
    part = node.test if isinstance(node, ast.If) else node  # of an `if`, only its condition
    new = changed.test if isinstance(changed, ast.If) else changed
    assert isinstance(part, ast.expr | ast.stmt)
    first, last = part.lineno - 1, (part.end_lineno or part.lineno) - 1
    text = ast.unparse(ast.fix_missing_locations(new)) + "\n" * (
        last - first
    )  # the lines below keep their numbers
    if isinstance(part, ast.expr):
        text = f"({text})"
    begin = lines[first].encode()[: part.col_offset].decode()
    end = lines[last].encode()[part.end_col_offset :].decode()
    whole = "".join([*lines[:first], begin + text + end, *lines[last + 1 :]])
    try:
        ast.parse(whole)
    except SyntaxError:
        return None
    return whole


def every() -> list[Mutant]:
    return [
        each
        for room in ROOMS
        for path in sorted((TOP / "src/corollary" / room).rglob("*.py"))
        for each in mutants(path)
    ]


def drawn(count: int) -> list[Mutant]:
    """`count` mutants, the same ones for the same sources."""
    found = every()
    random.Random(SEED).shuffle(found)
    return list(islice((each for each in found if each.text() is not None), count))


def found_again(alive: list[Record]) -> list[Mutant | None]:
    """The same changes in today's sources; None where the line is no longer there."""
    today = every()
    return [
        min(
            (
                each
                for each in today
                if all(record[name] == getattr(each, name) for name in ("file", "what", "source"))
            ),
            key=lambda each: (abs(each.line - record["line"]), abs(each.column - record["column"])),  # type: ignore[operator]
            default=None,
        )
        for record in alive
    ]
