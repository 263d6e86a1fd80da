"""How commands end."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from importlib import import_module
from pathlib import Path

import pytest
from tests import forked

from corollary.cli.ending import RAISED, expected


@pytest.mark.parametrize("where", ["", "destroyed = Destroyed(); del destroyed"])
def test_ctrl_c_ends_a_command_with_130(tmp_path: Path, where: str) -> None:
    """A command that is at work (it has said so by making a file) is stopped, says so, and leaves no traceback; also where
    Python drops what is raised."""
    begun = tmp_path / "begun"
    program = f"""
import pathlib, signal, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job, such as a gate, ignores it
from corollary.cli import listing
class Destroyed:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)
def run(**options):
    {where}
    pathlib.Path({str(begun)!r}).touch()
    time.sleep(60)
listing.run = run
from corollary.cli.main import main
main()
"""
    with subprocess.Popen(
        [sys.executable, "-c", program, "list"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as running:
        while not begun.exists() and running.poll() is None:
            time.sleep(0.05)
        if not where:
            running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=60)
    assert (running.returncode, out, err) == (130, "", "stopped\n")


@pytest.mark.parametrize("module", RAISED)
def test_every_exception_is_defined_where_it_is_looked_for(module: str):
    found = import_module(module)
    for name in RAISED[module]:
        raised = getattr(found, name)
        assert issubclass(raised, Exception)
        assert raised.__module__ == module
        assert raised in expected()


@pytest.mark.whole
@pytest.mark.parametrize("whom", ["the command", "everybody at once, as a terminal does"])
def test_ctrl_c_while_notebooks_run_ends_with_130_and_nobody_is_left(tmp_path: Path, whom: str) -> None:
    """Two workers, each with a notebook that does not end: stopped, all processes are gone, and nothing was recorded."""
    names = [f"s{number}" for number in range(4)]
    (tmp_path / "roster.csv").write_text("\n".join(["id", *names, ""]))
    (tmp_path / "one.md").write_text("---\ntitle: One\nproblems: [X12.5]\n---\n")
    command, course = forked.COMMAND, tmp_path / "mech"
    made = [command, "generate", tmp_path / "one.md", "--roster", tmp_path / "roster.csv", "--course", course]
    forked.run(made, check=True, capture_output=True)
    for name in names:
        place = course / "submitted" / name / "one" / "one.ipynb"
        place.parent.mkdir(parents=True)
        text = (course / "release" / name / "one" / "one.ipynb").read_text(encoding="utf-8")
        place.write_text(text.replace("X12_5_a = None", "while True: pass"), encoding="utf-8")
    words = ["grade", "one", "--jobs", "2", "--require-isolation", "0", "--course", str(course)]
    program = (
        "import signal, sys\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"sys.argv = ['corollary', *{words!r}]\nfrom corollary.cli.main import main\nmain()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as running:
        seen: dict[int, int] = {}
        while max(seen.values(), default=0) < 3 and running.poll() is None:
            time.sleep(0.05)
            seen = _descendants(running.pid)
        (os.kill if whom == "the command" else os.killpg)(running.pid, signal.SIGINT)
        _, err = running.communicate(timeout=120)
    assert running.returncode == 130, err
    assert err.endswith("stopped\n")
    assert "Traceback" not in err
    for _ in range(400):  # a moment for the system to take them away
        if not (left := {pid for pid in seen if _lives(pid)}):
            break
        time.sleep(0.05)
    assert not left
    assert not list(course.glob(".corollary/graded/one/*.json"))


def _lives(pid: int) -> bool:
    """Whether it is still there, and not only waited for by nobody."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def _descendants(ancestor: int) -> dict[int, int]:
    """The processes below another, and how far: its workers, their zygotes, and the notebooks that these run."""
    parents: dict[int, int] = {}
    for place in Path("/proc").glob("[0-9]*"):
        try:
            parents[int(place.name)] = int((place / "stat").read_text().rpartition(")")[2].split()[1])
        except OSError:  # it ended meanwhile
            continue
    found: dict[int, int] = {}
    for pid in parents:
        depth, at = 0, pid
        while at in parents and at != ancestor:
            depth, at = depth + 1, parents[at]
        if at == ancestor and depth:
            found[pid] = depth
    return found
