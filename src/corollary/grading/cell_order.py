"""Cells that stand in another order than they were run in: which may be run a second time, and whether what they give is certain."""

from __future__ import annotations

import ast
import builtins
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

MUTATING = frozenset(
    [
        "append",
        "extend",
        "insert",
        "update",
        "pop",
        "popitem",
        "remove",
        "discard",
        "add",
        "sort",
        "reverse",
        "clear",
        "setdefault",
        "shuffle",
        "write",
        "send",
    ]
)
IMPORTING = frozenset(["import_module", "__import__", "find_spec"])
_BUILT_IN = frozenset(dir(builtins))
_FIRST_MAGIC = re.compile(r"\s*%%(?:time|timeit|capture)\b[^\n]*\n")
_MAGIC = re.compile(r"^[ \t]*[%!][^\n]*$", re.MULTILINE)
_ASSIGNED = re.compile(r"^[ \t]*([A-Za-z_]\w*)[ \t]*=(?!=)", re.MULTILINE)


class CellNames:
    """The names of one cell: those that it `makes`, each with how; those that it reads before it makes them; `star`: it may make any;
    `repeatable`: run twice in the same surroundings, it does the same as run once; `imports`: the packages that it imports anywhere,
    each with the names that are made with it."""

    def __init__(self, makes: Iterable[str] = (), *, repeatable: bool = True) -> None:
        self.makes: dict[str, tuple[str, ...]] = dict.fromkeys(makes, ("?",))
        self.reads = set[str]()
        self.star = False
        self.repeatable = repeatable
        self.of_functions: dict[str, set[str]] = {}
        self.imports: dict[str, set[str]] = {}


def cell_names(source: str) -> CellNames:
    """Return the names of a cell; where Python cannot read it, those that its lines assign."""
    try:
        tree = ast.parse(_MAGIC.sub("", _FIRST_MAGIC.sub("", source, count=1)))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return CellNames(_ASSIGNED.findall(source), repeatable=False)
    found = CellNames()
    for statement in tree.body:
        _follow(statement, found)
        loaded = {each.id for each in ast.walk(statement) if isinstance(each, ast.Name)}
        here = _packages_in(statement)
        for package in here | {each for each, names in found.imports.items() if names & loaded}:
            found.imports.setdefault(package, set()).update(_made_by(statement))
    if found.reads & found.makes.keys():  # `n = n + 1`
        found.repeatable = False
    found.reads -= _BUILT_IN
    return found


def _packages_in(node: ast.AST) -> set[str]:
    """The packages imported anywhere below, by a statement or by `import_module("…")`."""
    found = set[str]()
    for each in ast.walk(node):
        match each:
            case ast.Import(names=names):
                found |= {one.name for one in names}
            case ast.ImportFrom(module=str(name), level=0):
                found.add(name)
            case ast.Call(
                func=ast.Name(id=called) | ast.Attribute(attr=called),
                args=[ast.Constant(value=str(name)), *_],
            ) if called in IMPORTING:
                found.add(name)
            case _:
                continue
    return {name.partition(".")[0] for name in found}


def _made_by(statement: ast.stmt) -> Iterator[str]:
    for each in ast.walk(statement):
        match each:
            case ast.Name(id=name, ctx=ast.Store()) | ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.alias(name=name, asname=other):
                yield other or name.partition(".")[0]
            case _:
                continue


def _follow(node: ast.stmt, found: CellNames) -> None:
    """Add what a statement reads and makes, in the order in which Python does both."""
    match node:
        case ast.Import(names=names) | ast.ImportFrom(names=names):
            for each in names:
                if each.name == "*":
                    found.star = True
                else:
                    _make(found, each.asname or each.name.partition(".")[0], node)
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.AsyncFunctionDef(name=name):
            for each in (*node.decorator_list, *_defaults(node)):
                _expression(each, found)
            inner = _read_inside(node)
            found.of_functions[name] = inner - _BUILT_IN
            if any(isinstance(each, ast.Global | ast.Nonlocal) for each in ast.walk(node)):
                found.repeatable = False
            _make(found, name, node)
        case ast.Global() | ast.Delete():
            found.repeatable = False
        case ast.For(target=target, iter=header) | ast.AsyncFor(target=target, iter=header):
            _expression(header, found)
            _targets(target, found, node)
            _bodies(node, found)
        case ast.While(test=header) | ast.If(test=header):
            _expression(header, found)
            _bodies(node, found)
        case ast.With(items=items) | ast.AsyncWith(items=items):
            for each in items:
                _expression(each.context_expr, found)
                if each.optional_vars is not None:
                    _targets(each.optional_vars, found, node)
            _bodies(node, found)
        case ast.Assign(targets=targets, value=value):
            _expression(value, found)
            for target in targets:
                _targets(target, found, node)
        case ast.AugAssign(target=target, value=value):
            _expression(value, found)
            if isinstance(target, ast.Name) and target.id in found.makes:
                return
            found.repeatable = found.repeatable and isinstance(target, ast.Name)
            if isinstance(target, ast.Name):
                found.reads.add(target.id)
            _targets(target, found, node)
        case ast.AnnAssign(target=target, value=value):
            if value is not None:
                _expression(value, found)
                _targets(target, found, node)
        case ast.Try() | ast.Match():
            found.repeatable = False
            for each in ast.walk(node):
                if isinstance(each, ast.Name):
                    _make(found, each.id, node) if isinstance(each.ctx, ast.Store) else _read(found, each.id)
        case _:
            _expression(node, found)


