"""The package read as text: its modules, and what each imports."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path

import corollary

HOME = Path(corollary.__file__).parent
FLOORS = {
    "cli": 6, "deliver": 5, "mark": 4, "sheet": 3, "submission": 3, "derive": 2, "kind": 2, "figure": 2,
    "law": 1, "scene": 1, "problem": 1, "quantity": 0,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Module:
    """`name` is without "corollary": `derive.load`; a package goes by its folder. `imports` are full names, with their lines."""

    name: str
    path: Path
    tree: ast.Module
    imports: tuple[tuple[str, int], ...]

    @property
    def folder(self) -> str:
        return self.name.partition(".")[0]

    def of_ours(self) -> list[tuple[str, int]]:
        """What it imports of the package, without "corollary"."""
        return [(name.removeprefix("corollary."), line) for name, line in self.imports if name.startswith("corollary.")]

    def of_others(self) -> list[tuple[str, int]]:
        """The top names of what it imports from elsewhere."""
        return [(name.partition(".")[0], line) for name, line in self.imports if name.partition(".")[0] != "corollary"]


def modules() -> list[Module]:
    """Every module of the package."""
    paths = sorted(HOME.rglob("*.py"))
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
            assert node.level == 0, f"{path}:{node.lineno}: imports are written out from corollary"
            module = node.module or ""
            for alias in node.names:  # `from corollary.law import law` may name a module or what is in one
                inside = f"{module}.{alias.name}"
                found.append((inside if inside.removeprefix("corollary.") in known else module, node.lineno))
    return Module(_name(path), path, tree, tuple(dict.fromkeys(found)))
