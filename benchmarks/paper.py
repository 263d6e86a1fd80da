"""How long the sheets and marking schemes of a class take on paper: `python benchmarks/paper.py [--students 200] [--set momentum_1]`.

A course is generated for so many students in a temporary folder, which is not counted; then the print run is timed as
`corollary export SET --to pdf --course …` does it: every sheet, every marking scheme, and all sheets in one file.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COROLLARY = [sys.executable, "-c", "from corollary.cli.main import main; main()"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--students", type=int, default=200)
    parser.add_argument("--set", default="momentum_1")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        roster, course, out = place / "roster.csv", place / "course", place / "paper"
        roster.write_text("id\n" + "".join(f"s{number:04}\n" for number in range(asked.students)))
        _run("generate", asked.set, "--roster", roster, "--course", course)
        before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        _run("export", asked.set, "--to", "pdf", "--course", course, "-o", out)
        seconds, after = time.perf_counter() - started, resource.getrusage(resource.RUSAGE_CHILDREN)
        files = list(out.rglob("*.pdf"))
        size = sum(file.stat().st_size for file in files) / 1e6
        spent = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        print(f"{asked.set}, {asked.students} students: {len(files)} files, {size:.0f} MB")
        print(f"{seconds:.1f} s, of which processors were at work {spent:.1f} s")


def _run(*arguments: object) -> None:
    subprocess.run([*COROLLARY, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
