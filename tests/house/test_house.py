"""The house stands as it is drawn: floors, doors, names, and files of a size one can read."""

from __future__ import annotations

import ast
import re
import statistics
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from corollary.problem.bank import chapter_bank

ORDER = (  # from the top; what stands in one line are siblings, which do not know each other
    "__main__", "cli", "api", "course", "nbgrader", "render", "records", "audit", "verify practice trade",
    "author misconceptions programs", "grading", "notebook derive", "answers",
    "laws problem sandbox scenes", "units polynomials", "formula figure", "plug_ins", "user_cache", "messages atomic guard parallel", "extras", "version",
)  # fmt: skip
FLOORS = {room: len(ORDER) - floor for floor, rooms in enumerate(ORDER) for room in rooms.split()}
LONGEST, MEDIAN = 600, 150  # lines
LONGEST_OPENING = 25  # words
FORBIDDEN = re.compile(r"manager|util(s|ities)?(_|$)|helpers?(_|$)|process(es|or|ors)?(_|$)", re.IGNORECASE)
HEAVY = {"sympy", "numpy", "matplotlib", "nbgrader", "nbformat", "IPython", "flint", "yaml"}


def test_every_folder_stands_on_a_floor(modules):
    assert {module.folder for module in modules} == FLOORS.keys()


def test_imports_go_down_and_siblings_do_not_know_each_other(modules):
    wrong = [
        f"{module.name}:{line} on floor {FLOORS[module.folder]} imports {name}"
        for module in modules
        for name, line in module.of_ours()
        if (other := name.partition(".")[0]) != module.folder and FLOORS[other] >= FLOORS[module.folder]
    ]
    assert not wrong


def test_nobody_imports_the_roof(modules):
    """What `import corollary` offers stands above all rooms."""
    assert not [
        f"{module.name}:{line}" for module in modules for name, line in module.imports if name == "corollary"
    ]


def test_what_is_handed_out_cannot_see_the_truth(modules):
    notebook = {name for module in modules if module.folder == "notebook" for name, _ in module.of_ours()}
    assert notebook
    assert not {name for name in notebook if name.partition(".")[0] in {"derive", "laws", "grading"}}


def test_no_circles(modules):
    ours = {module.name: {name for name, _ in module.of_ours() if name != module.name} for module in modules}
    done: set[str] = set()

    def walk(name: str, way: tuple[str, ...]) -> None:
        assert name not in way, f"a circle: {' > '.join((*way[way.index(name) :], name))}"
        if name not in done:
            for other in ours.get(name, ()):
                walk(other, (*way, name))
            done.add(name)

    for name in ours:
        walk(name, ())
    assert len(done) >= len(modules)


@pytest.mark.parametrize(
    ("library", "rooms"),
    [
        (
            "sympy",
            (
                "author",
                "laws",
                "derive",
                "formula.functions",
                "formula.to_sympy",
                "formula.from_sympy",
                "formula.authored",
                "sandbox.worker",
            ),
        ),
        ("matplotlib", ("figure", "sandbox.worker")),
        ("nbgrader", ("nbgrader",)),
        ("nbformat", ("notebook.", "sandbox.", "nbgrader")),
        ("IPython", ("sandbox.worker",)),
        ("flint", ("formula", "polynomials", "answers.equality", "scenes.models")),
        ("yaml", ("problem.front_matter",)),
        ("click", ("cli",)),
    ],
)
def test_a_library_is_known_only_where_it_is_at_home(modules, library, rooms):
    homes = [
        f"{module.name}:{line}"
        for module in modules
        for name, line in module.of_others()
        if name.partition(".")[0] == library
    ]
    assert homes
    assert not [home for home in homes if not home.startswith(rooms)]


def test_one_door_to_the_solutions(modules):
    """Only derive.load opens a solution; others may ask where it lies, to name it in a complaint."""
    opened = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)}"
        for module in modules if module.name != "derive.load"
        for node in module.nodes(ast.Attribute)
        if (node.attr.startswith("read_") or node.attr == "open") and ".solution(" in ast.unparse(node.value)
    ]  # fmt: skip
    assert not opened
    loaders = {
        module.name
        for module in modules
        for node in module.nodes(ast.Attribute)
        if node.attr == "spec_from_file_location"
    }
    assert loaders == {"derive.load"}
    assert not [module.name for module in modules for name, _ in module.of_others() if name == "runpy"]
    namers = {
        module.name for module in modules for node in module.nodes(ast.Constant) if node.value == "solutions"
    }
    assert namers == {"problem.bank", "problem.diagnostic"}  # which names the folder in complaints


def test_problems_hold_no_programs():
    kinds = {path.suffix for path in chapter_bank().problems.rglob("*") if path.is_file()}
    assert kinds
    assert kinds <= {".md", ".svg"}


def test_files_are_short(modules):
    assert not {module.name: module.lines for module in modules if module.lines > LONGEST}
    assert statistics.median(module.lines for module in modules) <= MEDIAN


