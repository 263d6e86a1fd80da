"""Marking on a Dask cluster: the same marks, also when a worker is killed on the way."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from corollary import parallel
from corollary.course.workers import Sent, in_turn, mark_there, on_cluster
from corollary.grading.submission import state_of
from corollary.parallel import NoCluster

from .small_class import POINTS, handed_in, order

distributed = pytest.importorskip("distributed", reason="needs Dask: pip install '.[dask]'")


@pytest.mark.whole
def test_a_worker_killed_on_the_way_loses_nothing(tmp_path: Path) -> None:
    by = order(tmp_path)
    papers = handed_in(by)
    with (
        distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as machines,
        on_cluster(machines.scheduler_address)(by, iter(papers)) as returned,
    ):
        os.kill(next(iter(machines.workers.values())).pid, signal.SIGKILL)
        found = {one.submission.student.id: one for one in returned}
    assert {name: one.marked.points for name, one in found.items()} == POINTS
    with in_turn(by, iter(papers[:1])) as alone:
        assert next(alone).marked.grades == found["ada"].marked.grades


def test_nobody_answers(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr(parallel, "SECONDS_TO_CONNECT", 1)
    with (
        pytest.raises(NoCluster, match="no Dask scheduler answers"),
        on_cluster("tcp://127.0.0.1:9")(order(tmp_path), []),
    ):
        pytest.fail("there is no cluster to mark on")


def test_a_worker_with_other_solutions_marks_nothing(tmp_path: Path) -> None:
    by = order(tmp_path)
    with pytest.raises(NoCluster, match="another version"):
        mark_there(Sent(by, "token", state_of(by.problem_set, by.solutions) + "x"), handed_in(by)[0])
