"""Every problem of the bank verified over many variants, through the same door a user has."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank, chapter_bank, load
from corollary.problem.problem import Problem
from corollary.verify.verify import verify

BANK: Bank = chapter_bank()
PROBLEMS = load(BANK)


@pytest.mark.parametrize("problem", PROBLEMS, ids=[problem.code for problem in PROBLEMS])
def test_verifies(problem: Problem) -> None:
    checked = verify(BANK, problem, count=40)
    assert not checked.complaints
    assert checked.redrawn <= 0.8


def test_codes_are_unique_and_every_solution_is_used() -> None:
    assert len({problem.code for problem in PROBLEMS}) == len(PROBLEMS)
    used = {BANK.solution(problem) for problem in PROBLEMS}
    assert set((BANK.folder / "solutions").rglob("*.py")) == used