def test_no_file_name_stands_twice(modules):
    """But for a command and the module that does its work, the two halves of each answer type, and the two ends of a worker's channel."""
    homes: dict[str, set[str]] = {}
    for module in modules:
        if module.path.stem != "__init__":
            room, _, rest = module.name.partition(".")
            homes.setdefault(module.path.stem, set()).add(
                "cli" if room == "cli" else module.name if rest else ""
            )
    twice = {name: places - {"cli"} for name, places in homes.items() if len(places - {"cli"}) > 1}
    assert {name for name in twice if name not in {"reading", "judging"}} == {"protocol", "zygote"}
    assert twice["zygote"] == {"sandbox.zygote", "sandbox.worker.zygote"}
    assert twice["protocol"] == {"sandbox.protocol", "sandbox.worker.protocol"}
    assert all(place.startswith("answers.") for name in ("reading", "judging") for place in twice[name])


def test_every_module_opens_with_a_short_sentence_that_names_its_subject(modules):
    for module in modules:
        about = (ast.get_docstring(module.tree) or "").split("\n\n")[0]
        assert about.endswith((".", "?", "!")), f"{module.name} opens with {about!r}"
        assert not re.match(r"(What|Whose|Whether|Where|How|Who|Which|When|Why)\b", about), module.name
        assert len(about.split()) <= LONGEST_OPENING, f"{module.name}: {about!r}"


def test_names_come_from_the_classroom(modules):
    assert not [module.name for module in modules if FORBIDDEN.search(module.path.stem)]
    for module in modules:
        for node in module.nodes(ast.ClassDef):
            library_says_so = any(FORBIDDEN.search(ast.unparse(base)) for base in node.bases)
            assert library_says_so or not FORBIDDEN.search(node.name), (
                f"{module.name}:{node.lineno}: {node.name}"
            )


def test_one_name_is_one_class(modules):
    homes: dict[str, list[str]] = {}
    for module in modules:
        for node in module.nodes(ast.ClassDef):
            homes.setdefault(node.name, []).append(f"{module.name}:{node.lineno}")
    assert not {name: places for name, places in homes.items() if len(places) > 1}


def test_classes_are_abstract_or_final(modules):
    """A class of ours is inherited from only when it is abstract; exceptions of other libraries' making may be refined."""
    classes = {node.name: node for module in modules for node in module.nodes(ast.ClassDef)}
    for name, node in classes.items():
        for base in map(ast.unparse, node.bases):
            assert base not in classes or _abstract(classes[base]), (
                f"{name} inherits from {base}, which is not abstract"
            )


def _abstract(node: ast.ClassDef) -> bool:
    return bool({"ABC", "Protocol"} & {ast.unparse(base).partition("[")[0] for base in node.bases})


def test_nothing_is_asked_by_name_and_nothing_swallowed(modules):
    for module in modules:
        for call in module.nodes(ast.Call):
            assert ast.unparse(call.func) != "hasattr", f"{module.name}:{call.lineno}: hasattr"
        for handler in module.nodes(ast.ExceptHandler):
            assert not all(isinstance(each, ast.Pass) for each in handler.body), (
                f"{module.name}:{handler.lineno}: except … pass"
            )


@pytest.mark.parametrize("asked", ["--help", "generate --help", "key --help"])
def test_help_loads_nothing_heavy(asked):
    seen = subprocess.run(
        [sys.executable, "-c", HELP, *asked.split()], capture_output=True, text=True, timeout=60, check=True
    )
    loaded = set(seen.stderr.split())
    assert "Usage" in seen.stdout
    assert "corollary.cli.main" in loaded
    assert not HEAVY & loaded
    assert not {
        name for name in loaded if name.startswith("corollary.") and not name.startswith("corollary.cli")
    } - {"corollary.version"}


HELP = """
import sys
from corollary.cli.main import main
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
print(*sys.modules, file=sys.stderr)
"""


WITHOUT_TYPES = (
    "sympy",
    "flint",
    "scipy",
    "numpy",
    "matplotlib",
    "nbformat",
    "nbgrader",
    "distributed",
    "yaml",
)


def test_unknown_types_are_let_pass_only_where_a_library_has_none(modules):
    """A comment at the top of a file turns reports off for that file; a file that imports no such library needs none."""
    for module in modules:
        off = re.findall(r"^# pyright: (.+)$", module.path.read_text(encoding="utf-8"), re.MULTILINE)
        assert all(
            re.fullmatch(r"report\w+=false", rule.strip()) for rules in off for rule in rules.split(",")
        )
        imported = {name.partition(".")[0] for name, _ in module.imports}
        assert not off or imported & {*WITHOUT_TYPES}, f"{module.name} has types for all that it imports"


def test_reports_of_unknown_types_are_off_in_two_folders_alone():
    """The worker, which is installed by its text in a bare interpreter, and what numba compiles."""
    settings = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))[
        "tool"
    ]["pyright"]
    assert settings["typeCheckingMode"] == "strict"
    off = {rule for rule, value in settings.items() if rule.startswith("report") and value is False}
    assert off == {"reportMissingTypeStubs", "reportMissingModuleSource"}
    loose = {
        each["root"]
        for each in settings["executionEnvironments"]
        if any(name.startswith("report") for name in each)
    }
    assert loose == {"src/corollary/sandbox/worker", "src/corollary/scenes/integrate"}
