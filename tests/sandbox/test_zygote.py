"""The child that gets ready early: it costs nobody anything, whatever becomes of it."""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

import pytest

from corollary.formula.value import Real
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.runner import Runner

JOB = Job((Cell("c", "a = 2.0"),), ("a",))


def offspring(process: int) -> list[int]:
    """Every process below this one, the eldest first."""
    own = [int(number) for number in Path(f"/proc/{process}/task/{process}/children").read_text().split()]
    return own + [each for child in own for each in offspring(child)]


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_child_that_dies_while_it_waits_costs_no_submission() -> None:
    with Runner() as runner:
        if runner.isolation.level < 3:
            pytest.skip("children get ready early only where each has a disk of its own")
        before = set(offspring(os.getpid()))
        assert runner.execute(JOB).values["a"] == Real(2.0)
        until = time.monotonic() + 20
        while not (waiting := set(offspring(os.getpid())) - before) and time.monotonic() < until:
            time.sleep(0.02)
        for child in waiting:
            os.kill(child, signal.SIGKILL)
        assert waiting
        for _ in range(2):
            taken = runner.execute(JOB)
            assert (taken.values["a"], taken.trouble) == (Real(2.0), "")


def test_many_notebooks_leave_no_unread_exits() -> None:
    with Runner() as runner:
        for _ in range(60):
            assert runner.execute(Job((), ())).trouble == ""
        assert runner._zygote is not None
        assert runner._zygote.unreaped <= 2
