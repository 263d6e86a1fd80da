"""Every command that a page, a message or a comment in a course's files names is there, ours and nbgrader's."""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from corollary.cli.commands import app

TOP = Path(__file__).parents[2]
SENTENCE = {
    "leaves",
    "or",
    "fail",
    "failed",
    "command",
}  # what follows the name of our program in a sentence and is no command
# Where a command stands as one: as code, or after what tells the reader to run it.
AS_A_COMMAND = r"(?:`|&& |\$ |[Rr]un |[Tt]ry: )"


@cache
def texts() -> tuple[tuple[str, str], ...]:
    """Every page, every string of the package and of the tools, every template, each with where it stands."""
    return tuple(_found())


def _found() -> Iterator[tuple[str, str]]:
    for path in [
        TOP / "README.md",
        TOP / "Makefile",
        TOP / "Dockerfile",
        *sorted((TOP / "docs").rglob("*.md")),
    ]:
        yield path.name, path.read_text(encoding="utf-8")
    for path in sorted((TOP / "src").rglob("*.html")):
        yield path.name, path.read_text(encoding="utf-8")
    for path in sorted((TOP / "src").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield f"{path.name}:{node.lineno}", node.value


@pytest.fixture(scope="module")
def commands() -> dict[str, set[str]]:
    from nbgrader.apps.nbgraderapp import NbGraderApp

    return {"corollary": set(app.commands), "nbgrader": set(NbGraderApp.subcommands)}


def test_every_command_of_ours_that_is_named_is_there(commands: dict[str, set[str]]):
    found = [
        (where, word)
        for where, text in texts()
        for word in re.findall(r"(?<![\w./'-])corollary ([a-z_]+)\b", text)
    ]
    assert len(found) > 50
    known = commands["corollary"] | SENTENCE
    assert not [f"{where}: corollary {word}" for where, word in found if word not in known]


@pytest.mark.parametrize("program", ["corollary", "nbgrader"])
def test_what_stands_as_a_command_is_one(commands: dict[str, set[str]], program: str):
    named = re.compile(rf"{AS_A_COMMAND}{program} ([a-z_]+)")
    found = [(where, word) for where, text in texts() for word in named.findall(text)]
    assert len(found) > 5
    assert not [f"{where}: {program} {word}" for where, word in found if word not in commands[program]]


def test_every_option_that_a_page_names_is_there():
    """`corollary grade SET --dry-run` on a page: `grade` has it."""
    for path in [TOP / "README.md", *sorted((TOP / "docs").rglob("*.md"))]:
        for name, rest in re.findall(
            r"(?:^|`|\$ )corollary ([a-z]+)([^`\n#]*)", path.read_text(encoding="utf-8"), re.MULTILINE
        ):
            if name in app.commands:
                have = {option for parameter in app.commands[name].params for option in parameter.opts} | {
                    "--help"
                }
                for option in re.findall(r"(?<![\w-])--[a-z-]+", rest):
                    assert option in have, f"{path.name}: corollary {name} {option}"


BY_BARE_NAME = re.compile(
    r"(?<!un)install\b[^`\n]*?(?<![\w./\\@-])corollary(?![\w./-])"  # pip install corollary; ./corollary is a folder
    r"|(?<![\w./\\-])corollary\["  # an extra of the bare name, whatever stands before it
)


@pytest.mark.parametrize(
    "advice",
    ["pip install corollary", "uv pip install --upgrade 'corollary'", 'pip install "corollary[pdf]"', "'corollary[pdf]'"],
)  # fmt: skip
def test_advice_by_bare_name_is_found(advice: str):
    assert BY_BARE_NAME.search(advice)
    assert not BY_BARE_NAME.search(advice.replace("corollary", "./corollary"))


def test_nothing_advises_to_install_the_package_that_has_our_name():
    """The name `corollary` on PyPI belongs to another project: ours is `corollary-physics`."""
    others = [*(TOP / "examples").rglob("*.md"), *(TOP / "benchmarks").rglob("*.md"), *TOP.glob(".ci/*.py")]
    advised = [*texts(), *((path.name, path.read_text(encoding="utf-8")) for path in others)]
    assert not [(where, found[0]) for where, text in advised if (found := BY_BARE_NAME.search(text))]


def test_no_bank_depends_on_the_package_that_has_our_name():
    ours = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"]["name"]
    files = [*TOP.glob("examples/banks/*/pyproject.toml"), *TOP.glob("tests/plugin/*/pyproject.toml")]
    assert len(files) > 3
    for path in files:
        wanted = tomllib.loads(path.read_text(encoding="utf-8"))["project"]["dependencies"]
        assert not [each for each in wanted if re.match(r"corollary\b(?![\w-]|\s*@)", each)], path.parent.name
        assert [each for each in wanted if re.match(rf"{ours}\b", each)], path.parent.name
