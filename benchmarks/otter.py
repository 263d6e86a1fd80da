"""Otter-Grader on the same notebooks, by its command without containers, where it is installed somewhere."""

from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path

import nbformat

TEST = """OK_FORMAT = True
test = {"name": "q1", "points": 3, "suites": [{"type": "doctest", "cases": [
    {"code": ">>> abs(b - a) < 1e-3\\nTrue", "hidden": False, "locked": False},
    {"code": ">>> abs(c + (2 * 9.81) ** 0.5) < 0.01\\nTrue", "hidden": False, "locked": False}]}]}
"""


def prepare(command: Path, folder: Path) -> Path:
    """The autograder for the notebooks of `grading.py`; `command` is the program `otter`, which needs its environment's ipykernel."""
    (folder / "tests").mkdir(parents=True)
    (folder / "tests" / "q1.py").write_text(TEST)
    _call(command, folder, "generate", "-t", "tests", "-o", "autograder.zip", "--no-environment")
    return folder / "autograder.zip"


def grade(command: Path, autograder: Path, paper: Path) -> float:
    """Seconds for one submission, which must earn full marks."""
    folder = autograder.parent
    nb = nbformat.read(paper, as_version=4)
    for cell in nb.cells:
        cell.metadata = {}
    nb.cells.pop()  # nbgrader's test
    nbformat.write(nb, folder / "paper.ipynb")
    start = time.perf_counter()
    _call(
        command,
        folder,
        "run",
        "--no-logo",
        "-a",
        str(autograder),
        "-o",
        str(folder),
        str(folder / "paper.ipynb"),
    )
    seconds = time.perf_counter() - start
    scores = [
        each["score"]
        for each in json.loads((folder / "results.json").read_text())["tests"]
        if "score" in each
    ]
    assert scores == [3.0], scores
    return seconds


def _call(command: Path, folder: Path, *words: str) -> None:
    environment = {"PATH": f"{command.parent}:/usr/bin:/bin", "HOME": str(folder)}
    done = subprocess.run(
        [str(command), *words], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise SystemExit(f"otter {' '.join(words)} failed:\n{done.stderr[-2000:]}")
