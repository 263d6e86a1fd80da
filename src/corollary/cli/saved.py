"""What an author works on: the files of one problem, and whether one was saved."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from corollary.problem.bank import Bank
from corollary.problem.pictures import pictures_of


def edition(bank: Bank, path: Path) -> str:
    """Tells the files of a problem apart from what they were: its own, its pictures, its solution, and the programs beside that."""
    solution = bank.solution_beside(path)
    beside = [*solution.parent.glob("*.py"), *solution.with_suffix("").rglob("*.py")]
    with suppress(OSError):
        beside += pictures_of(path)
    states: list[str] = []
    for each in (path, *sorted(beside)):
        with suppress(OSError):  # an editor that moves a file into place leaves none for a moment
            found = each.stat()
            states.append(f"{each.name} {found.st_mtime_ns} {found.st_size}")
    return "; ".join(states)
