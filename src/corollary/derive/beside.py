"""Python files beside a solution, imported by their names or loaded at the first call of a function, and comparisons by == refused."""

from __future__ import annotations

import ast
import importlib
import re
import sys
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from functools import lru_cache
from importlib.machinery import FileFinder, SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from itertools import dropwhile
from numbers import Number
from pathlib import Path
from types import ModuleType
from typing import Any

from corollary.messages import did_you_mean

EQUAL, UNEQUAL = "__corollary_equal__", "__corollary_unequal__"


def equal(left: Any, right: Any) -> Any:
    """`left == right`. Raises TypeError between formulas."""
    _refuse(left, right, "==", "Eq")
    return left == right


def unequal(left: Any, right: Any) -> Any:
    """`left != right`. Raises TypeError between formulas."""
    _refuse(left, right, "!=", "Ne")
    return left != right


NAMES = {EQUAL: equal, UNEQUAL: unequal}
"""What the compiled code calls, to be put into its module."""


@lru_cache(maxsize=256)  # a scene function is loaded for each key that it is held against
def compiled(source: bytes | str, path: str) -> Any:
    """The code of a solution, each == and != in it as a call. Raises SyntaxError, which names the file, or ValueError for what is
    no Python."""
    try:
        tree = ast.parse(source, path)
    except SyntaxError as error:
        error.filename = error.filename or path
        raise
    tree = ast.fix_missing_locations(_Comparisons().visit(tree))
    return compile(tree, path, "exec", dont_inherit=True)


class _Comparisons(ast.NodeTransformer):
    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        self.generic_visit(node)
        if not any(isinstance(sign, ast.Eq | ast.NotEq) for sign in node.ops):
            return node
        operands = [node.left, *node.comparators]
        pairs = [
            self._pair(node, sign, *operands[place : place + 2]) for place, sign in enumerate(node.ops)
        ]  # of a chain, the middle is worked out twice
        return pairs[0] if len(pairs) == 1 else ast.copy_location(ast.BoolOp(ast.And(), pairs), node)

    def _pair(self, node: ast.Compare, sign: ast.cmpop, left: ast.expr, right: ast.expr) -> ast.expr:
        if isinstance(sign, ast.Eq | ast.NotEq):
            name = ast.copy_location(
                ast.Name(EQUAL if isinstance(sign, ast.Eq) else UNEQUAL, ast.Load()), node
            )
            return ast.copy_location(ast.Call(name, [left, right], []), node)
        return ast.copy_location(ast.Compare(left, [sign], [right]), node)


def _refuse(left: Any, right: Any, sign: str, word: str) -> None:
    sympy = sys.modules.get("sympy")
    if sympy is None:  # without it there is no formula
        return
    formulas = [each for each in (left, right) if isinstance(each, sympy.Expr)]
    others = [each for each in (left, right) if not isinstance(each, sympy.Expr)]
    if any(each.free_symbols for each in formulas) and all(isinstance(each, Number) for each in others):
        raise TypeError(
            f"{left} {sign} {right} compares how two formulas are written, not what they are; "
            f"write {word}({left}, {right}), with {word} from sympy"
        )


LOADED = "corollary_beside_"  # begins the name of a module that is loaded late, which no installed one has
LONGEST = 200  # letters of a file's name
BACKTICKS = re.compile(r"`([\w./-]{1,200})`")


class _Loader(SourceFileLoader):
    """Of a module beside a solution: read as the solution is."""

    def source_to_code(self, data: Any, path: Any, *, _optimize: int = -1) -> Any:
        return compiled(bytes(data), str(path))

    def exec_module(self, module: ModuleType) -> None:
        vars(module).update(NAMES)
        super().exec_module(module)


@contextmanager
def importable(*folders: Path) -> Generator[None]:
    """Inside, what lies in these folders can be imported, the first one's before the others' and before anything else of that name.

    Afterwards such modules are forgotten: another bank may have one of the same name, and its author may change it.
    """
    with ExitStack() as stack:
        for folder in reversed(folders):
            stack.enter_context(_importable(folder))
        yield


@contextmanager
def _importable(folder: Path) -> Generator[None]:
    own = {path.stem for path in folder.glob("*.py")} - sys.stdlib_module_names
    hidden = {
        name: sys.modules.pop(name) for name in own & sys.modules.keys()
    }  # somebody else's of that name
    writes, before = sys.dont_write_bytecode, set(sys.modules)

    def finder(path: str) -> FileFinder:
        if Path(path) != folder:
            raise ImportError(path)
        return FileFinder(path, (_Loader, [".py"]))

    sys.path_hooks.insert(0, finder)
    sys.path_importer_cache.pop(str(folder), None)
    sys.path.insert(0, str(folder))
    sys.dont_write_bytecode = True  # a bank is not written to; and a compiled copy can be older than it looks
    importlib.invalidate_caches()
    try:
        yield
    finally:
        sys.dont_write_bytecode = writes
        sys.path.remove(str(folder))
        sys.path_hooks.remove(finder)
        sys.path_importer_cache.pop(str(folder), None)
        for name in sys.modules.keys() - before:  # those before belong to whoever loaded them
            if _lies_in(folder, sys.modules[name]):
                del sys.modules[name]
        sys.modules.update(hidden)


