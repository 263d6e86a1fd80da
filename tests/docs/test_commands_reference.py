"""The page of commands is that of the code as it is now, and names every option of every command."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]


def test_the_page_is_up_to_date():
    done = subprocess.run([sys.executable, TOP / ".ci" / "commands_reference.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/commands_reference.py writes it anew"


@pytest.mark.parametrize("command", ["show", "verify", "grade", "export"])
def test_every_option_that_help_prints_is_there(command: str):
    asked = [sys.executable, "-m", "corollary", command, "--help"]
    printed = subprocess.run(asked, check=True, capture_output=True, text=True).stdout
    section = (
        (TOP / "docs" / "reference" / "commands.md")
        .read_text(encoding="utf-8")
        .partition(f"\n## {command}\n")[2]
    )
    section = section.partition("\n## ")[0]
    options = set(re.findall(r"--[a-z-]+", printed)) - {"--help"}
    assert options
    assert options <= set(re.findall(r"--[a-z-]+", section))