def _bodies(
    node: ast.For | ast.AsyncFor | ast.While | ast.If | ast.With | ast.AsyncWith, found: CellNames
) -> None:
    for statement in (*node.body, *getattr(node, "orelse", ())):
        _follow(statement, found)


def _defaults(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) -> Iterator[ast.expr]:
    if isinstance(node, ast.ClassDef):
        yield from node.bases
    else:
        yield from (*node.args.defaults, *filter(None, node.args.kw_defaults))


def _read_inside(node: ast.AST) -> set[str]:
    """The names that a function or a comprehension takes from outside."""
    loads = {
        each.id for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load)
    }
    own = {
        each.id for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    }
    return loads - own - {each.arg for each in ast.walk(node) if isinstance(each, ast.arg)}


def _expression(node: ast.AST, found: CellNames) -> None:
    inner = {
        each.id
        for part in ast.walk(node)
        if isinstance(part, ast.comprehension)
        for each in ast.walk(part.target)
        if isinstance(each, ast.Name)
    } | {each.arg for each in ast.walk(node) if isinstance(each, ast.arg)}
    for each in ast.walk(node):
        match each:
            case ast.Name(id=name, ctx=ast.Load()) if name not in inner:
                _read(found, name)
            case ast.NamedExpr(target=ast.Name(id=name)):
                _make(found, name, node)
            case ast.Call(func=ast.Attribute(attr=attribute, value=value)) if attribute in MUTATING:
                found.repeatable = found.repeatable and _root(value) in found.makes
            case ast.Call(func=ast.Name(id="next" | "exec" | "eval" | "setattr")):
                found.repeatable = False
            case _:
                continue


def _targets(target: ast.expr, found: CellNames, by: ast.stmt) -> None:
    for each in ast.walk(target):
        match each:
            case ast.Name(id=name, ctx=ast.Store()):
                _make(found, name, by)
            case ast.Subscript(value=value, ctx=ast.Store()) | ast.Attribute(value=value, ctx=ast.Store()):
                found.repeatable = found.repeatable and _root(value) in found.makes
            case ast.Name(id=name, ctx=ast.Load()):
                _read(found, name)
            case _:
                continue


def _root(node: ast.expr) -> str:
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def _read(found: CellNames, name: str) -> None:
    if name not in found.makes:
        found.reads.add(name)


def _make(found: CellNames, name: str, by: ast.AST) -> None:
    """How a name is made: the statement's text, and for one in a loop the loop's."""
    found.makes[name] = (*found.makes.get(name, ()), ast.unparse(by))


@dataclass(frozen=True, slots=True)
class CellOrder:
    """The names of all cells of a notebook, in their order."""

    cells: Sequence[CellNames]

    def may_run_again(self, index: int) -> bool:
        """True if a cell that stopped at a missing name may be run from its start a second time."""
        return self.cells[index].repeatable and all(
            not (each.of_functions and not each.repeatable) for each in self.cells
        )

    def is_certain(self, index: int) -> bool:
        """True if the cell gives the same in any order of the cells in which it works: what it reads is made in one way only."""
        waiting, met = set(self.cells[index].reads), set[str]()
        for name in self.cells[index].makes:
            waiting |= self.cells[index].of_functions.get(name, set())
        waiting -= self.cells[index].makes.keys()
        while waiting:
            met.add(name := waiting.pop())
            makers = [each for at, each in enumerate(self.cells) if at != index and name in each.makes]
            if len({each.makes[name] for each in makers}) > 1 or (
                len(makers) > 1 and not all(each.repeatable for each in makers)
            ):
                return False
            for each in makers:
                waiting |= each.of_functions.get(name, set()) - met - each.makes.keys()
        return True

    def made_below(self, index: int, name: str) -> bool:
        """True if a cell below makes this name."""
        return any(name in each.makes for each in self.cells[index + 1 :])


def cell_order(sources: Sequence[str]) -> CellOrder:
    """Return the order of cells with these texts."""
    return CellOrder([cell_names(source) for source in sources])
