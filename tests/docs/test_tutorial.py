"""The tutorials, run as they stand: every block in its order, in an empty folder, with what it promises to see."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nbgrader")

TUTORIALS = Path(__file__).parents[2] / "docs" / "tutorial"
BLOCK = re.compile(r"^```(bash|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def squeezed(text: str) -> str:
    return " ".join(text.split())


def counts(work: Path, of: str, course: str, problem: str) -> dict[str, Any]:
    """The verdicts of a problem's parts, as `corollary report` counts them."""
    command = ["corollary", "report", of, "--course", course, "--json"]
    report = subprocess.run(
        command, cwd=work, env=environment(work), capture_output=True, text=True, check=True
    )
    return {
        part["part"]: part["counts"] for part in json.loads(report.stdout)["parts"] if problem in str(part)
    }


def environment(work: Path) -> dict[str, str]:
    found = {name: value for name, value in os.environ.items() if not name.startswith("COROLLARY_")}
    return found | {
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "XDG_CACHE_HOME": str(work.parent / "cache"),
    }


def run(page: Path, work: Path) -> None:
    """Each `bash` block; what the `text` block behind it shows must have been printed."""
    work.mkdir()
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    assert [kind for kind, _ in blocks].count("bash") >= 5
    printed = ""
    for kind, text in blocks:
        if kind == "text":
            for line in text.splitlines():
                assert squeezed(line) in squeezed(printed), line
            continue
        done = subprocess.run(
            ["bash", "-euc", text],
            cwd=work,
            env=environment(work),
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, f"{text}\n{done.stdout}\n{done.stderr}"
        printed = done.stdout


@pytest.mark.whole
def test_from_nothing_to_a_marked_problem(tmp_path: Path):
    run(TUTORIALS / "first_problem.md", tmp_path / "work")
    parts = counts(tmp_path / "work", "week_1", "my_course", "Q1")
    assert parts["a"]["right"] == 1, "a formula for a quantity"
    assert parts["b"]["mistaken"] == 1
    assert parts["c"]["right"] == 1


@pytest.mark.whole
def test_from_a_roster_to_marks(tmp_path: Path):
    work = tmp_path / "work"
    run(TUTORIALS / "first_course.md", work)
    parts = counts(work, "week_1", "mechanics", "X12.5")
    assert parts["a"]["right"] == 1
    assert parts["b"]["slip"] == 1, "twice as much"
    assert counts(work, "week_1", "mechanics", "X12.4")["a"]["right"] == 1
    assert (work / "mechanics" / "feedback" / "ada" / "week_1" / "week_1.html").is_file()
    assert (work / "mechanics" / "reports" / "week_1.html").is_file()


def test_every_tutorial_is_run():
    run_elsewhere = {"library.md"}  # test_library
    assert {path.name for path in TUTORIALS.glob("*.md")} == {
        "first_course.md",
        "first_problem.md",
    } | run_elsewhere
