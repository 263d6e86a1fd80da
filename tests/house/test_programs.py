"""What `make test` selects calls no program that git, make, bash, Python and a bare Debian do not bring."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest

ALLOWED = {
    "bash", "cat", "chmod", "cp", "env", "false", "git", "ls", "make", "mkdir", "mv", "python3", "rm", "sed", "sh", "sleep", "touch",
    "true", "uname",
}  # fmt: skip
OTHERS = ("node", "npm", "chromium", "pdftotext", "gcc", "curl", "unzip", "php", "ruby", "coqc", "useradd")


def test_nothing_else_is_found() -> None:
    (folder,) = os.environ["PATH"].split(os.pathsep)
    assert set(os.listdir(folder)) <= ALLOWED
    assert not [each for each in OTHERS if shutil.which(each)]


@pytest.mark.parametrize("program", ["git", "make", "bash", "python3"])
def test_what_is_promised_works(program: str) -> None:
    done = subprocess.run([program, "--version"], capture_output=True, check=True, text=True)
    assert done.stdout


def test_nor_by_a_process_that_a_test_starts() -> None:
    line = f"import shutil; print([each for each in {OTHERS!r} if shutil.which(each)])"
    done = subprocess.run([sys.executable, "-c", line], capture_output=True, check=True, text=True)
    assert done.stdout.strip() == "[]"
