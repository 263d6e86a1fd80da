"""Modules of an author's own that lie beside a solution: imported by their names, read anew each time, and part of its state."""

from __future__ import annotations

import ast
import importlib
import sys
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from importlib.machinery import FileFinder, SourceFileLoader
from pathlib import Path
from types import ModuleType
from typing import Any

from corollary.derive.comparison import NAMES, compiled


class _Loader(SourceFileLoader):
    """Of a module beside a solution: read as the solution is."""

    def source_to_code(self, data: Any, path: Any, *, _optimize: int = -1) -> Any:
        return compiled(bytes(data), str(path))

    def exec_module(self, module: ModuleType) -> None:
        vars(module).update(NAMES)
        super().exec_module(module)


@contextmanager
def importable(solution: Path) -> Generator[None]:
    """While a solution is loaded and derives: what lies in its folder can be imported, before anything else of that name.

    Afterwards such modules are forgotten: another bank may have one of the same name, and its author may change it.
    """
    folder, writes = solution.parent, sys.dont_write_bytecode
    before = _loaded_from(folder)

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
        for name in _loaded_from(folder) - before:  # those before belong to whoever loaded them
            del sys.modules[name]


def _loaded_from(folder: Path) -> set[str]:
    """The modules loaded that lie in a folder."""
    begin = str(folder)
    return {
        name
        for name, module in list(sys.modules.items())
        if (file := getattr(module, "__file__", None) or "").startswith(begin)  # a Path of each takes long
        and Path(file).parent == folder
    }


def modules_beside(solution: Path, source: bytes) -> list[Path]:
    """The modules in its folder that a solution imports, and those that these do, by name; none where it is not Python."""
    found: dict[str, Path] = {}
    todo = [source]
    while todo:
        for name in _imported(todo.pop()):
            path = solution.parent / f"{name}.py"
            if name not in found and path != solution and path.is_file():
                found[name] = path
                todo.append(path.read_bytes())
    return [found[name] for name in sorted(found)]


def _imported(source: bytes) -> Iterator[str]:
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        match node:
            case ast.Import(names):
                yield from (alias.name.partition(".")[0] for alias in names)
            case ast.ImportFrom(module=str(module), level=0):
                yield module.partition(".")[0]
            case _:
                pass
