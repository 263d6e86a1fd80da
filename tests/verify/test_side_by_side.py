"""Problems verified in several processes are the same, and in the same order, as in one; a process that is killed loses none."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from corollary.problem.bank import find, open_bank
from corollary.verify import side_by_side
from corollary.verify.checked import Checked

CODES = ("X12.2", "X12.5", "E12.3.1")
BANK = open_bank(None)
TODO = [(BANK, find(BANK, code)) for code in CODES]


def found(jobs: int) -> list[Checked]:
    with side_by_side.verify_each(TODO, 4, jobs) as checked:
        return list(checked)


@pytest.fixture(scope="module")
def one_by_one() -> list[Checked]:
    return found(1)


@pytest.mark.whole
def test_many_processes_find_what_one_does(one_by_one: list[Checked]) -> None:
    assert [each.code for each in one_by_one] == list(CODES)
    assert found(2) == one_by_one


@pytest.mark.whole
def test_a_process_that_is_killed_loses_no_problem(
    monkeypatch: pytest.MonkeyPatch, one_by_one: list[Checked], tmp_path: Path
) -> None:
    """One that is killed twice, in a process of its own the second time, is what ends them, and a complaint."""
    here, real, killed = os.getpid(), side_by_side.verify, tmp_path / "killed"

    def killed_at_the_second(bank, problem, count, runner):
        if os.getpid() != here and problem.code == CODES[1] and not killed.exists():
            killed.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return real(bank, problem, count, runner)

    monkeypatch.setattr(side_by_side, "verify", killed_at_the_second)
    assert found(2) == one_by_one
