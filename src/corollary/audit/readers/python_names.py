"""Meaning of names in a Python file: imports, constants, functions of one expression; nothing is imported or run."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field

from corollary.audit.readers.straight_line import MOST_NODES, NotRead

OF_FORMULAS = {
    "sin": "sin", "cos": "cos", "tan": "tan", "asin": "asin", "acos": "acos", "atan": "atan", "atan2": "atan2",
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2", "sqrt": "sqrt", "exp": "exp", "log": "log",
    "log10": "log10", "log2": "log2", "pow": "pow", "power": "pow", "fabs": "abs", "abs": "abs", "radians": "radians",
    "deg2rad": "radians", "degrees": "degrees", "rad2deg": "degrees",
}  # fmt: skip
DRAWN = {"randint", "uniform", "randrange", "choice"}
OF_MODULES = {
    **{f"{module}.{name}": same for module in ("math", "numpy") for name, same in OF_FORMULAS.items()},
    **{f"{module}.{name}": name for module in ("random", "numpy.random") for name in DRAWN},
    **{f"numpy.{name}": "round" for name in ("round", "around", "round_")},
}
"""Functions of Python's modules by their names in formulas, and how they draw."""

PI = {"math.pi", "numpy.pi"}
MODULES = {"math", "numpy", "numpy.random", "random"}
OTHER = "other:"  # before the name of a module that is not known here
BUILT_IN = {"abs", "pow", "float", "round", "str", "int"}
ROUNDS = {"round", "float", "str"}
RUN_BEHIND = {"prepare"}  # by PrairieLearn, behind `generate`
DEEPEST = 20  # calls of helpers within helpers
MOST_PUT_IN = (
    10 * MOST_NODES
)  # nodes of helpers written out: each of two calls of one that calls another twice is four


@dataclass(slots=True)
class PythonNames:
    """`imported` says what each name stands for, as `numpy.random.uniform`; `constants` are numbers that stand before the functions;
    `helpers` are functions of one expression, their parameters and it."""

    imported: dict[str, str] = field(default_factory=dict[str, str])
    constants: dict[str, ast.expr] = field(default_factory=dict[str, ast.expr])
    helpers: dict[str, tuple[tuple[str, ...], ast.expr]] = field(
        default_factory=dict[str, tuple[tuple[str, ...], ast.expr]]
    )

    def meaning(self, node: ast.expr) -> str:
        """`np.random.uniform` as `numpy.random.uniform`; "" for what is neither imported nor built in."""
        match node:
            case ast.Name(name):
                return self.imported.get(name, name if name in BUILT_IN else "")
            case ast.Attribute(inner, name):
                owner = self.meaning(inner)
                return f"{owner}.{name}" if owner else ""
            case _:
                return ""

    def function(self, value: ast.expr) -> str:
        """What an expression calls, by its name in formulas, or what it draws by; "" for anything else."""
        if not isinstance(value, ast.Call):
            return ""
        name = self.meaning(value.func)
        return OF_MODULES.get(name, name if name in BUILT_IN else "")

    def refuse_hidden(self, name: str) -> None:
        """Raises NotRead for a letter that hides what the whole file means by a name."""
        if name in self.imported or name in self.helpers or name in BUILT_IN:
            raise NotRead(f"server.py uses {name} for a letter and for something else")

    def in_formula_names(self, value: ast.expr) -> ast.expr:
        """The expression with functions by their names in formulas, and with helpers written out. Raises NotRead."""
        return _InFormulaNames(self).visit(deepcopy(value))

    def unrounded(self, value: ast.expr) -> ast.expr:
        """What is rounded for the page, before it is: the formula is compared, not its figures. Raises NotRead."""
        match value:
            case ast.Call(_, [inside], []) if (
                self.function(value) == "round" and self.function(inside) not in DRAWN
            ):
                raise NotRead(f"line {value.lineno} of server.py rounds to a whole number")
            case ast.Call(_, [inside, *places]) if self.function(value) in ROUNDS:
                if any(isinstance(each, ast.UnaryOp) for each in (*places, *_values(value))):
                    raise NotRead(f"line {value.lineno} of server.py rounds before the decimal point")
                return self.unrounded(inside)
            case ast.JoinedStr([ast.FormattedValue(inside)]):
                return self.unrounded(inside)
            case _:
                return value


