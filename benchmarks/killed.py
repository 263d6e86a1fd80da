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

from corollary.deliver.course import open_course
from corollary.deliver.demo.player import Hand, right_sources
from corollary.deliver.demo.stage import hand_in
from corollary.deliver.generating import generate, variants_of
from corollary.deliver.keeping import history
from corollary.mark.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.sheet.sheet import sheet

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
    made = generate(folder / "course", problem_set, roster, solutions, file=file)
    for number, student in enumerate(roster):
        variants = variants_of(problem_set, made.dealt[student.id])
        paper = sheet(problem_set, student, variants)
        sources = right_sources(paper, {variant.problem.code: solutions.key(variant) for variant in variants})
        if number % 3 == 0:
            first = paper.prompts[0]
            sources[f"{first.key}_answer"] = f"{first.name} = {number + 0.5}"
        hand_in(made.course, problem_set, paper, Hand(sources))
    return file


def killed(folder: Path, count: int, kills: int, seed: int) -> dict[str, Any]:
    """Marks the class once undisturbed, and once killed `kills` times (SIGKILL to the whole group) before it is let through."""
    file = class_of(folder, count)
    calm, torn = folder / "course", folder / "torn"
    shutil.copytree(calm, torn)
    seconds = _grade(file, calm, None)[0]
    dice, moments, done_before = random.Random(seed), [], []
    for _ in range(kills):
        moments.append(dice.uniform(0.6, 0.95) * seconds)  # up to half of a short run goes into the start
        _grade(file, torn, moments[-1])
        done_before.append(len(list((torn / ".corollary" / "graded").rglob("*.json"))))
    _, said = _grade(file, torn, None)
    entries = [entry["student"] for entry in history(open_course(torn), "small")]
    return {
        "submissions": count, "seconds undisturbed": round(seconds, 1), "per second": round(count / seconds, 2),
        "killed after seconds": [round(moment, 1) for moment in moments], "marked by then": done_before,
        "last run": said.strip().splitlines()[-1],
        "rows": len(_rows(calm)), "the same gradebook": _rows(calm) == _rows(torn),
        "nothing twice": len(entries) == len(set(entries)) == count, "the same feedback": _pages(calm) == _pages(torn),
    }  # fmt: skip


def _grade(file: Path, course: Path, until: float | None) -> tuple[float, str]:
    start = time.perf_counter()
    command = [str(Path(sys.executable).parent / "corollary"), "grade", str(file), "--course", str(course)]
    grading = subprocess.Popen(command, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        said, _ = grading.communicate(timeout=until)
    except subprocess.TimeoutExpired:
        os.killpg(grading.pid, signal.SIGKILL)
        said, _ = grading.communicate()
    return time.perf_counter() - start, said


def _rows(course: Path) -> list[tuple[Any, ...]]:
    """All that the gradebook says, without the random names of its rows."""
    with sqlite3.connect(course / "gradebook.db") as book:
        return [*book.execute(SCORES), *book.execute(COMMENTS)]


def _pages(course: Path) -> dict[str, bytes]:
    return {str(path.relative_to(course)): path.read_bytes() for path in (course / "feedback").rglob("*.html")}
