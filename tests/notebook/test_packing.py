"""The modules that a notebook carries: all of them, in order, and none that a student's computer lacks."""

from __future__ import annotations

import ast
import sys

import pytest

from corollary.notebook.packing import readers


def test_every_reader_comes_after_those_it_imports():
    seen: set[str] = set()
    for name, source in readers("notebook/as_read", "notebook/as_formula", "sandbox/worker/encode"):
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("corollary_check."):
                assert node.module.removeprefix("corollary_check.") in seen
            assert not (isinstance(node, ast.ImportFrom) and (node.module or "").startswith("corollary."))
        seen.add(name)
    assert {"encode", "unit", "number", "read", "as_read", "syntax", "as_formula"} <= seen


def test_readers_need_only_python_itself():
    for _, source in readers("notebook/as_read", "sandbox/worker/encode"):
        for node in ast.parse(source).body:
            if isinstance(node, ast.Import):
                assert {alias.name.partition(".")[0] for alias in node.names} <= sys.stdlib_module_names


def test_a_module_that_needs_more_is_refused():
    with pytest.raises(ValueError, match=r"ball\.py imports flint, which a student's computer may not have"):
        readers("formula/ball")
