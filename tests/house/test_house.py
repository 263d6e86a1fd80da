"""The house stands as it is drawn: floors, doors, names, and files of a size one can read."""

from __future__ import annotations

import ast
import re
import statistics
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from imports import FLOORS, HOME, Module, modules

MODULES = modules()
LONGEST, MEDIAN = 300, 150
FORBIDDEN = re.compile(r"manager|utils?\b|utils?_|helpers?\b|helpers?_|process(es|or|ors)?\b", re.IGNORECASE)


def test_every_folder_stands_on_a_floor():
    folders = {module.folder for module in MODULES} - {""}
    assert folders == FLOORS.keys()


def test_imports_go_down_and_siblings_do_not_know_each_other():
    wrong = [
        f"{module.path.name}:{line}: {module.name} (floor {FLOORS[module.folder]}) imports {name}"
        for module in MODULES if module.name
        for name, line in module.of_ours()
        if (other := name.partition(".")[0]) != module.folder and FLOORS[other] >= FLOORS[module.folder]
    ]  # fmt: skip
    assert not wrong


def test_what_is_handed_out_cannot_see_the_truth():
    for module in MODULES:
        if module.folder == "sheet":
            assert not [name for name, _ in module.of_ours() if name.startswith(("derive", "law", "mark"))], module.name


def test_no_circles():
    ours = {module.name: {name for name, _ in module.of_ours() if name != module.name} for module in MODULES}
    done: set[str] = set()

    def walk(name: str, way: tuple[str, ...]) -> None:
        assert name not in way, f"a circle: {' > '.join((*way[way.index(name):], name))}"
        if name not in done:
            for other in ours.get(name, ()):
                walk(other, (*way, name))
            done.add(name)

    for name in ours:
        walk(name, ())


@pytest.mark.parametrize(
    ("library", "rooms"),
    [
        ("sympy", ("law", "derive", "submission.child")),
        ("matplotlib", ("figure", "submission.child")),
        ("nbgrader", ("deliver.nbgrader",)),
        ("nbformat", ("sheet.notebook", "sheet.cells", "submission", "deliver.nbgrader")),
        ("IPython", ("submission.child",)),
        ("flint", ("quantity", "kind.equality")),
        ("yaml", ("problem.node",)),
        ("typer", ("cli",)),
    ],
)
def test_a_library_is_known_only_where_it_is_at_home(library, rooms):
    strangers = [
        f"{module.name}:{line}" for module in MODULES for name, line in module.of_others()
        if name == library and not module.name.startswith(rooms)
    ]  # fmt: skip
    assert not strangers


def test_one_door_to_the_solutions():
    """Only derive.load opens a solution; others may ask where it lies, to name it in a complaint."""
    opened = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)}"
        for module in MODULES if module.name != "derive.load"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Attribute) and re.match(r"read_|open$", node.attr) and ".solution(" in ast.unparse(node.value)
    ]  # fmt: skip
    assert not opened
    loads = {module.name for module in MODULES if any(name.startswith(("importlib.util", "runpy", "imp")) for name, _ in module.imports
                                                      if name in {"importlib.util", "runpy"})}  # fmt: skip
    assert loads <= {"derive.load"}
    named = {module.name for module in MODULES for node in ast.walk(module.tree) if isinstance(node, ast.Constant) and node.value == "solutions"}
    assert named <= {"problem.bank"}


def test_problems_hold_no_programs():
    from corollary.problem.bank import chapter_bank

    assert {path.suffix for path in chapter_bank().problems.rglob("*") if path.is_file()} <= {".md", ".svg"}


def test_files_are_short():
    lengths = {module.path: len(module.path.read_text(encoding="utf-8").splitlines()) for module in MODULES}
    assert not {str(path.relative_to(HOME)): length for path, length in lengths.items() if length > LONGEST}
    assert statistics.median(lengths.values()) <= MEDIAN


def test_every_module_opens_with_one_sentence():
    for module in MODULES:
        about = ast.get_docstring(module.tree)
        assert about, f"{module.name} says nothing of what it holds"
        assert about.splitlines()[0].rstrip().endswith((".", "!")) or len(about.splitlines()) > 1, f"{module.name}: {about}"


def test_names_come_from_the_classroom():
    wrong = [
        name for module in MODULES
        for name in (module.path.stem, *(node.name for node in ast.walk(module.tree) if isinstance(node, ast.ClassDef)))
        if FORBIDDEN.search(name)
    ]  # fmt: skip
    assert not wrong


def test_classes_have_no_parents_but_what_python_asks_for():
    """Exceptions, protocols, abstract classes and what a library wants to be inherited from; nothing of ours that is not abstract."""
    names = {node.name: node for module in MODULES for node in ast.walk(module.tree) if isinstance(node, ast.ClassDef)}
    for name, node in names.items():
        for base in node.bases:
            parent = names.get(ast.unparse(base))
            assert parent is None or _abstract(parent), f"{name} inherits from {ast.unparse(base)}, which is not abstract"


def test_nothing_is_asked_by_name():
    for module in MODULES:
        for node in ast.walk(module.tree):
            assert not (isinstance(node, ast.Call) and ast.unparse(node.func) == "hasattr"), f"{module.name}:{node.lineno}: hasattr"
            swallowed = isinstance(node, ast.ExceptHandler) and all(isinstance(each, ast.Pass) for each in node.body)
            assert not swallowed, f"{module.name}:{node.lineno}: except … pass"


@pytest.mark.parametrize("asked", ["corollary --help", "corollary generate --help"])
def test_help_loads_nothing_heavy(asked):
    words = asked.split()[1:]
    seen = subprocess.run(
        [sys.executable, "-c", HELP, *words], capture_output=True, text=True, timeout=60, check=True
    ).stderr.splitlines()[-1].split()  # fmt: skip
    assert "corollary.cli.main" in seen
    heavy = {"sympy", "numpy", "matplotlib", "nbgrader", "nbformat", "IPython", "rich", "flint", "yaml", "corollary.quantity", "corollary.problem"}
    assert not heavy & set(seen)


HELP = """
import sys
from corollary.cli.main import main
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
print(*sys.modules, file=sys.stderr)
"""


def _abstract(node: ast.ClassDef) -> bool:
    bases = {ast.unparse(base) for base in node.bases}
    return bool(bases & {"ABC", "Protocol", "Exception"}) or any("abstractmethod" in ast.unparse(each) for each in node.body)


def test_modules_were_found():
    assert len(MODULES) > 100
    assert all(isinstance(module, Module) for module in MODULES)
