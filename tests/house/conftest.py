"""The package read as text: its modules, and what each imports."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import pytest

import corollary

Node = TypeVar("Node", bound=ast.AST)
HOME = Path(corollary.__file__).parent


@dataclass(frozen=True, slots=True)
class Module:
    """`name` is without "corollary": `derive.load`; a package goes by its folder. `imports` are full names, with their lines.

    `for_types` are the lines of imports that only annotations need.
    """

    name: str
    path: Path
    tree: ast.Module
    imports: tuple[tuple[str, int], ...]
    for_types: frozenset[int]

    @property
    def folder(self) -> str:
        return self.name.partition(".")[0]

    @property
    def lines(self) -> int:
        return len(self.path.read_text(encoding="utf-8").splitlines())

    def of_ours(self) -> list[tuple[str, int]]:
        """What it imports of the package, without "corollary"."""
        return [
            (name.removeprefix("corollary."), line)
            for name, line in self.imports
            if name.startswith("corollary.")
        ]

    def of_others(self) -> list[tuple[str, int]]:
        """What it imports from elsewhere, when it runs."""
        return [
            (name, line)
            for name, line in self.imports
            if name.partition(".")[0] != "corollary" and line not in self.for_types
        ]

    def nodes(self, kind: type[Node]) -> list[Node]:
        return [node for node in ast.walk(self.tree) if isinstance(node, kind)]


@pytest.fixture(scope="session")
def modules() -> list[Module]:
    """Every module of the package, its own `__init__` left out."""
    paths = [path for path in sorted(HOME.rglob("*.py")) if path != HOME / "__init__.py"]
    known = {_name(path) for path in paths}
    return [_read(path, known) for path in paths]


def _name(path: Path) -> str:
    parts = path.relative_to(HOME).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _read(path: Path, known: set[str]) -> Module:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    found: list[tuple[str, int]] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found += [(alias.name, node.lineno) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            module = _absolute(path, node) if node.level else node.module or ""
            for alias in node.names:  # `from corollary.laws import law` may name a module or what is in one
                inside = f"{module}.{alias.name}"
                found.append((inside if inside.removeprefix("corollary.") in known else module, node.lineno))
    guarded = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    ]
    for_types = frozenset(each.lineno for node in guarded for each in node.body)
    return Module(_name(path), path, tree, tuple(dict.fromkeys(found)), for_types)


def _absolute(path: Path, node: ast.ImportFrom) -> str:
    """`from .clock import Clock`, written out."""
    place = path
    for _ in range(node.level):
        place = place.parent
    return ".".join(filter(None, ["corollary", *place.relative_to(HOME).parts, node.module]))
