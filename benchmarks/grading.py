"""Grading measured against `nbgrader autograde`: the same notebooks, in the same run, in turns; and killed in between.

python benchmarks/grading.py [--notebooks 30] [--rounds 2] [--json]      speed; with --otter .../bin/otter also Otter's
python benchmarks/grading.py --kill [--submissions 1000] [--kills 5]     kills in between (killed.py)
"""

from __future__ import annotations

import argparse
import io
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import nbformat
import otter as others
from IPython.core.interactiveshell import InteractiveShell
from killed import killed
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from rich.console import Console
from rich.table import Table

from corollary.formula.value import Exact, Real, Value
from corollary.parallel import cores
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.notebook_file import Notebook, notebook_of
from corollary.sandbox.runner import Runner

BIN = Path(sys.executable).parent
NAME = "ps1"
WORK = (  # the answers a to e, one of them shown as a figure
    "import numpy as np\nm, v, dt = 0.43, {v}, 0.1\na = m * v",
    "t = np.linspace(0, dt, 200)\nforce = a / dt * np.pi / 2 * np.sin(np.pi * t / dt)\nb = float(np.trapezoid(force, t))",
    "def step(x, u, h):\n    return x + u * h, u - 9.81 * h\nx, u = 1.0, 0.0\nwhile x > 0:\n    x, u = step(x, u, 1e-4)\nc = u",
    "d = float(np.linalg.solve(np.array([[2.0, 1.0], [1.0, 3.0]]), np.array([a, b]))[0])",
    "import matplotlib.pyplot as plt\nplt.plot(t, force, label='force')\nplt.xlabel('t / s')\nplt.ylabel('F / N')\n"
    "plt.title('The kick')\nplt.legend()\nplt.show()",
)
TEST = "assert abs(a - 0.43 * v) < 1e-9\nassert abs(b - a) < 1e-3\nassert abs(c + (2 * 9.81) ** 0.5) < 0.01"
NAMES = ("a", "b", "c", "d")


def course(folder: Path, count: int) -> list[Path]:
    """A plain nbgrader course with this many submissions of six code cells; nothing in it is ours."""
    folder.mkdir(parents=True)
    config = (
        f"c = get_config()\nc.CourseDirectory.course_id = 'plain'\nc.CourseDirectory.root = {str(folder)!r}\n"
    )
    (folder / "nbgrader_config.py").write_text(config)
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
        mark = {
            "grade": False,
            "solution": True,
            "locked": False,
            "task": False,
            "grade_id": f"work{number}",
            "schema_version": 3,
        }
        cells.append(new_code_cell(source.replace("{v}", repr(v)), metadata={"nbgrader": mark}))
    test = {
        "grade": True,
        "solution": False,
        "locked": True,
        "task": False,
        "grade_id": "test",
        "points": 3,
        "schema_version": 3,
    }
    cells.append(new_code_cell(TEST, metadata={"nbgrader": test}))
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return new_notebook(cells=cells, metadata=kernel)


