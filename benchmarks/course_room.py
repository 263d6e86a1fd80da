"""Room and time of a class from `generate` to `feedback-zip`: kilobytes a student by folder, seconds, memory, and what the cells alone take.

python benchmarks/course_room.py [--students 24] [--set momentum_1]    (writes benchmarks/results/course_room.md)

*The cells alone*: the code that grading runs (students' cells, not the checks), cell by cell with `exec` in one process that has numpy,
scipy and matplotlib loaded, each notebook in a namespace of its own, each figure drawn to PNG as Jupyter draws it; no isolation.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import subprocess
import sys
import tempfile
import time
import warnings
import zipfile
from contextlib import redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import nbformat
from matplotlib import pyplot

from corollary.course.demo.players import right_sources
from corollary.grading.solutions import Solutions
from corollary.notebook.locate import code_to_run
from corollary.notebook.notebook import filled_in, notebook
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course

RESULT = Path(__file__).parent / "results" / "course_room.md"


ALONE = 40  # notebooks by which the cells alone are measured


@dataclass(frozen=True, slots=True)
class Spent:
    """What one command took: seconds by the clock, of the processor, and the MB of its largest process."""

    clock: float
    processor: float
    largest: float


def run(base: Path, *words: str) -> Spent:
    """What one command takes, its workers included; not the isolated processes of notebooks, which the system counts for nobody."""
    began = time.perf_counter()
    line = [sys.executable, "-m", "corollary", *words, "--course", "course"]
    with (base / "out.txt").open("wb") as out:
        process = subprocess.Popen(line, cwd=base, stdout=out, stderr=out)
        _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit((base / "out.txt").read_text()[-2000:])
    clock = time.perf_counter() - began
    spent = Spent(clock, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)
    print(*words[:1], spent, f"{room(base / 'course') / 1e6:.0f} MB", file=sys.stderr, flush=True)
    return spent


def cells_alone(notebooks: list[tuple[Worksheet, str]]) -> float:
    """Processor seconds of the cells of these notebooks, in this process."""
    with warnings.catch_warnings(), redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        _run_cells(*notebooks[0])  # what it loads is loaded then
        began = time.process_time()
        for sheet, text in notebooks:
            _run_cells(sheet, text)
        return time.process_time() - began


def _run_cells(sheet: Worksheet, text: str) -> None:
    handed_in, space = nbformat.from_dict(json.loads(text)), dict[str, object]()
    for cell in handed_in.cells:
        cell.source = "".join(cell.source)
    for _, source in code_to_run(handed_in, notebook(sheet)):
        exec(compile(source, "cell", "exec"), space)
        for number in pyplot.get_fignums():
            pyplot.figure(number).savefig(io.BytesIO(), format="png", dpi=72)
        pyplot.close("all")


def room(folder: Path) -> int:
    """Bytes on the disk, in whole blocks."""
    files = [folder] if folder.is_file() else folder.rglob("*")
    return sum(each.lstat().st_blocks * 512 for each in files if each.is_file())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=24)
    parser.add_argument("--set", default="momentum_1")
    options = parser.parse_args()
    name, ids = options.set, [f"s{number:04}" for number in range(options.students)]
    rows = [
        f"# Room and time of a class of {len(ids)}",
        "",
        f"`python benchmarks/course_room.py --students {len(ids)} --set {name}`, everything right, at load {os.getloadavg()[0]:.0f} (at the start) on "
        f"{os.cpu_count()} cores.",
        "",
        "| command | s | processor, s | largest process, MB |",
        "|---|---|---|---|",
    ]
    mpl.use("agg")
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        (base / "roster.csv").write_text(
            "id,first_name,last_name\n" + "".join(f"{each},Ada,{each.upper()}\n" for each in ids)
        )
        took = {"generate": run(base, "generate", name, "--roster", "roster.csv", "--yes")}
        bank, course = chapter_bank(), open_course(base / "course")
        problem_set, solutions = find_set(bank, name), Solutions(bank)
        sheets = read_assigned(course, problem_set)
        sample: list[tuple[Worksheet, str]] = []
        with zipfile.ZipFile(base / "in.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            for number, student in enumerate(ids, 100):
                sheet = worksheet(
                    problem_set, Student(student, "Ada", student.upper()), sheets[student].variants
                )
                keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
                text = filled_in(sheet, right_sources(sheet, keys))
                archive.writestr(f"Ada {student.upper()}_{number}_assignsubmission_file_/{name}.ipynb", text)
                if len(sample) < ALONE:
                    sample.append((sheet, text))
        took["collect"] = run(base, "collect", name, "in.zip")
        collected = room(course.folder)
        took["grade"] = run(base, "grade", name, "--yes")
        took["grade, nothing new"] = run(base, "grade", name, "--yes")
        took["export --to feedback-zip"] = run(base, "export", name, "--to", "feedback-zip", "-o", "out.zip")
        alone = cells_alone(sample) / len(sample) * len(ids)
        folders = ("release", "submitted", "autograded", "feedback", "gradebook.db", ".corollary", "reports")
        inside = ("collected", "released", "pages", "graded", "history")
        rooms = {each: room(course.folder / each) for each in folders}
        rooms |= {f"of these .corollary/{each}": room(course.folder / ".corollary" / each) for each in inside}
        rooms["all, after collect"] = collected
        rooms["all, after grade"] = room(course.folder)
        blocks = sum(each.lstat().st_blocks * 512 for each in course.folder.rglob("*") if each.is_dir())
    rows += [
        f"| `{command}` | {spent.clock:.1f} | {spent.processor:.1f} | {spent.largest:.0f} |"
        for command, spent in took.items()
    ]
    least = (took["grade"].processor + alone) / alone
    rows += [
        "",
        f"The cells alone take {alone:.1f} s of the processor ({alone / len(ids) * 1000:.0f} ms a notebook; measured with {len(sample)}). "
        "The processes in which `grade` runs notebooks are not in its processor time: the system does not count them for the command. "
        f"With what the cells take there, isolation not included, `grade` takes {least:.1f} times the cells.",
        "",
        "| folder | kB a student |",
        "|---|---|",
    ]
    rows += [f"| {each} | {size / 1024 / len(ids):.0f} |" for each, size in rooms.items()]
    rows += ["", f"Folders themselves take another {blocks / 1024 / len(ids):.0f} kB a student."]
    RESULT.write_text("\n".join(rows) + "\n", encoding="utf-8")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
