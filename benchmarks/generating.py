"""How fast a set is generated: notebooks a second on all cores, and what each takes of the processor.

python benchmarks/generating.py --students 1000 [--set momentum_1] [--jobs 2]
"""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from pathlib import Path

from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student


def processor() -> float:
    """Seconds of the processor, of this process and of those that have ended."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=1000)
    parser.add_argument("--set", default="momentum_1")
    parser.add_argument("--jobs", type=int, help="processes; one for each core when left out")
    options = parser.parse_args()
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, options.set), Solutions(bank)
    for problem in problem_set.problems:
        solutions.of(problem)
    roster = [Student(f"s{number:05}") for number in range(options.students)]
    with tempfile.TemporaryDirectory() as folder:
        generate(
            Path(folder, "once"), problem_set, roster[:1], solutions, jobs=1
        )  # nbgrader is loaded by now
        wall, cpu = time.perf_counter(), processor()
        generate(Path(folder, "course"), problem_set, roster, solutions, jobs=options.jobs)
        wall, cpu = time.perf_counter() - wall, processor() - cpu
    count = options.students
    print(f"{count} notebooks of {options.set}: {wall:.1f} s, {count / wall:.0f} a second")
    print(
        f"processor: {cpu:.1f} s, {1000 * cpu / count:.1f} ms a notebook, registering with nbgrader included"
    )


if __name__ == "__main__":
    main()
