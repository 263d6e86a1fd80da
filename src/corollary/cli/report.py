"""`corollary report`: what an instructor reads."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.failure import HOLDS, answer, refuse, say
from corollary.deliver.course import open_course
from corollary.deliver.grading import report_of
from corollary.deliver.report import as_json, terminal
from corollary.deliver.report_page import report_page
from corollary.problem.bank import open_bank
from corollary.problem.problem_set import find_set


def run(name: str, course: Path, bank: Path | None, json: bool, output: Path | None) -> int:
    opened = open_course(course)
    problem_set = find_set(open_bank(bank), name)
    found = report_of(opened, problem_set)
    if not found.handed_in:
        refuse(
            f"nothing of {problem_set.name} is graded in {course}; run corollary grade {problem_set.name} --course {course} first"
        )
    if output is not None:
        output.write_text(report_page(found, problem_set), encoding="utf-8")
        say(f"written to {output}")
    if json:
        answer(as_json(found))
    elif output is None:
        from rich.console import Console

        Console().print(terminal(found))
    return HOLDS
