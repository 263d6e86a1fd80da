"""Hostile notebooks that look where they must not: files, the course, other notebooks, the network."""

from __future__ import annotations

import os
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest

import corollary
from corollary.formula.value import Exact, Nothing, Text
from corollary.sandbox.job import Cell, ExecutionResult, Job
from corollary.sandbox.runner import Runner

Run = Callable[..., ExecutionResult]


def statuses(taken: ExecutionResult) -> list[str]:
    return [cell.status for cell in taken.cells]


def said(taken: ExecutionResult) -> str:
    return str([cell.outputs for cell in taken.cells]) + "".join(cell.error for cell in taken.cells)


# Looking where it must not


@pytest.mark.parametrize(
    "path",
    [
        "/etc/passwd",
        "/proc/self/environ",
        "/proc/1/environ",
        "/root/.bashrc",
        "/home",
        "/tmp",
        "/var/lib",
        str(Path(corollary.__file__).parent / "formula" / "value.py"),
        str(Path(corollary.__file__).parents[2] / "solutions"),
        str(Path(__file__)),
    ],
)
def test_files_outside_cannot_be_read(run: Run, path: str) -> None:
    taken = run(
        f"import os\na = len(os.listdir({path!r}) if os.path.isdir({path!r}) else open({path!r}).read())"
    )
    assert statuses(taken) == ["error"]
    assert taken.values["a"] == Nothing()


@pytest.mark.parametrize(
    "source",
    [
        "import corollary",
        "from corollary.sandbox.worker import encode",
        "import sys, os\nfor p in list(sys.path): open(os.path.join(p, 'corollary', '__init__.py'))",
    ],
)
def test_the_course_cannot_be_imported(run: Run, source: str) -> None:
    assert statuses(run(source)) == ["error"]


def test_the_environment_holds_no_secret(run: Run) -> None:
    taken = run("import os\na = ' '.join(os.environ.values())\nfor v in os.environb.values(): print(v)")
    assert os.environ["COURSE_SECRET"] not in said(taken) + str(taken.values)


def test_memory_of_the_zygote_holds_no_earlier_notebook(run: Run) -> None:
    mark = "GROUSE-71-LANTERN"
    run(f"note = '{mark}'")
    half, other = mark[:9], mark[9:]
    source = (
        f"import gc\nwanted = '{half}' + '{other}'\n"
        "a = sum(wanted in each for each in gc.get_objects() if type(each) is str) + sum(wanted in str(v) "
        "for each in gc.get_objects() if type(each) is dict for v in list(each.values()) if type(v) is str "
        "and v is not wanted)"
    )
    assert run(source).values["a"] == Exact(Fraction(0))


@pytest.mark.parametrize(
    "source",
    [
        "import socket; socket.create_connection(('1.1.1.1', 53), 1)",
        "import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.sendto(b'x', ('127.0.0.1', 9))",
        "import socket; s = socket.socket(socket.AF_UNIX); s.connect('/run/dbus/system_bus_socket')",
        "import urllib.request; urllib.request.urlopen('http://127.0.0.1/', timeout=1)",
    ],
)
def test_there_is_no_network(run: Run, source: str) -> None:
    assert statuses(run(source)) == ["error"]


def test_seccomp_refuses_what_another_layer_would_refuse_too(run: Run) -> None:
    """By its own error: without a network namespace, a scope for signals or a mount, the same calls must still fail."""
    taken = run(
        "import ctypes, errno, fcntl, os, socket",
        "libc = ctypes.CDLL(None, use_errno=True)\na, b = socket.socketpair()\nrefused = []\n"
        "def attempt(*call):\n"
        "    ctypes.set_errno(0)\n"
        "    refused.append(call[0](*call[1:]) == -1 and ctypes.get_errno() == errno.EPERM)",
        "attempt(libc.socket, 1, 1, 0)\nattempt(libc.socket, 2, 2, 0)\nattempt(libc.connect, a.fileno(), b'\\1\\0x', 4)",
        "attempt(libc.bind, a.fileno(), b'\\1\\0x', 4)\nattempt(libc.listen, a.fileno(), 1)\n"
        "attempt(libc.sendto, a.fileno(), b'x', 1, 0, b'\\1\\0x', 4)",
        "for command in (fcntl.F_SETOWN, 10, 15): attempt(libc.fcntl, a.fileno(), command, os.getpid())",
        "attempt(libc.prctl, 4, 1, 0, 0, 0)\nattempt(libc.ptrace, 16, os.getppid(), 0, 0)\nattempt(libc.unshare, 0)",
        "a = str(refused); b = len(refused)",
    )
    assert statuses(taken) == ["ok"] * 7
    assert taken.values["a"] == Text(str([True] * 12))


def test_a_worker_cannot_be_looked_into() -> None:
    """PR_GET_DUMPABLE is 0, so no process of the same user may open its memory or trace it; asked without seccomp."""
    with Runner(without=frozenset({"seccomp"})) as running:
        source = "import ctypes\na = ctypes.CDLL(None).prctl(3, 0, 0, 0, 0)"
        assert running.execute(Job((Cell("c", source),), ("a",))).values["a"] == Exact(Fraction(0))


@pytest.mark.parametrize("without", [(), ("namespaces",), ("Landlock",)], ids=" ".join)
def test_nothing_tells_where_the_course_is_installed(without: tuple[str, ...]) -> None:
    """An editable installation writes the path of its source into .pth files, finders and direct_url.json."""
    source = (
        "import os, sys\na = ''\n"
        "for folder in [each for each in sys.path if os.path.isdir(each)]:\n"
        "    for name in os.listdir(folder):\n"
        "        path = os.path.join(folder, name)\n"
        "        if 'corollary' not in name and not name.endswith('.pth'): continue\n"
        "        for inner in [path, *(os.path.join(w, f) for w, _, files in os.walk(path) for f in files)]:\n"
        "            try: a += open(inner, errors='replace').read()\n"
        "            except OSError: pass"
    )
    with Runner(without=frozenset(without)) as running:
        taken = running.execute(Job((Cell("c", source),), ("a",)))
    assert statuses(taken) == ["ok"]
    assert taken.values["a"] == Text("")


@pytest.mark.parametrize(
    "source",
    [
        "import ctypes, os\nassert ctypes.CDLL(None, use_errno=True).ptrace(16, os.getppid(), 0, 0) == 0",
        "import ctypes\nassert ctypes.CDLL(None).unshare(0x10000000) == 0",
        "import ctypes\nassert ctypes.CDLL(None).mount(b'x', b'/sandbox', b'tmpfs', 0, None) == 0",
        "import os; os.setuid(0); assert os.getuid() == 0; open('/etc/shadow')",
        "import os; os.mknod('null', 0o20666, os.makedev(1, 3))",
        "import os; os.symlink('/etc/passwd', 'p'); open('p').read()",
        "import os; os.link('/dev/null', 'p')",
        "import os\nfor p in {1, os.getppid()} - {os.getpid(), 0}: open(f'/proc/{p}/mem', 'rb')\n1 / (os.getpid() - 1)",
        "import os; open('/proc/self/mem', 'rb')",
        "open('/sandbox/elsewhere', 'w') if __import__('os').path.isdir('/sandbox') else open('/tmp/elsewhere', 'w')",
        "import numpy; open(numpy.__file__, 'a')",
    ],
)
def test_no_power_is_left(run: Run, source: str) -> None:
    assert statuses(run(source)) == ["error"]
