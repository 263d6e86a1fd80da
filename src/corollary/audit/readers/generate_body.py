"""The statements of `generate(data)` one by one: what each sets, with what was put into `params` in place of looking it up there."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass, field
from typing import Literal

from corollary.audit.readers.python_names import DRAWN, PythonNames
from corollary.audit.readers.straight_line import MOST_NODES, NotRead

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
                    raise NotRead(f"line {statement.lineno} of server.py is no assignment")

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
                raise NotRead(f"line {target.lineno} of server.py is no assignment")

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
                            raise NotRead(f"params[{name!r}] is a text, which is no number in Python")
                        return deepcopy(body.params[name])
                    case _:
                        return node

        found: ast.expr = LookUp().visit(deepcopy(value))
        if sum(1 for _ in ast.walk(found)) > MOST_NODES:
            raise NotRead(f"line {value.lineno} of server.py is too long an expression with params put in")
        return found


def _letters(value: ast.expr) -> set[str]:
    return {node.id for node in ast.walk(value) if isinstance(node, ast.Name)}