class _InFormulaNames(ast.NodeTransformer):
    def __init__(self, names: PythonNames, depth: int = 0) -> None:
        self.names, self.depth, self.put_in = names, depth, 0

    def visit_Call(self, node: ast.Call) -> ast.expr:
        where = f"line {node.lineno} of server.py"
        if node.keywords or self.depth > DEEPEST:
            raise NotRead(f"{where} calls {ast.unparse(node.func)} in a way that is not read")
        match node.func:
            case ast.Name(name) if name in self.names.helpers:
                parameters, body = self.names.helpers[name]
                if len(parameters) != len(node.args):
                    raise NotRead(f"{where} calls {name} in a way that is not read")
                put_in = _PutIn(self.names, dict(zip(parameters, node.args, strict=True)))
                written: ast.expr = put_in.visit(deepcopy(body))
                self.put_in += sum(1 for _ in ast.walk(written))
                if self.put_in > MOST_PUT_IN:
                    raise NotRead(f"{where} is too long an expression with {name} written out")
                self.depth += 1
                found: ast.expr = self.visit(written)
                self.depth -= 1
                return found
            case _ if function := self.names.function(node):
                inside = [self.visit(each) for each in node.args]
                return ast.copy_location(ast.Call(ast.Name(function, ast.Load()), inside, []), node)
            case _:
                raise NotRead(f"{where} calls {ast.unparse(node.func)}, which is not read")

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        if self.names.meaning(node) in PI:
            return ast.copy_location(ast.Name("pi", ast.Load()), node)
        raise NotRead(f"line {node.lineno} of server.py has {ast.unparse(node)}, which is not read")

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if self.names.meaning(node) in PI:
            return ast.copy_location(ast.Name("pi", ast.Load()), node)
        if self.names.meaning(node) or node.id == "pi":
            raise NotRead(f"line {node.lineno} of server.py has {node.id}, which is not read")
        return node


class _PutIn(ast.NodeTransformer):
    """A helper's expression with the arguments of a call in place of its parameters."""

    def __init__(self, names: PythonNames, arguments: Mapping[str, ast.expr]) -> None:
        self.names, self.meant = names, {**names.constants, **arguments}

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id in self.meant:
            return deepcopy(self.meant[node.id])
        if self.names.meaning(node) or node.id in self.names.helpers:
            return node
        raise NotRead(f"line {node.lineno} of server.py has {node.id}, which is not read")


def names_of(tree: ast.Module) -> tuple[PythonNames, ast.FunctionDef]:
    """What a `server.py` means by its names, and its `generate`. Raises NotRead for what could change either."""
    found, generate = PythonNames(), list[ast.FunctionDef]()
    bound = set[str]()
    for statement in tree.body:
        where = f"line {statement.lineno} of server.py"
        named = dict[str, str]()
        match statement:
            case ast.Import(aliases):
                named = {each.asname or each.name.partition(".")[0]: each.name for each in aliases}
                named = {name: full if full in MODULES else f"{OTHER}{full}" for name, full in named.items()}
                found.imported |= named
            case ast.ImportFrom(module, [ast.alias("*")]) if module in MODULES:
                named = {
                    full.rpartition(".")[2]: full for full in OF_MODULES if full.rpartition(".")[0] == module
                }
                named |= {"pi": f"{module}.pi"} if f"{module}.pi" in PI else {}
                found.imported |= named
            case ast.ImportFrom(module, aliases):
                named = {
                    each.asname or each.name: f"{module}.{each.name}"
                    if module in MODULES
                    else f"{OTHER}{module}.{each.name}"
                    for each in aliases
                }
                found.imported |= named
            case ast.FunctionDef(name) if statement.decorator_list or name in RUN_BEHIND:
                raise NotRead(f"{where} begins {name}, which may change what generate has set")
            case ast.FunctionDef("generate"):
                generate.append(statement)
                named = {"generate": ""}
            case ast.FunctionDef(name):
                named = {name: ""}
                if (helper := _helper(statement)) is not None:
                    found.helpers[name] = helper
            case ast.Assign([ast.Name(name)], value):
                named = {name: ""}
                if isinstance(value, ast.Constant):
                    found.constants[name] = value
            case ast.Expr(ast.Constant()):
                continue
            case _:
                raise NotRead(f"{where} is neither an import, nor a number, nor a function")
        if twice := bound & named.keys() or (named.keys() & BUILT_IN):
            raise NotRead(f"{where} gives {min(twice)} another meaning")
        bound |= named.keys()
    if len(generate) != 1:
        raise NotRead("server.py has no function generate(data)")
    return found, generate[0]


def _helper(function: ast.FunctionDef) -> tuple[tuple[str, ...], ast.expr] | None:
    """The parameters and the expression of a function that returns one."""
    given = function.args
    body = [each for each in function.body if not isinstance(each, ast.Expr)]
    match body:
        case [ast.Return(ast.expr() as value)] if not (
            given.defaults or given.vararg or given.kwarg or given.kwonlyargs or given.posonlyargs
        ):
            return tuple(each.arg for each in given.args), value
        case _:
            return None


def _values(call: ast.Call) -> list[ast.expr]:
    return [each.value for each in call.keywords]
