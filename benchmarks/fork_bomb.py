"""A fork bomb that is bounded, at every isolation level: how many of its processes start, and how many outlive the notebook.

python benchmarks/fork_bomb.py    (one table row for each set of layers left out; some twenty seconds)

The bomb has a bottom: at most 100 processes, each of which sleeps and ends by itself after 15 seconds, each in a session of its
own, so that ending a process group is not enough. It names its processes, and they are counted by that name from outside.
"""

from __future__ import annotations

import sys
from pathlib import Path

from corollary.formula.value import Exact, Real, Text
from corollary.sandbox.job import Cell, Job, Limits
from corollary.sandbox.runner import Runner

NAME = "forkbombling"
MOST = 100
BOMB = f"""
import ctypes, os, time
libc = ctypes.CDLL(None)
a, why = 0, ""
for _ in range({MOST}):
    try:
        child = os.fork()
    except OSError as error:
        why = str(error)
        break
    if child == 0:
        os.setsid()
        libc.prctl(15, b"{NAME}")
        time.sleep(15)
        os._exit(0)
    a += 1
time.sleep(0.5)
"""
LEFT_OUT = ("", "namespaces", "Landlock", "seccomp", "Landlock seccomp", "namespaces seccomp")
LIMITS = Limits(cell_seconds=3.0, total_seconds=6.0, memory_bytes=512 << 20)


def alive() -> int:
    """Processes of the bomb on this machine, in any namespace; those that have ended and wait to be asked are not alive."""
    count = 0
    for each in Path("/proc").glob("[0-9]*/status"):
        try:
            text = each.read_text()
        except OSError:  # it has ended since
            continue
        count += f"Name:\t{NAME}\n" in text and "State:\tZ" not in text
    return count


def row(without: str) -> str:
    """One bomb without these layers, and a notebook after it."""
    with Runner(LIMITS, without=frozenset(without.split())) as runner:
        level = runner.isolation.level
        done = runner.execute(Job((Cell("c", BOMB),), ("a", "why")))
        left = alive()
        after = runner.execute(Job((Cell("c", "b = 2.5"),), ("b",)))
        later = alive()
    ran_on = "yes" if after.values == {"b": Real(2.5)} else f"no: {after.trouble}"
    forks, why = done.values.get("a"), done.values.get("why")
    started = str(forks.value) if isinstance(forks, Exact) else "-"
    stopped = why.text if isinstance(why, Text) else ""
    return f"| {without or 'nothing'} | {level} | {started} | {left} | {later} | {ran_on} | {stopped or done.trouble or 'nothing'} |"


def main() -> None:
    print(
        "| left out | level | started | alive as the result comes | after the next notebook | next notebook ran | stopped by |"
    )
    print("|---|---|---|---|---|---|---|")
    for without in LEFT_OUT if len(sys.argv) == 1 else sys.argv[1:]:
        print(row(without), flush=True)


if __name__ == "__main__":
    main()
