"""Every problem of the bank verified over many variants, through the same door a user has."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from corollary.problem.bank import Bank, chapter_bank, load
from corollary.problem.problem import Problem
from corollary.sandbox.runner import Runner
from corollary.verify.programs import unstarted
from corollary.verify.verify import verify

BANK: Bank = chapter_bank()
PROBLEMS = load(BANK)
LONG = {  # more than three seconds each
    "E12.3.2", "E12.5.2", "P12.15", "S12.1", "S12.5nc", "S12.5pi", "S12.5two", "S12.5wall", "S12.6", "S12.7", "T12.6", "X12.10", "X12.3",
}  # fmt: skip
QUICK = [problem for problem in PROBLEMS if problem.code not in LONG]


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    with unstarted() as one:
        yield one


@pytest.mark.parametrize("problem", QUICK, ids=[problem.code for problem in QUICK])
def test_verifies(problem: Problem, runner: Runner) -> None:
    checked = verify(BANK, problem, 8, runner)
    assert not checked.complaints
    assert checked.redrawn <= 0.8


def test_all_but_the_long_ones_are_verified_at_once() -> None:
    assert len(LONG) == len(PROBLEMS) - len(QUICK) < len(PROBLEMS) / 3


@pytest.mark.whole
@pytest.mark.parametrize("problem", PROBLEMS, ids=[problem.code for problem in PROBLEMS])
def test_verifies_over_many_variants(problem: Problem, runner: Runner) -> None:
    checked = verify(BANK, problem, 100, runner)
    assert not checked.complaints


def test_every_file_of_the_solutions_is_used() -> None:
    """A solution belongs to a problem; a program lies in a folder named like the solution that shows it."""
    folder = BANK.folder / "solutions"
    used = {BANK.solution(problem) for problem in PROBLEMS}
    programs = {path for path in folder.rglob("*.py") if path not in used}
    assert used <= set(folder.rglob("*.py"))
    assert programs
    for path in programs:
        solution = path.parent.with_suffix(".py")
        assert solution in used
        assert f'file("{path.parent.name}/{path.name}")' in solution.read_text(encoding="utf-8")


def test_solutions_import_what_authors_import() -> None:
    """The words of an author and the laws; else only libraries."""
    for problem in PROBLEMS:
        tree = ast.parse(BANK.solution(problem).read_text(encoding="utf-8"))
        names = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        names |= {
            alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names
        }
        assert {name for name in names if name and name.startswith("corollary")} <= {
            "corollary.author",
            "corollary.laws",
        }
