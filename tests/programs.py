"""The programs of the system that a test may call without a marker: git, make, bash, Python and what every Debian has."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest

PROGRAMS = ("bash", "cat", "chmod", "cp", "env", "false", "git", "ls", "make", "mkdir", "mv", "rm", "sed", "sh", "sleep", "touch", "true", "uname")  # fmt: skip
PYTHON = ("python3",)
MARKED = ("whole", "browser", "client", "term", "fast")
FOLDER = "COROLLARY_TEST_PROGRAMS"


def make_folder(folder: Path) -> None:
    """Fill a folder with links to the programs, and Python as a script: through a link it would look for its library here."""
    folder.chmod(0o755)  # some tests run as an ordinary user
    for name in PROGRAMS:
        if found := shutil.which(name):
            (folder / name).symlink_to(os.path.realpath(found) if name != "sh" else found)
    python = folder / PYTHON[0]
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    python.chmod(0o755)


def path_for(item: pytest.Item) -> str | None:
    """The search path of a test: None, for the machine's own, where a marker says that it may need more."""
    return None if any(item.get_closest_marker(each) for each in MARKED) else os.environ[FOLDER]
