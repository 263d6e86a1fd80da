# pyright: reportUnknownMemberType=false
"""Where the processor time of one notebook goes, beyond that of its own cells.

python benchmarks/worker_cost.py [--rounds 40] [--markdown FILE]

In every round a notebook of `benchmarks/grading.py` is run in a warm IPython without walls and in a worker behind all of
them, there twice over: the second time the pages of memory that it writes to are its own already.
"""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import time
from pathlib import Path

import matplotlib as mpl
from IPython.core.interactiveshell import InteractiveShell

from corollary.formula.value import Real
from corollary.sandbox.job import Cell, ExecutionResult, Job
from corollary.sandbox.runner import Runner
from grading import TEST, WORK

CELLS = (*(work.replace("{v}", "20.0") for work in WORK), TEST)
LOOK = (
    "import resource as _resource, time as _time\n"
    "spent{at} = _time.process_time()\n"
    "pages{at} = float(_resource.getrusage(_resource.RUSAGE_SELF).ru_minflt)"
)
_TO_END = 0.1  # seconds: a worker has then ended, and the next one has been forked and waits
_TICK = os.sysconf("SC_CLK_TCK")


def processes(first: int) -> list[int]:
    """A process and all that descend from it, elders first."""
    found = [first]
    for task in Path(f"/proc/{first}/task").iterdir():
        for child in (task / "children").read_text().split():
            found += processes(int(child))
    return found


def spent(process: int) -> float:
    """Milliseconds on the processor of a process and of its children that have ended."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return sum(map(int, fields[11:15])) / _TICK * 1000


def floor(shell: InteractiveShell) -> float:
    """Milliseconds that the cells take in a warm process without walls."""
    shell.reset(new_session=False)
    before = time.process_time()
    for cell in CELLS:
        shell.run_cell(cell, store_history=False, silent=True)
    return (time.process_time() - before) * 1000


def run(runner: Runner, sources: list[str], looks: int) -> list[tuple[float, float]]:
    """Milliseconds and pages touched first or copied, from the birth of the worker to each look."""
    names = tuple(f"{name}{at}" for at in range(looks) for name in ("spent", "pages"))
    result = runner.execute(
        Job(tuple(Cell(str(at), source) for at, source in enumerate(sources)), names, pictures=False)
    )
    assert [each.status for each in result.cells] == ["ok"] * len(sources), result.cells
    return [(_number(result, f"spent{at}") * 1000, _number(result, f"pages{at}")) for at in range(looks)]


def _number(result: ExecutionResult, name: str) -> float:
    value = result.values[name]
    assert isinstance(value, Real), value
    return value.value


def measured(rounds: int) -> dict[str, float]:
    mpl.use("agg")
    shell = InteractiveShell.instance()
    twice = [LOOK.format(at=0), *CELLS, LOOK.format(at=1), *CELLS, LOOK.format(at=2)]
    alone, found = [floor(shell)], list[list[tuple[float, float]]]()
    with Runner() as runner:
        run(runner, list(CELLS), 0)
        time.sleep(_TO_END)
        # The first is left outside the walls and only waits; the one that forks is its child.
        assert runner._zygote is not None  # pyright: ignore[reportPrivateUsage]
        forking = processes(runner._zygote.pid)[1]  # pyright: ignore[reportPrivateUsage]
        whole = 0.0
        for _ in range(rounds):
            alone.append(floor(shell))
            found.append(run(runner, twice, 3))
            time.sleep(_TO_END)
            before = spent(forking)
            run(runner, list(CELLS), 0)
            time.sleep(_TO_END)
            whole += (spent(forking) - before) / rounds
    start, first, second = (
        [statistics.median(values) for values in zip(*looks, strict=True)]
        for looks in zip(*found, strict=True)
    )
    return {
        "cells alone": statistics.median(alone[1:]),
        "start": start[0],
        "start pages": start[1],
        "first": first[0] - start[0],
        "first pages": first[1] - start[1],
        "second": second[0] - first[0],
        "second pages": second[1] - first[1],
        "whole": whole,
    }


def table(found: dict[str, float]) -> str:
    """The measurement as a page."""
    alone, start, first, second = (found[name] for name in ("cells alone", "start", "first", "second"))
    copies, pages = first - second, found["first pages"] - found["second pages"]
    rows = [
        ("the cells in a warm process without walls", alone, 0.0),
        (
            "the same cells in a worker whose pages are its own: outputs, figures and answers collected too",
            second,
            found["second pages"],
        ),
        ("pages that the cells are the first to touch, or copy", copies, pages),
        (
            "from birth to the first cell: namespaces, privileges, limits, Landlock, seccomp, the job",
            start,
            found["start pages"],
        ),
        ("the fork in the zygote, and the worker's end", found["whole"] - start - first, 0.0),
    ]
    lines = ["| what | ms of processor | pages |", "|---|---|---|"]
    lines += [f"| {what} | {spent:.1f} | {count:.0f} |" for what, spent, count in rows]
    return "\n".join(
        [
            *lines,
            "",
            f"From birth to its last cell a worker takes {(start + first) / alone:.2f} times what the cells take alone, "
            f"with its fork and its end {found['whole'] / alone:.2f} times. One page costs {copies / pages * 1000:.1f} µs.",
        ]
    )


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--rounds", type=int, default=40)
    options.add_argument("--markdown", type=Path)
    chosen = options.parse_args()
    text = table(measured(chosen.rounds))
    sys.stdout.write(text + "\n")
    if chosen.markdown is not None:
        chosen.markdown.write_text(
            f"# Where a notebook's processor time goes\n\n`python benchmarks/worker_cost.py --rounds {chosen.rounds}`, "
            f"six code cells with numpy and one plot, Python {sys.version.split()[0]}.\n\n{text}\n",
            encoding="utf-8",
        )


if __name__ == "__main__":
    main()