def _nbgrader(folder: Path, *words: str) -> None:
    environment = os.environ | {"PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(
        [str(BIN / "nbgrader"), *words],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise SystemExit(f"nbgrader {' '.join(words)} failed:\n{done.stderr[-2000:]}")


def autograde(folder: Path, students: str) -> float:
    """Seconds nbgrader's own command takes for the students of this pattern."""
    start = time.perf_counter()
    _nbgrader(folder, "autograde", NAME, "--force", f"--student={students}")
    return time.perf_counter() - start


def ours(runner: Runner, paper: Path, place: Path, pictures: bool) -> tuple[float, float]:
    """One notebook our way: read, run behind the walls, answers held against the truth outside, written with its outputs.
    Gives the seconds of all this, and of the run alone."""
    start = time.perf_counter()
    read = notebook_of(paper.read_bytes())
    assert isinstance(read, Notebook)
    code = [cell for cell in read.node.cells if cell.cell_type == "code"]
    began = time.perf_counter()
    taken = runner.execute(Job(tuple(Cell(cell.id, cell.source) for cell in code), NAMES, pictures=pictures))
    walls = time.perf_counter() - began
    assert not taken.trouble, taken.trouble
    assert [run.status for run in taken.cells] == ["ok"] * len(code), taken.cells
    assert len(taken.figures) == 1
    assert (taken.figures[0].png is not None) == pictures
    a, b, c = (_number(taken.values[name]) for name in "abc")
    assert abs(b - a) < 1e-3
    assert abs(c + (2 * 9.81) ** 0.5) < 0.01
    for cell, run in zip(code, taken.cells, strict=True):
        cell.outputs = [nbformat.from_dict(dict(each)) for each in run.outputs]
    target = place / paper.parent.parent.name / f"{NAME}.ipynb"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(nbformat.writes(read.node))
    return time.perf_counter() - start, walls


def _number(value: Value) -> float:
    assert isinstance(value, Real), value
    return value.value


def warm(shell: InteractiveShell, paper: Path, pictures: bool) -> tuple[float, float]:
    """The floor: seconds the cells take in a warm IPython without any walls, kernel or judge; by the clock, and on the processor."""
    sources = [cell.source for cell in nbformat.read(paper, as_version=4).cells if cell.cell_type == "code"]
    shell.reset(new_session=False)
    start, spent = time.perf_counter(), time.process_time()
    for source in sources:
        shell.run_cell(source, store_history=False, silent=True)
    if pictures:
        plt.gcf().savefig(io.BytesIO(), format="png", dpi=72)
    plt.close("all")
    return time.perf_counter() - start, time.process_time() - spent


def processor(runner: Runner, paper: Path) -> float:
    """Seconds on the processor that a child spends from its birth to the end of its cells, walls included."""
    read = notebook_of(paper.read_bytes())
    assert isinstance(read, Notebook)
    cells = [Cell(cell.id, cell.source) for cell in read.node.cells if cell.cell_type == "code"]
    cells.append(Cell("spent", "import time\nspent = time.process_time()"))
    return _number(runner.execute(Job(tuple(cells), ("spent",), pictures=False)).values["spent"])


def speed(folder: Path, count: int, rounds: int, otter: Path | None) -> dict[str, Any]:
    """All ways in turns, round after round, over the same notebooks; medians of milliseconds per notebook.

    A command's start counts apart: nbgrader's from a run over one notebook, ours as the time until every runner is warm.
    """
    mpl.use("agg")
    papers = course(folder / "plain", count)
    shell = InteractiveShell.instance()
    found: dict[str, list[float]] = {}
    whole: dict[str, list[float]] = {}

    def note(way: str, each: int, seconds: float) -> None:
        found.setdefault(way, []).append(seconds / each * 1000)

    warm(shell, papers[0], True)
    memory: dict[str, Any] = {}
    for _ in range(rounds):
        one, all_of_them = autograde(folder / "plain", "s000"), autograde(folder / "plain", "s*")
        note("nbgrader autograde", count - 1, all_of_them - one)
        whole.setdefault("nbgrader autograde", []).append(all_of_them)
        if otter is not None:
            autograder = others.prepare(otter, Path(tempfile.mkdtemp(dir=folder)))
            for paper in papers[:5]:
                note("otter run", 1, others.grade(otter, autograder, paper))
        start = time.perf_counter()
        with ExitStack() as stack:
            runners = [Runner() for _ in range(cores())]
            with ThreadPoolExecutor(len(runners)) as pool:
                for each in pool.map(stack.enter_context, runners):
                    assert each.isolation.level
            started = time.perf_counter() - start
            for pictures, label in ((False, "data"), (True, "PNG")):
                seconds = _all(runners, papers, folder / "ours", pictures)
                note(f"{len(runners)} runners, {label}", count, seconds)
                whole.setdefault(f"{len(runners)} runners, {label}", []).append(started + seconds)
                for (
                    paper
                ) in papers:  # one right after the other, so that the machine's mood is the same for all
                    if not pictures:
                        note("cells behind the walls, on the processor", 1, processor(runners[0], paper))
                    seconds, spent = warm(
                        shell, paper, pictures
                    )  # meanwhile the next child gets ready, as it does while one is judged
                    note(f"cells in a warm process, {label}", 1, seconds)
                    if not pictures:
                        note("cells in a warm process, on the processor", 1, spent)
                    seconds, walls = ours(runners[0], paper, folder / "ours", pictures)
                    note(f"1 runner, {label}", 1, seconds)
                    note(f"cells behind the walls, {label}", 1, walls)
            memory = _memory(runners[0]) | {"isolation": runners[0].isolation.line}
    medians = {way: statistics.median(times) for way, times in found.items()}
    entire = {way: statistics.median(times) for way, times in whole.items()}
    return {
        "notebooks": count,
        "rounds": rounds,
        "cores": cores(),
        **memory,
        "ms per notebook, after the start": {way: round(value, 1) for way, value in medians.items()},
        "times faster than nbgrader, after the start": {
            way: round(medians["nbgrader autograde"] / value, 1)
            for way, value in medians.items()
            if "runner" in way
        },
        "seconds in all, with the start": {way: round(value, 1) for way, value in entire.items()},
        "times faster than nbgrader, with the start": {
            way: round(entire["nbgrader autograde"] / value, 1)
            for way, value in entire.items()
            if "runner" in way
        },
        "times the cells themselves": {
            label: round(
                medians[f"cells behind the walls, {label}"] / medians[f"cells in a warm process, {label}"], 2
            )
            for label in ("data", "PNG", "on the processor")
        },
    }


def _all(runners: list[Runner], papers: list[Path], place: Path, pictures: bool) -> float:
    """Seconds for all of them, each runner taking the next one that is left."""
    waiting: SimpleQueue[Path] = SimpleQueue()
    for paper in papers:
        waiting.put(paper)

    def work(runner: Runner) -> None:
        while True:
            try:
                paper = waiting.get_nowait()
            except Empty:
                return
            ours(runner, paper, place, pictures)

    start = time.perf_counter()
    with ThreadPoolExecutor(len(runners)) as pool:
        for each in [pool.submit(work, runner) for runner in runners]:
            each.result()
    return time.perf_counter() - start


def _memory(runner: Runner) -> dict[str, float]:
    """What one child takes of its own: the pages it was the first to touch, or had to copy, in its whole life."""
    source = "import resource\npages = resource.getrusage(resource.RUSAGE_SELF).ru_minflt"
    found = {}
    for label, pictures in (("data", False), ("PNG", True)):
        cells = (*(work.replace("{v}", "20.0") for work in WORK), source)
        taken = runner.execute(
            Job(tuple(Cell(f"c{at}", cell) for at, cell in enumerate(cells)), ("pages",), pictures=pictures)
        )
        pages = taken.values["pages"]
        assert isinstance(pages, Exact), pages
        found[f"MB of its own per child, {label}"] = round(
            float(pages.value) * os.sysconf("SC_PAGE_SIZE") / 2**20, 1
        )
    return {"MB warm parent": round(runner.kilobytes / 1024, 1), **found}


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--notebooks", type=int, default=30)
    options.add_argument("--rounds", type=int, default=2)
    options.add_argument("--kill", action="store_true")
    options.add_argument("--submissions", type=int, default=1000)
    options.add_argument("--kills", type=int, default=5)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument(
        "--otter",
        type=Path,
        help="The program otter, of an environment of its own with ipykernel, numpy and matplotlib.",
    )
    options.add_argument("--json", action="store_true")
    chosen = options.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="grading-"))
    try:
        kill, race = (
            (folder, chosen.submissions, chosen.kills, chosen.seed),
            (folder, chosen.notebooks, chosen.rounds, chosen.otter),
        )
        found = killed(*kill) if chosen.kill else speed(*race)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    if chosen.json:
        print(json.dumps(found, indent=1))
    else:
        _show(found)


def _show(found: dict[str, Any]) -> None:
    table = Table("what", "found", title="Grading, measured", title_justify="left")
    for what, value in found.items():
        table.add_row(
            what,
            "\n".join(f"{name}: {each}" for name, each in value.items())
            if isinstance(value, dict)
            else str(value),
        )
    Console().print(table)


if __name__ == "__main__":
    main()
