"""The tutorial for authors, run as it stands: every block in its order, in an empty folder, with what it promises to see."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

PAGE = Path(__file__).parents[2] / "docs" / "author.md"
BLOCK = re.compile(r"^```(bash|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def squeezed(text: str) -> str:
    return " ".join(text.split())


@pytest.mark.whole
def test_from_nothing_to_marked(tmp_path):
    section = PAGE.read_text(encoding="utf-8").partition("## Ten minutes")[2].partition("\n## ")[0]
    blocks = BLOCK.findall(section)
    assert [kind for kind, _ in blocks].count("bash") >= 5
    environment = {name: value for name, value in os.environ.items() if not name.startswith("COROLLARY_")}
    environment |= {
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "XDG_CACHE_HOME": str(tmp_path / "cache"),
    }
    work = tmp_path / "work"
    work.mkdir()
    seen = ""
    for kind, text in blocks:
        if kind == "text":
            for line in text.splitlines():
                assert squeezed(line) in squeezed(seen), line
            continue
        done = subprocess.run(
            ["bash", "-euc", text], cwd=work, env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{text}\n{done.stdout}\n{done.stderr}"
        seen = done.stdout
    command = ["corollary", "report", "week_1", "--course", "my_course", "--json"]
    report = subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True, check=True)
    parts = {part["part"]: part["counts"] for part in json.loads(report.stdout)["parts"] if "Q1" in str(part)}
    assert parts["a"]["right"] == 1, "a formula for a quantity"
    assert parts["b"]["mistaken"] == 1
    assert parts["c"]["right"] == 1
