"""The modules that read a quantity also stand, as source, in every notebook: they need nothing but Python."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

import corollary.formula

FOLDER = Path(corollary.formula.__file__).parent
ALONE = (
    "trouble",
    "number",
    "unit_words",
    "unit",
    "wording",
    "tex",
    "function",
    "worked",
    "components",
    "read",
    "plain",
)


@pytest.mark.parametrize("name", ALONE)
def test_only_the_standard_library_and_one_another(name):
    tree = ast.parse((FOLDER / f"{name}.py").read_text(encoding="utf-8"))
    imported = {
        node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.level == 0
    }
    imported |= {
        alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names
    }
    assert not any(isinstance(node, ast.ImportFrom) and node.level for node in ast.walk(tree))
    others = {f"corollary.formula.{other}" for other in ALONE}
    assert all(
        module in others or module.partition(".")[0] in sys.stdlib_module_names
        for module in imported
        if module
    )


def test_sources_run_one_after_the_other_in_an_empty_namespace():
    lines = []
    for name in ALONE:
        source = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
        lines += [
            line
            for line in source.splitlines()
            if not line.startswith(("from corollary.", "from __future__"))
        ]
    space: dict[str, object] = {"__name__": __name__}
    exec(compile("from __future__ import annotations\n" + "\n".join(lines), "notebook", "exec"), space)
    reading = eval("describe(read_quantity('8,6 Ns', unit('kg m/s')))", space)
    assert reading == "read as 8.6 N s"
