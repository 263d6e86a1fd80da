"""How commands end."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from importlib import import_module
from pathlib import Path

import pytest

from corollary.cli.ending import RAISED, expected


def test_ctrl_c_ends_a_command_with_130(tmp_path: Path) -> None:
    """A command that is at work (it has said so by making a file) is stopped, says so, and leaves no traceback."""
    begun = tmp_path / "begun"
    program = f"""
import pathlib, signal, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job, such as a gate, ignores it
from corollary.cli import listing
def run(**options):
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
