"""The hostile and clumsy notebooks of tests/adversary at every isolation level that this machine has: what each level withstood.

python benchmarks/adversary.py    (writes benchmarks/results/adversary.md; minutes for each level)
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
RESULT = Path(__file__).parent / "results" / "adversary.md"
FILES = ("test_hostile.py", "test_bent_answers.py", "test_looking_around.py")
LAYERS = (
    "",
    "namespaces",
    "Landlock",
)  # without seccomp too little is promised for the notebooks to be tried
TRIED = "import json,sys\nfrom corollary.sandbox.runner import Runner\nwith Runner(without=frozenset(sys.argv[1:])) as r: print(r.isolation.level, r.isolation.line, sep='|')"


def level(without: str) -> tuple[str, str]:
    """The level that holds without these layers, and the layers in force."""
    command = [sys.executable, "-c", TRIED, *without.split()]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    number, _, line = found.partition("|")
    return number, line


def outcome(without: str) -> tuple[int, list[str]]:
    """How many notebooks were withstood, and the names of the tests of those that were not."""
    tests = [str(ROOT / "tests" / "adversary" / name) for name in FILES]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", *tests],
        cwd=ROOT,
        env={**os.environ, "ADVERSARY_WITHOUT": without},
        capture_output=True,
        text=True,
        check=False,
    )
    passed = re.search(r"(\d+) passed", done.stdout)
    dots = sum(
        line.count(".") for line in done.stdout.splitlines() if re.fullmatch(r"[.FEs]+\s+\[.*\]", line)
    )
    return int(passed[1]) if passed else dots, re.findall(r"^FAILED \S+::(\S+)", done.stdout, re.MULTILINE)


def main() -> None:
    lines = [
        "# Hostile and clumsy notebooks at every isolation level",
        "",
        "`python benchmarks/adversary.py`: each layer left out in turn. Withstood: no answer changed, nobody else harmed, the next notebook runs.",
        "",
        "| left out | level | in force | withstood | not |",
        "|---|---|---|---|---|",
    ]
    for without in LAYERS:
        number, line = level(without)
        passed, failed = outcome(without)
        lines.append(
            f"| {without or 'nothing'} | {number} | {line} | {passed} | {', '.join(failed) or '—'} |"
        )
        print(lines[-1], flush=True)
    RESULT.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
