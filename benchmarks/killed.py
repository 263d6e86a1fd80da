"""Grading killed in between: many small submissions, marked undisturbed and marked with kills, must give the same gradebook."""

from __future__ import annotations

import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from corollary.course.demo.players import Hand, right_sources
from corollary.course.demo.stage import hand_in
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.files import open_course
from corollary.records.marks import history

SMALL = "---\ntitle: One exercise\ndue: 2026-12-04 23:59\nproblems:\n  - {code}\n---\nOne exercise.\n"
SCORES = """
select s.student_id, a.name, n.late_submission_penalty, b.name, g.auto_score, g.manual_score, g.needs_manual_grade, sa.timestamp
from submitted_assignment sa join student s0 on s0.id = sa.student_id join assignment a on a.id = sa.assignment_id
join (select id, student_id from submitted_assignment) s on s.id = sa.id
join submitted_notebook n on n.assignment_id = sa.id join grade g on g.notebook_id = n.id join base_cell b on b.id = g.cell_id
order by 1, 2, 4"""
COMMENTS = """
select sa.student_id, b.name, c.auto_comment, c.manual_comment from submitted_assignment sa
join submitted_notebook n on n.assignment_id = sa.id join comment c on c.notebook_id = n.id join base_cell b on b.id = c.cell_id
order by 1, 2"""


def class_of(folder: Path, count: int, code: str = "X12.5") -> Path:
    """A course with one exercise, handed in by so many; every third has a wrong answer. Gives the file of the set."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    file = folder / "small.md"
    file.write_text(SMALL.format(code=code))
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(file)), Solutions(bank)
    roster = [Student(f"s{number:05}", f"Student {number}", "", "") for number in range(count)]
    made = generate(folder / "course", problem_set, roster, solutions)
    for number, student in enumerate(roster):
        variants = made.assigned[student.id].variants
        paper = worksheet(problem_set, student, variants)
        sources = right_sources(paper, {variant.problem.code: solutions.key(variant) for variant in variants})
        if number % 3 == 0:
            first = paper.prompts[0]
            sources[f"{first.key}_answer"] = f"{first.name} = {number + 0.5}"
        hand_in(made.course, problem_set, paper, Hand(sources))
    return file


def killed(folder: Path, count: int, kills: int, seed: int) -> dict[str, Any]:
    """Marks the class once undisturbed, and once killed `kills` times (SIGKILL to the whole group) before it is let through.

    Each kill comes a random moment after a random number of submissions are marked.
    """
    file = class_of(folder, count)
    calm, torn = folder / "course", folder / "torn"
    shutil.copytree(calm, torn)
    start = time.perf_counter()
    with _grading(file, calm) as grading:
        grading.communicate()
    seconds = time.perf_counter() - start
    dice, done_before = random.Random(seed), []
    for enough in sorted(dice.sample(range(1, count), kills)):
        with _grading(file, torn) as grading:
            while grading.poll() is None and _marked(torn) < enough:
                time.sleep(0.01)
            time.sleep(dice.uniform(0.0, 0.5))
            assert grading.poll() is None, "it was done before it could be killed"
            os.killpg(grading.pid, signal.SIGKILL)
            grading.communicate()
        done_before.append(_marked(torn))
    with _grading(file, torn) as grading:
        said, _ = grading.communicate()
    entries = [entry["student"] for entry in history(open_course(torn), "small")]
    return {
        "submissions": count,
        "seconds undisturbed": round(seconds, 1),
        "per second": round(count / seconds, 2),
        "marked when killed": done_before,
        "last run": said.strip().splitlines()[-1],
        "rows": len(_rows(calm)),
        "the same gradebook": _rows(calm) == _rows(torn),
        "the same records": _files(calm, ".corollary/graded", "*.json")
        == _files(torn, ".corollary/graded", "*.json"),
        "the same notebooks": _files(calm, "autograded", "*.ipynb") == _files(torn, "autograded", "*.ipynb"),
        "the same feedback": _files(calm, "feedback", "*.html") == _files(torn, "feedback", "*.html"),
        "nothing twice": len(entries) == len(set(entries)) == count,
    }


def _grading(file: Path, course: Path) -> subprocess.Popen[str]:
    command = [str(Path(sys.executable).parent / "corollary"), "grade", str(file), "--course", str(course)]
    return subprocess.Popen(
        command, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def _marked(course: Path) -> int:
    place = course / ".corollary" / "graded" / "small"
    return sum(name.endswith(".json") for name in os.listdir(place)) if place.is_dir() else 0


def _rows(course: Path) -> list[tuple[Any, ...]]:
    """All that the gradebook says, without the random names of its rows."""
    with sqlite3.connect(course / "gradebook.db") as book:
        return [*book.execute(SCORES), *book.execute(COMMENTS)]


def _files(course: Path, step: str, name: str) -> dict[str, bytes]:
    return {str(path.relative_to(course)): path.read_bytes() for path in (course / step).rglob(name)}
