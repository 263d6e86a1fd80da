"""Many submissions marked side by side: the same marks as one by one, whatever dies on the way."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, cast

import pytest

from corollary.answers.verdict import Unmarked
from corollary.course.workers import Execute, here, in_turn, side_by_side
from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission
from corollary.nbgrader.graded import GradedSubmission
from corollary.sandbox.isolation import WeakIsolation
from corollary.sandbox.job import Job
from corollary.sandbox.runner import Runner

from .small_class import POINTS, handed_in, order


class Deadly:
    """Stands where a runner stands, and kills the process it is in; with a `once`, only while that file is not there."""

    def __init__(self, once: Path | None = None) -> None:
        self.once = once
        self.real = Runner()

    def execute(self, job: Job) -> Any:
        if self.once is None or not self.once.exists():
            if self.once is not None:
                self.once.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return self.real.execute(job)


def deadly(once: Path | None = None) -> Callable[[], Runner]:
    return cast(Callable[[], Runner], partial(Deadly, once))


def marked(execute: Execute, by: GradingContext, papers: list[Submission]) -> dict[str, GradedSubmission]:
    with execute(by, iter(papers)) as returned:
        all_of_them = list(returned)
    assert len(all_of_them) == len(papers), "nobody twice, nobody missing"
    return {one.submission.student.id: one for one in all_of_them}


@pytest.fixture(scope="module")
def by(tmp_path_factory: pytest.TempPathFactory) -> GradingContext:
    return order(tmp_path_factory.mktemp("set"))


@pytest.fixture(scope="module")
def papers(by: GradingContext) -> list[Submission]:
    return handed_in(by)


def test_side_by_side_gives_what_one_by_one_gives(by: GradingContext, papers: list[Submission]) -> None:
    alone, together = marked(in_turn, by, papers), marked(side_by_side(2), by, papers)
    assert {name: one.marked.points for name, one in alone.items()} == POINTS
    for name, one in alone.items():
        assert together[name].marked.grades == one.marked.grades
        assert together[name].page == one.page
    assert all(one.marked.isolation for name, one in together.items() if name != "nils")


def test_nothing_is_left_where_temporary_files_go(
    by: GradingContext, papers: list[Submission], tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    marked(side_by_side(2), by, papers)
    assert list(tmp_path.iterdir()) == []


def test_few_are_marked_in_this_process_and_many_on_all_cores() -> None:
    assert here(None, 3) is in_turn
    assert here(1, 1000) is in_turn
    assert here(8, 1) is in_turn
    assert here(2, 3) is not in_turn


@pytest.mark.whole
def test_what_a_dead_process_was_at_is_done_again(
    by: GradingContext, papers: list[Submission], tmp_path: Path
) -> None:
    found = marked(side_by_side(2), replace(by, runner=deadly(tmp_path / "died")), papers)
    assert (tmp_path / "died").exists()
    assert {name: one.marked.points for name, one in found.items()} == POINTS


def test_a_submission_that_always_kills_waits_for_a_person_and_costs_no_marks(
    by: GradingContext, papers: list[Submission]
) -> None:
    found = marked(side_by_side(2), replace(by, runner=deadly()), papers)
    for name in ("ada", "ben", "jon"):
        parts = found[name].marked.grades[0].parts
        assert all(isinstance(part.verdict, Unmarked) for part in parts)
        assert "died twice" in found[name].marked.trouble
    assert found["nils"].marked.trouble.startswith("The notebook could not be opened")


def test_a_failing_of_the_judge_goes_to_a_person_and_the_others_are_marked(
    by: GradingContext, papers: list[Submission], monkeypatch
) -> None:
    key = Solutions.key

    def stumbling(self: Solutions, variant: Any) -> Any:
        if variant.index == papers[0].variants[0].index:
            raise ArithmeticError("no such number")
        return key(self, variant)

    monkeypatch.setattr(Solutions, "key", stumbling)
    found = marked(in_turn, by, papers)
    assert all(isinstance(part.verdict, Unmarked) for part in found["ada"].marked.grades[0].parts)
    assert [each.what for each in found["ada"].failures] == ["ArithmeticError: no such number"]
    assert "in stumbling" in found["ada"].failures[0].trace
    assert (
        found["ada"].marked.trouble == "The program failed to mark this, so your teacher will mark it."
    )  # no class of ours reaches a student
    assert found["ben"].marked.points == POINTS["ben"]


def test_weak_isolation_is_told_from_a_worker_too(by: GradingContext, papers: list[Submission]) -> None:
    with pytest.raises(WeakIsolation, match="Isolation level 4 is required"):
        marked(side_by_side(2), replace(by, runner=partial(Runner, require=4)), papers)


@pytest.mark.whole
@pytest.mark.skipif(sys.platform != "linux", reason="looks in /proc")
def test_no_process_outlives_a_killed_grading(tmp_path: Path) -> None:
    script = (
        f"import os, sys; sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
        "from pathlib import Path\nfrom small_class import handed_in, order\n"
        "from corollary.course.workers import side_by_side\n"
        f"by = order(Path({str(tmp_path)!r}))\nwith side_by_side(2)(by, iter(handed_in(by))) as returned:\n"
        "    next(returned)\n    tasks = [task for task in os.listdir('/proc') if task.isdigit()]\n"
        "    print(*[task for task in tasks if _parent(task) == os.getpid()], flush=True)\n"
        "    os.kill(os.getpid(), 9)\n"
    )
    parent = (  # others on the machine may end between being listed and being looked at
        "def _parent(task):\n    try:\n        return int(open(f'/proc/{task}/stat').read().rpartition(')')[2].split()[1])\n"
        "    except OSError:\n        return 0\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", parent + script], stdout=subprocess.PIPE, text=True, timeout=100, check=False
    )
    workers = done.stdout.split()
    assert done.returncode == -signal.SIGKILL
    assert len(workers) >= 2
    last = time.monotonic() + 20
    while any(_runs(task) for task in workers) and time.monotonic() < last:
        time.sleep(0.1)
    assert not any(_runs(task) for task in workers)


def _runs(task: str) -> bool:
    """Whether it is there, and more than an entry that nobody has asked after."""
    try:
        state = Path(f"/proc/{task}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state not in "ZX"
