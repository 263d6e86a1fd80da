"""What is the machine's failing is called so, and no notebook's; nothing is left on its disk."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

import pytest

from corollary.formula.value import Nothing, Real
from corollary.sandbox.job import Cell, Job, Limits
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart

JOB = Job((Cell("c", "a = 2.0"),), ("a",))


def test_without_a_temporary_folder_nothing_starts_and_a_sentence_says_why(
    tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "absent"))
    with pytest.raises(CannotStart, match=r"no temporary folder .*No such file.*make room, or set TMPDIR"):
        Runner().__enter__()


def test_a_full_disk_is_not_the_notebooks_doing(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with pytest.raises(CannotStart, match="No space left on device"):
        Runner(Limits(file_bytes=1 << 60), without=frozenset({"namespaces"})).__enter__()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.whole
def test_a_disk_that_fills_up_between_two_notebooks_stops_the_run(monkeypatch) -> None:
    with Runner(without=frozenset({"namespaces"})) as running:
        assert running.execute(JOB).values["a"] == Real(2.0)
        full = namedtuple("Usage", "total used free")(1 << 40, 1 << 40, 0)
        with monkeypatch.context() as patched:
            patched.setattr(shutil, "disk_usage", lambda path: full)
            with pytest.raises(CannotStart, match="No space left on device"):
                running.execute(JOB)
        assert running.execute(JOB).values["a"] == Real(2.0)


@pytest.mark.whole
def test_a_process_that_dies_before_the_first_cell_is_the_machines_failing() -> None:
    with Runner(Limits(memory_bytes=24 << 20)) as running:
        result = running.execute(Job((Cell("c", "a = 1 #" + "x" * (200 << 20)),), ("a",)))
        assert result.machine_failed
        assert "before its first cell" in result.trouble
        assert result.values == {"a": Nothing()}


def test_a_death_in_a_cell_is_the_notebooks_own() -> None:
    with Runner() as running:
        result = running.execute(Job((Cell("c", "a = 2.0"), Cell("d", "import os; os._exit(1)")), ("a",)))
        assert result.trouble
        assert not result.machine_failed


@pytest.mark.whole
def test_what_a_killed_process_left_is_removed_by_the_next(tmp_path: Path) -> None:
    script = (
        "import os, signal\nfrom corollary.sandbox.runner import Runner\n"
        "with Runner(): os.kill(os.getpid(), signal.SIGKILL)"
    )
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    for _ in range(2):
        done = subprocess.run([sys.executable, "-c", script], env=environment, check=False)
        assert done.returncode == -9
        (left,) = tmp_path.iterdir()
    polite = "from corollary.sandbox.runner import Runner\nwith Runner(): pass"
    subprocess.run([sys.executable, "-c", polite], env=environment, check=True)
    assert not left.exists()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_lost_its_lock_goes_once_it_is_old(tmp_path: Path, monkeypatch) -> None:
    """Removing was cut short: what is there has no lock any more. A folder of somebody else's under such a name stays."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    for name, inside in (
        ("corollary-remnant_", "disk"),
        ("corollary-justmade", "disk"),
        ("corollary-myfolder", "thesis"),
    ):
        (tmp_path / name / inside).mkdir(parents=True)
        if name != "corollary-justmade":
            os.utime(tmp_path / name, (1_700_000_000, 1_700_000_000))
    with Runner():
        assert not (tmp_path / "corollary-remnant_").exists()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["corollary-justmade", "corollary-myfolder"]


@pytest.mark.whole
def test_a_folder_half_removed_is_still_known_as_abandoned(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    removed: list[str] = []
    monkeypatch.setattr("corollary.sandbox.folders._remove", lambda path: removed.append(path.name))
    with Runner():
        (folder,) = tmp_path.iterdir()
    assert removed[-1] == folder.name
    assert "lock" not in removed
    monkeypatch.undo()
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with Runner():
        assert not folder.exists()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.whole
def test_folders_in_use_and_those_of_others_are_left_alone(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    (tmp_path / "corollary-mine").mkdir()
    (tmp_path / "corollary-mine" / "notes").write_text("x")
    with Runner() as first:
        with Runner() as second:
            assert second.execute(JOB).values["a"] == Real(2.0)
        assert first.execute(JOB).values["a"] == Real(2.0)
    assert [path.name for path in tmp_path.iterdir()] == ["corollary-mine"]
