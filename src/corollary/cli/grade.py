"""`corollary grade`: what was handed in, marked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.cli.failure import FAILS, HOLDS, answer, say
from corollary.cli.progress import bar
from corollary.deliver.course import open_course
from corollary.deliver.grading import Outcome, grade_set
from corollary.mark.solutions import Solutions
from corollary.problem.bank import open_bank
from corollary.problem.problem_set import find_set
from corollary.submission.take import Runner


def run(name: str, course: Path, bank: Path | None, json: bool, regrade: bool, require: int) -> int:
    opened = open_course(course)
    place = open_bank(bank)
    problem_set = find_set(place, name)
    with bar(f"grading {problem_set.name}", None) as tell:
        done = grade_set(
            opened, problem_set, Solutions(place), lambda: Runner(require=require), regrade=regrade, tell=lambda student, left: tell(f"{student}, {left} left")
        )
    for stranger in done.strangers:
        say(f"{stranger} handed in but is not on the roster; left alone (add them to the roster and generate again)")
    if json:
        answer(document(problem_set.name, done))
    else:
        show(done)
    return FAILS if done.failed or done.strangers else HOLDS


def document(name: str, done: Outcome) -> dict[str, Any]:
    """The contract's document."""
    return {
        "set": name, "graded": len(done.graded), "skipped": len(done.skipped), "failed": list(done.failed), "strangers": list(done.strangers),
        "in_gradebook": done.in_gradebook, "report": str(done.page),
        "students": {
            student: {each: record[each] for each in ("points", "out_of", "parts", "isolation", "trouble", "late")}
            for student, record in done.records.items()
        },
    }  # fmt: skip


def show(done: Outcome) -> None:
    """The report on the terminal, and where to look."""
    from rich.console import Console

    from corollary.deliver.report import terminal

    console = Console()
    console.print(terminal(done.report))
    console.print(f"graded {len(done.graded)}, unchanged {len(done.skipped)}; report: {done.page}", soft_wrap=True)
    if not done.in_gradebook:
        say("nbgrader is not installed: the marks are in the report and the feedback pages, and not in a gradebook.db")
