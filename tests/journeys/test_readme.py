"""Every console block of the README is run, and prints what the README says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]
BLOCKS = re.findall(r"```console\n(.*?)```", (TOP / "README.md").read_text(encoding="utf-8"), re.DOTALL)
PROMPT = re.compile(r"^\$ (?P<command>.*)\n(?P<printed>(?:(?!\$ ).*\n?)*)", re.MULTILINE)
EXAMPLES = [(match["command"], match["printed"]) for block in BLOCKS for match in PROMPT.finditer(block)]


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 4


@pytest.mark.parametrize(("command", "printed"), EXAMPLES, ids=[command[:40] for command, _ in EXAMPLES])
def test_prints_what_the_readme_says(command: str, printed: str) -> None:
    program = str(Path(sys.executable).parent / "corollary")
    assert command.startswith("corollary ")
    done = subprocess.run(
        program + command.removeprefix("corollary"),
        shell=True,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    said = done.stdout.replace("\N{NO-BREAK SPACE}", " ")
    wanted = printed.replace("\N{NO-BREAK SPACE}", " ")
    if "…\n" in wanted:
        assert said.startswith(wanted.partition("…\n")[0]), said
    else:
        assert said == wanted


def test_the_two_commands_are_there() -> None:
    text = (TOP / "README.md").read_text(encoding="utf-8")
    assert "make demo\nmake test\n" in text
    makefile = (TOP / "Makefile").read_text(encoding="utf-8")
    assert re.search(r"^demo:", makefile, re.MULTILINE)
    assert re.search(r"^test:", makefile, re.MULTILINE)
