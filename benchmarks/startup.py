"""What the short commands take once warm: medians of wall clock and processor, each run in a process of its own.

`python benchmarks/startup.py [--runs 15]`, beside the `corollary` of this environment.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

COMMANDS = (
    "--help",
    "list",
    "list --json",
    "key X12.5",
    "read 8,6Ns --unit N*s",
    "show X12.5",
    "scene cradle",
)


def seconds(command: list[str]) -> tuple[float, float]:
    """Wall clock and processor of one run."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--runs", type=int, default=15)
    runs = arguments.parse_args().runs
    program = str(Path(sys.executable).parent / "corollary")
    print("| command | wall clock, s | processor, s |\n|---|---|---|")
    for command in ("python", *COMMANDS):  # Python alone tells how busy the machine is
        words = [sys.executable, "-c", "pass"] if command == "python" else [program, *command.split()]
        seconds(words)  # fills the caches
        found = [seconds(words) for _ in range(runs)]
        wall, processor = (statistics.median(column) for column in zip(*found, strict=True))
        name = "Python alone" if command == "python" else f"`corollary {command}`"
        print(f"| {name} | {wall:.2f} | {processor:.2f} |", flush=True)


if __name__ == "__main__":
    main()
