"""Room and time of a class from `generate` to `grade`: kilobytes a student by folder, seconds by the clock and of the processor.

python benchmarks/course_room.py [--students 24] [--set momentum_1]    (writes benchmarks/results/course_room.md)
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from corollary.course.demo.players import right_sources
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course

RESULT = Path(__file__).parent / "results" / "course_room.md"


def run(base: Path, *words: str) -> tuple[float, float]:
    """Seconds by the clock, and of the processor, of one command."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    line = [sys.executable, "-m", "corollary", *words, "--course", "course"]
    subprocess.run(line, cwd=base, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return time.perf_counter() - began, used


def room(folder: Path) -> int:
    """Bytes on the disk, in whole blocks."""
    return sum(each.lstat().st_blocks * 512 for each in folder.rglob("*") if each.is_file())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=24)
    parser.add_argument("--set", default="momentum_1")
    options = parser.parse_args()
    name, ids = options.set, [f"s{number:04}" for number in range(options.students)]
    rows = [
        f"# Room and time of a class of {len(ids)}",
        "",
        f"`python benchmarks/course_room.py --students {len(ids)} --set {name}`, everything right, at load {os.getloadavg()[0]:.0f} on "
        f"{os.cpu_count()} cores.",
        "",
        "| command | s | processor, s |",
        "|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        (base / "roster.csv").write_text("id\n" + "\n".join(ids) + "\n")
        took = {"generate": run(base, "generate", name, "--roster", "roster.csv", "--yes")}
        bank, course = chapter_bank(), open_course(base / "course")
        problem_set, solutions = find_set(bank, name), Solutions(bank)
        sheets = read_assigned(course, problem_set)
        with zipfile.ZipFile(base / "in.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            for student in ids:
                sheet = worksheet(problem_set, Student(student), sheets[student].variants)
                keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
                archive.writestr(f"{student}/{name}.ipynb", filled_in(sheet, right_sources(sheet, keys)))
        took["collect"] = run(base, "collect", name, "in.zip")
        took["grade"] = run(base, "grade", name, "--yes")
        folders = [
            *("release", "submitted", "autograded", "feedback"),
            *(f".corollary/{each}" for each in ("collected", "pages")),
        ]
        rooms = {each: room(course.folder / each) for each in folders}
        rooms["all"] = room(course.folder)
        took["collect --pack"] = run(base, "collect", name, "--pack")
        rooms["all, packed"] = room(course.folder)
    rows += [f"| `{command}` | {clock:.1f} | {used:.1f} |" for command, (clock, used) in took.items()]
    rows += ["", "| folder | kB a student |", "|---|---|"]
    rows += [f"| {each} | {size / 1024 / len(ids):.0f} |" for each, size in rooms.items()]
    RESULT.write_text("\n".join(rows) + "\n", encoding="utf-8")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
