"""The modules that a notebook carries: all that reading needs, and none that a student's computer lacks."""

from __future__ import annotations

import ast
import subprocess
import sys
from base64 import b64decode
from pathlib import Path

import pytest

from corollary.answers.registry import BUILT_IN
from corollary.messages import language
from corollary.notebook import packing
from corollary.notebook.packing import NotCarried, catalogues, modules


@pytest.mark.whole
@pytest.mark.parametrize("name", BUILT_IN)
def test_every_answer_type_is_read_with_python_alone(name: str):
    carried = modules((name,))
    assert f"corollary.answers.{name}.reading" in carried
    assert not {each for each in carried if each.startswith(("corollary.problem", "corollary.grading"))}
    for text in carried.values():
        for node in ast.parse(text).body:
            roots = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            roots += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert {root.partition(".")[0] for root in roots} <= sys.stdlib_module_names | {"corollary"}


def test_the_modules_themselves_load_where_nothing_is_installed(tmp_path: Path):
    for name, text in modules(BUILT_IN).items():
        path = tmp_path.joinpath(*name.split("."))
        package = any(other.startswith(name + ".") for other in modules(BUILT_IN))
        path = path / "__init__.py" if package else path.with_suffix(".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    names = [f"corollary.answers.{name}.reading" for name in BUILT_IN]
    program = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import {', '.join(names)}; print('loaded')"
    done = subprocess.run(
        [sys.executable, "-S", "-I", "-c", program], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stdout == "loaded\n", done.stderr


@pytest.fixture
def plugin(installed):
    """A package of somebody else's with an answer type `ratio`, whose reading.py begins so."""

    def put(first_line: str) -> None:
        files = {
            "their_package/__init__.py": '"""Theirs."""\nimport numpy\n',
            "their_package/ratio/__init__.py": "",
            "their_package/ratio/bounds.py": "LOW = 0\n",
            "their_package/ratio/reading.py": first_line + "\nTYPE = None\n",
        }
        installed("theirs", {"corollary.answers": ["ratio = their_package.ratio"]}, files)

    packing.modules.cache_clear()
    yield put
    packing.modules.cache_clear()


def test_reading_that_needs_more_than_python_is_refused_in_one_sentence(plugin):
    plugin("import numpy as np")
    with pytest.raises(NotCarried) as raised:
        modules(("ratio",))
    assert str(raised.value) == (
        "the answer type ratio of their_package cannot be read in a notebook: their_package.ratio.reading imports "
        "numpy, which a student's computer may not have; what reading.py imports must be in Python's standard library"
    )


def test_reading_of_others_is_carried_with_what_it_imports(plugin):
    plugin("from .bounds import LOW\nfrom corollary.answers.answer_type import AnswerType")
    carried = modules(("ratio",))
    assert carried["their_package.ratio.bounds"] == "LOW = 0\n"
    assert carried["their_package"] == "'Theirs.'\n"


def test_catalogues_go_with_the_modules_of_their_rooms(plugin, translated):
    plugin("from .bounds import LOW")
    translated("their_package", {"too low": "tro malalta"})
    assert not catalogues(modules(("ratio",)))
    with language("eo"):
        carried = catalogues(modules(("ratio",)))
    assert b"tro malalta" in b64decode(carried["their_package"])
    assert carried["corollary.answers"] == ""
