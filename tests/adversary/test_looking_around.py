"""Hostile notebooks that look where they must not: files, the course, other notebooks, the network."""

from __future__ import annotations

import os
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest

import corollary
from corollary.formula.value import Exact, Nothing
from corollary.sandbox.result import ExecutionResult

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


def test_memory_of_the_warm_parent_holds_no_earlier_notebook(run: Run) -> None:
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
        "open('/sandbox/elsewhere', 'w') if __import__('os').path.isdir('/sandbox') else open('/tmp/elsewhere', 'w')",
        "import numpy; open(numpy.__file__, 'a')",
    ],
)
def test_no_power_is_left(run: Run, source: str) -> None:
    assert statuses(run(source)) == ["error"]