def _lies_in(folder: Path, module: ModuleType) -> bool:
    file = getattr(module, "__file__", None) or ""
    return file.startswith(str(folder)) and Path(file).parent == folder  # a Path of each takes long


@lru_cache(maxsize=256)
def _functions_in(source: bytes, path: str) -> frozenset[str]:
    """The names of functions that a program defines. Raises SyntaxError."""
    return frozenset(node.name for node in ast.parse(source, path).body if isinstance(node, ast.FunctionDef))


class LazyModule:
    """A Python file whose functions load it when one of them is first called; anything else in it is loaded when asked for.

    It imports what lies in its own folder, and what lies beside the solution.
    """

    def __init__(self, path: Path, beside: Path) -> None:
        """Raises FileNotFoundError, and SyntaxError where it is not Python."""
        if not path.is_file():
            raise FileNotFoundError(f"there is no file {path.name} in {path.parent}")
        self._path, self._folders = path, tuple(dict.fromkeys((path.parent, beside)))
        self._functions = _functions_in(path.read_bytes(), str(path))
        self._module: ModuleType | None = None

    def __getattr__(self, name: str) -> Any:
        """A function, not loaded yet. Raises AttributeError for a name that is not there."""
        if name.startswith("__"):
            raise AttributeError(name)
        if name in self._functions:
            return self._called_later(name)
        with importable(*self._folders):
            known = vars(self._loaded())
        if name not in known:
            raise AttributeError(f"{self._path.name} has no {name}{did_you_mean(name, self._functions)}")
        return known[name]

    def _called_later(self, name: str) -> Callable[..., Any]:
        def call(*given: Any, **named: Any) -> Any:
            with importable(*self._folders):  # a function may import, too
                return getattr(self._loaded(), name)(*given, **named)

        call.__name__ = call.__qualname__ = name
        return call

    def _loaded(self) -> ModuleType:
        if self._module is None:
            name = f"{LOADED}{self._path.stem}"
            spec = spec_from_loader(name, _Loader(name, str(self._path)))
            assert spec is not None
            assert spec.loader is not None
            module = sys.modules[name] = module_from_spec(spec)  # forgotten again, as what it imports
            spec.loader.exec_module(module)
            self._module = module
        return self._module


def program_text(path: Path) -> str:
    """The text of a program in a file without the imports it opens with, which every notebook has made. Raises OSError."""
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    return "".join(dropwhile(lambda line: not line.strip() or line.startswith("import "), lines))


def files_beside(solution: Path, source: bytes, scenes: Sequence[Path] = ()) -> list[Path]:
    """The Python files that a solution imports from its folder or names in a text (`module("cart/judge_cart.py")`), the ready-made
    scenes in the folders `scenes` that it names (`simulate("cradle")`), and those that these do; none where it is not Python."""
    there = [{path.stem: path for path in folder.glob("*.py")} for folder in scenes]
    found: dict[Path, None] = {}
    todo = [(solution, source)]
    while todo:
        file, text = todo.pop()
        for name in _names(file, text):
            if name.endswith(".py"):
                places = [each / name for each in (file.parent, solution.parent)]
                path = next((each for each in places if each.is_file()), solution)
            else:
                path = next((each[name] for each in there if name in each), solution)
            if path not in found and path != solution:
                found[path] = None
                todo.append((path, path.read_bytes()))
    return sorted(found)


def _names(solution: Path, source: bytes) -> Iterator[str]:
    """Files that a program imports, if they are there, or names; and texts that may be a scene's name. Of a solution in text, the
    program of the same name, and what stands between backticks."""
    if solution.suffix == ".md":
        yield f"{solution.stem}.py"
        yield from BACKTICKS.findall(source.decode(errors="replace"))
        return
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        match node:
            case ast.Import(names):
                yield from (f"{alias.name.partition('.')[0]}.py" for alias in names)
            case ast.ImportFrom(module=str(module), level=0):
                yield f"{module.partition('.')[0]}.py"
            case ast.Constant(value=str(text)) if len(text) <= LONGEST and text.isprintable():
                yield text
            case _:
                pass
