"""What works on Windows: everything but grading. Tried without what Windows lacks: modules, functions of `os`, and signals."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

# Before anything of ours is imported; Python's own modules do without where they can, as they do on Windows.
LIKE_WINDOWS = """
import os, signal, socket, sys, types
import asyncio, concurrent.futures.process, multiprocessing.connection, selectors, subprocess, tempfile  # POSIX's own
for name in ("fcntl", "resource", "pwd", "grp", "termios", "syslog", "pty", "tty", "readline", "pyseccomp", "landlock"):
    sys.modules[name] = None
lacking = "fork getuid geteuid getgid getegid O_NOFOLLOW O_DIRECTORY O_CLOEXEC O_NONBLOCK O_NOCTTY killpg mkfifo " \
    "fchmod fchown lchown setsid pidfd_open memfd_create"
for name in lacking.split():
    vars(os).pop(name, None)
for name in ("SIGKILL", "SIGXCPU", "SIGSYS", "SIGBUS", "SIGHUP", "SIGUSR1", "SIGALRM", "SIGCHLD", "SIGPIPE", "pidfd_send_signal"):
    vars(signal).pop(name, None)
vars(socket).pop("AF_UNIX", None)
os.supports_dir_fd = set()
held = []
windows = types.ModuleType("msvcrt")
windows.LK_NBLCK, windows.locking = 2, lambda *about: held.append(about)
sys.modules["msvcrt"] = windows
"""
MAIN = "sys.argv = ['corollary', *{words!r}]\nfrom corollary.cli.main import main\nmain()\n"


# nbgrader and its like ask for Windows by name, and so cannot be told that this is one: loaded before, or not installed.
LOADED = "import nbconvert, nbgrader.apps, nbgrader.exchange, platformdirs\n"
ABSENT = "sys.modules['nbgrader'] = None\n"


def like_windows(program: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return like_windows(LIKE_WINDOWS + ABSENT + MAIN.format(words=list(words)), folder)


@pytest.mark.whole
def test_the_package_and_all_its_rooms_can_be_imported(tmp_path: Path):
    program = """
import importlib, pkgutil, corollary
names = [module.name for module in pkgutil.walk_packages(corollary.__path__, "corollary.")]
for name in names:
    if not name.startswith(("corollary.sandbox.worker.", "corollary.bank")):  # which is another process's
        importlib.import_module(name)
print(len(names))
"""
    done = like_windows(LOADED + LIKE_WINDOWS + program, tmp_path)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 200


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["list", "--topic", "impulse"], "8 problems, 38 parts"),
        (["show", "X12.5", "--solution"], "A football of mass 0.43 kg"),
        (["key", "X12.5"], "8.6 kg*m/s"),
        (["read", "8,6 Ns", "--unit", "kg m/s"], "compatible"),
        (["scene", "cradle"], "released"),
        (["doctor"], "platform"),
    ],
)
def test_commands_without_a_course(tmp_path: Path, words: list[str], expected: str):
    done = run(tmp_path, *words)
    assert done.returncode == 0 or words == ["doctor"], done.stderr
    assert expected in done.stdout
    assert "should not have happened" not in done.stderr


@pytest.mark.whole
def test_a_course_is_generated_and_exported_there_and_grading_says_where_it_works(tmp_path: Path):
    (tmp_path / "roster.csv").write_text("id\nada\n")
    (tmp_path / "one.md").write_text("---\ntitle: One\ndue: 2999-12-04\nproblems: [X12.5]\n---\n")
    done = run(tmp_path, "generate", "one.md", "--roster", "roster.csv", "--course", "mech", "--json")
    assert done.returncode == 0, done.stderr
    sheet = Path(json.loads(done.stdout)["students"]["ada"]["sheet"])
    assert sheet.is_file()
    done = run(tmp_path / "mech", "extend", "ada", "one", "2999-12-11")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path / "mech", "export", "one", "--to", "html")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path / "mech", "release", "one", "--to", "folder")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path / "mech", "collect", "one", str(sheet))
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "mech" / "submitted" / "ada" / "one" / "one.ipynb").read_bytes() == sheet.read_bytes()
    done = run(tmp_path / "mech", "grade", "one")
    assert done.returncode == 2, done.stdout
    assert "on Linux and macOS only" in done.stderr
    assert "WSL" in done.stderr
    assert len([line for line in done.stderr.splitlines() if line.startswith("corollary: ")]) == 1


def test_a_handed_in_link_is_not_followed_there_either(tmp_path: Path):
    (tmp_path / "submitted" / "ada").mkdir(parents=True)
    (tmp_path / "secret").write_text("the key")
    (tmp_path / "submitted" / "ada" / "link").symlink_to(tmp_path / "secret")
    (tmp_path / "submitted" / "ada" / "file").write_text("mine")
    (tmp_path / "submitted" / "bob").symlink_to(tmp_path / "submitted" / "ada")
    program = """
from pathlib import Path
from corollary.sandbox.file import bytes_of
for name in ("ada/file", "ada/link", "bob/file", "ada", "nothing"):
    print(bytes_of(Path("submitted", name), within=Path("submitted")))
"""
    mine, *others = like_windows(LIKE_WINDOWS + program, tmp_path).stdout.splitlines()
    assert mine == "b'mine'"
    assert len(others) == 4
    assert all(other.startswith("Unreadable(") for other in others)
