"""Grading measured against `nbgrader autograde`: the same notebooks, in the same run, in turns; and killed in between.

python benchmarks/grading.py [--notebooks 30] [--rounds 3] [--json]      speed
python benchmarks/grading.py --kill [--submissions 1000] [--kills 1]     a kill in between (killed.py)
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import cycle
from pathlib import Path
from typing import Any

import nbformat
from IPython.core.interactiveshell import InteractiveShell
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from rich.console import Console
from rich.table import Table

from corollary.deliver.executing import cores
from corollary.submission.job import Cell, Job
from corollary.submission.notebook import Notebook, read_notebook
from corollary.submission.take import Runner

BIN = Path(sys.executable).parent
NAME = "ps1"
WORK = (  # the answers a to e, one of them shown as a figure
    "import numpy as np\nm, v, dt = 0.43, {v}, 0.1\na = m * v",
    "t = np.linspace(0, dt, 200)\nforce = a / dt * np.pi / 2 * np.sin(np.pi * t / dt)\nb = float(np.trapezoid(force, t))",
    "def step(x, u, h):\n    return x + u * h, u - 9.81 * h\nx, u = 1.0, 0.0\nwhile x > 0:\n    x, u = step(x, u, 1e-4)\nc = u",
    "d = float(np.linalg.solve(np.array([[2.0, 1.0], [1.0, 3.0]]), np.array([a, b]))[0])",
    "import matplotlib.pyplot as plt\nplt.plot(t, force, label='force')\nplt.xlabel('t / s')\nplt.ylabel('F / N')\nplt.title('The kick')\n"
    "plt.legend()\nplt.show()",
)
TEST = "assert abs(a - 0.43 * v) < 1e-9\nassert abs(b - a) < 1e-3\nassert abs(c + (2 * 9.81) ** 0.5) < 0.01"
NAMES = ("a", "b", "c", "d")


def course(folder: Path, count: int) -> list[Path]:
    """A plain nbgrader course with this many submissions of six code cells; nothing in it is ours."""
    folder.mkdir(parents=True)
    (folder / "nbgrader_config.py").write_text(f"c = get_config()\nc.CourseDirectory.course_id = 'plain'\nc.CourseDirectory.root = {str(folder)!r}\n")
    source = folder / "source" / NAME / f"{NAME}.ipynb"
    source.parent.mkdir(parents=True)
    nbformat.write(_notebook(20.0), source)
    _nbgrader(folder, "generate_assignment", NAME)
    papers = []
    for number in range(count):
        paper = folder / "submitted" / f"s{number:03}" / NAME / f"{NAME}.ipynb"
        paper.parent.mkdir(parents=True)
        released = nbformat.read(folder / "release" / NAME / f"{NAME}.ipynb", as_version=4)
        answers = _notebook(10.0 + number)
        for cell, theirs in zip(released.cells, answers.cells, strict=True):
            cell.source = theirs.source
        nbformat.write(released, paper)
        papers.append(paper)
    return papers


def _notebook(v: float) -> nbformat.NotebookNode:
    cells = [new_markdown_cell("A football is kicked.")]
    for number, source in enumerate(WORK):
        mark = {"grade": False, "solution": True, "locked": False, "task": False, "grade_id": f"work{number}", "schema_version": 3}
        cells.append(new_code_cell(source.replace("{v}", repr(v)), metadata={"nbgrader": mark}))
    test = {"grade": True, "solution": False, "locked": True, "task": False, "grade_id": "test", "points": 3, "schema_version": 3}
    cells.append(new_code_cell(TEST, metadata={"nbgrader": test}))
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return new_notebook(cells=cells, metadata=kernel)


def _nbgrader(folder: Path, *words: str) -> None:
    environment = os.environ | {"PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run([str(BIN / "nbgrader"), *words], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"nbgrader {' '.join(words)} failed:\n{done.stderr[-2000:]}")


def autograde(folder: Path, papers: list[Path]) -> None:
    """These ten students' notebooks, by nbgrader's own command."""
    _nbgrader(folder, "autograde", NAME, "--force", f"--student={papers[0].parent.parent.name[:-1]}*")


def ours(runner: Runner, paper: Path, place: Path, pictures: bool) -> None:
    """One notebook our way: read, run behind the walls, answers held against the truth outside, written with its outputs."""
    read = read_notebook(paper)
    assert isinstance(read, Notebook)
    code = [cell for cell in read.node.cells if cell.cell_type == "code"]
    taken = runner.take(Job(tuple(Cell(cell.id, cell.source) for cell in code), NAMES, pictures=pictures))
    assert not taken.trouble, taken.trouble
    assert [run.status for run in taken.cells] == ["ok"] * len(code), taken.cells
    assert len(taken.figures) == 1
    assert (taken.figures[0].png is not None) == pictures
    for cell, run in zip(code, taken.cells, strict=True):
        cell.outputs = [nbformat.from_dict(dict(each)) for each in run.outputs]
    target = place / paper.parent.parent.name / f"{NAME}.ipynb"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(nbformat.writes(read.node))


def warm(shell: InteractiveShell, paper: Path, pictures: bool) -> float:
    """The floor: seconds the cells take in a warm IPython without any walls, kernel or judge."""
    import io

    import matplotlib.pyplot as plt

    sources = [cell.source for cell in nbformat.read(paper, as_version=4).cells if cell.cell_type == "code"]
    shell.reset(new_session=False)
    start = time.perf_counter()
    for source in sources:
        shell.run_cell(source, store_history=False, silent=True)
    if pictures:
        plt.gcf().savefig(io.BytesIO(), format="png", dpi=72)
    plt.close("all")
    return time.perf_counter() - start


def speed(folder: Path, count: int, rounds: int) -> dict[str, Any]:
    """All ways in turns, round after round, over the same notebooks; medians per notebook of the rounds, in milliseconds."""
    import matplotlib as mpl

    mpl.use("agg")
    share = 10
    papers = course(folder / "plain", max(share, count // share * share))
    groups = cycle([papers[at : at + share] for at in range(0, len(papers), share)])
    shell = InteractiveShell.instance()
    workers = cores()
    found: dict[str, list[float]] = {}

    def note(way: str, each: int, work: Callable[[], object]) -> None:
        start = time.perf_counter()
        work()
        found.setdefault(way, []).append((time.perf_counter() - start) / each * 1000)

    started = time.perf_counter()
    runners = [Runner().__enter__() for _ in range(workers)]
    warmed = time.perf_counter() - started
    try:
        warm(shell, papers[0], True)
        for _ in range(rounds):
            group = next(groups)
            note("nbgrader autograde", share, lambda group=group: autograde(folder / "plain", group))
            for pictures, label in ((False, "data"), (True, "PNG")):
                note(f"ours, {workers} cores, {label}", share, lambda group=group, pictures=pictures: _all(runners, group, folder / "ours", pictures))
                for paper in group:  # one beside the other, so that the machine's mood is the same for both
                    found.setdefault(f"cells in a warm process, {label}", []).append(warm(shell, paper, pictures) * 1000)
                    note(f"ours, 1 core, {label}", 1, lambda paper=paper, pictures=pictures: ours(runners[0], paper, folder / "ours", pictures))
        memory = _memory(runners[0])
        isolation = runners[0].isolation.line
    finally:
        for runner in runners:
            runner.__exit__(None, None, None)
    medians = {way: statistics.median(times) for way, times in found.items()}
    stock = medians["nbgrader autograde"]
    return {
        "notebooks": len(papers), "rounds": rounds, "cores": workers, "isolation": isolation, "seconds to warm all runners": round(warmed, 2),
        "ms per notebook": {way: round(value, 1) for way, value in medians.items()},
        "least ms": {way: round(min(times), 1) for way, times in found.items()},
        "times faster than nbgrader": {way: round(stock / value, 1) for way, value in medians.items() if way.startswith("ours")},
        "times the cells themselves": {
            label: round(medians[f"ours, 1 core, {label}"] / medians[f"cells in a warm process, {label}"], 2) for label in ("data", "PNG")
        },
        **memory,
    }  # fmt: skip


def _all(runners: list[Runner], papers: list[Path], place: Path, pictures: bool) -> None:
    with ThreadPoolExecutor(len(runners)) as pool:
        waiting = iter(papers)  # shared: each thread takes the next one, with its own runner

        def work(runner: Runner) -> None:
            for paper in waiting:
                ours(runner, paper, place, pictures)

        for each in [pool.submit(work, runner) for runner in runners]:
            each.result()


def _memory(runner: Runner) -> dict[str, float]:
    """What one child takes of its own: the pages it was the first to touch, or had to copy, in its whole life."""
    source = "import resource\npages = resource.getrusage(resource.RUSAGE_SELF).ru_minflt"
    found = {}
    for label, pictures in (("data", False), ("PNG", True)):
        cells = (*(work.replace("{v}", "20.0") for work in WORK), source)
        taken = runner.take(Job(tuple(Cell(f"c{at}", cell) for at, cell in enumerate(cells)), ("pages",), pictures=pictures))
        pages = taken.values["pages"]
        found[f"MB of its own per child, {label}"] = round(float(getattr(pages, "value", 0)) * os.sysconf("SC_PAGE_SIZE") / 2**20, 1)
    return {"MB warm parent": round(runner.kilobytes / 1024, 1), **found}


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--notebooks", type=int, default=30)
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--kill", action="store_true")
    options.add_argument("--submissions", type=int, default=1000)
    options.add_argument("--kills", type=int, default=1)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--json", action="store_true")
    chosen = options.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="grading-"))
    try:
        if chosen.kill:
            from killed import killed

            found = killed(folder, chosen.submissions, chosen.kills, chosen.seed)
        else:
            found = speed(folder, chosen.notebooks, chosen.rounds)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    if chosen.json:
        print(json.dumps(found, indent=1))
    else:
        _show(found)


def _show(found: dict[str, Any]) -> None:
    table = Table("what", "found", title="Grading, measured", title_justify="left")
    for what, value in found.items():
        table.add_row(what, "\n".join(f"{name}: {each}" for name, each in value.items()) if isinstance(value, dict) else str(value))
    Console().print(table)


if __name__ == "__main__":
    main()
