"""Every problem of the bank verified over many variants, through the same door a user has."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.derive.load import sources
from corollary.derive.ready_scenes import ready_scenes
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem import Problem
from corollary.sandbox.runner import Runner
from corollary.verify.program_checks import unstarted
from corollary.verify.verify import verify

BANK: Bank = chapter_bank()
QUICK = ("E12.3.1s", "E12.7.2", "S12.4n", "S12.5r", "X12.11", "X12.2", "X12.5", "X12.8")
MANY = 100
CASES = [
    *(pytest.param(BANK[code], 8, id=code) for code in QUICK),
    *(pytest.param(each, MANY, id=f"{each.code} {MANY}", marks=pytest.mark.whole) for each in PROBLEMS),
]


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    with unstarted() as one:
        yield one


@pytest.mark.parametrize(("problem", "count"), CASES)
def test_verifies(problem: Problem, count: int, runner: Runner) -> None:
    checked = verify(BANK, problem, count, runner)
    assert not checked.complaints
    assert checked.redrawn <= 0.8


def test_of_every_topic_but_the_projects_some_are_verified_at_once() -> None:
    assert {BANK[code].topic for code in QUICK} == {each.topic for each in PROBLEMS} - {"projects"}


def test_every_file_of_the_solutions_is_used() -> None:
    """A solution belongs to a problem; a program lies in a folder named like the solution that shows it, and so do its judges. Ready
    scenes lie in a folder of their own; one that no problem uses is there to be played."""
    folder = BANK.folder / "solutions"
    solutions = {BANK.solution(problem) for problem in PROBLEMS}
    used = {path for problem in PROBLEMS for path in sources(BANK, problem)}
    scenes = set((folder / "scenes").glob("*.py"))
    assert used | scenes == {*folder.rglob("*.py"), *folder.rglob("*.md")}
    assert {path.stem for path in scenes - used} <= set(ready_scenes(BANK))
    used -= scenes
    beside = {path for path in used - solutions if path.with_suffix(".md") in solutions}  # scenes
    used -= beside
    stems = {path.with_suffix("") for path in solutions}
    programs = {path for path in used - solutions if path.parent in stems}
    assert {path.name for path in used - solutions - programs} == {"two_bodies.py"}  # two exercises share it
    shown = {path for path in programs if not path.name.startswith("judge_")}
    assert len(shown) >= 13
    for path in shown:
        (solution,) = (each for each in solutions if each.with_suffix("") == path.parent)
        shown_as = f"example: `{path.parent.name}/{path.name}`", f'file("{path.parent.name}/{path.name}")'
        assert any(words in solution.read_text(encoding="utf-8") for words in shown_as)


def test_solutions_import_what_authors_import() -> None:
    """The words of an author and the laws; else only libraries."""
    for path in {BANK.solution(problem).with_suffix(".py") for problem in PROBLEMS}:
        tree = ast.parse(path.read_text(encoding="utf-8") if path.is_file() else "")
        names = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        names |= {
            alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names
        }
        assert {name for name in names if name and name.startswith("corollary")} <= {
            "corollary.author",
            "corollary.laws",
        }
