"""A class of three with an exercise in words: ada in time, ben late (half is kept), cyd with nothing written; graded by the command."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from corollary.course.demo.player import right_sources
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assigned import read_assigned
from corollary.records.files import Course, open_course

SET = """\
---
title: One with words
due: 2026-03-02T12:00+00:00
credit: {late: 0.5}
problems: [X12.11]
---
"""
STUDENTS = (Student("ada", "Ada", "Lovelace"), Student("ben", "Ben", "Boole"), Student("cyd", "Cyd"))
BIN = Path(sys.executable).parent
WORDS = {"ada": "The floor takes the energy.", "ben": "The floor moves.", "cyd": ""}


@dataclass(frozen=True, slots=True)
class Done:
    status: int
    out: str
    errors: str

    @property
    def document(self) -> dict[str, Any]:
        return json.loads(self.out)


def run(course: Course, *words: object, stdin: str | None = None) -> Done:
    """A command in the course's folder: `corollary …` or `nbgrader …`, without a terminal."""
    done = subprocess.run(
        [str(BIN / str(words[0])), *map(str, words[1:])],
        cwd=course.folder,
        env={**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "COLUMNS": "200"},
        input=stdin,
        capture_output=True,
        encoding="utf-8",
        timeout=240,
        check=False,
    )
    return Done(done.returncode, done.stdout, done.stderr)


def grade(course: Course, *words: object) -> Done:
    return run(course, "corollary", "grade", "words", "--course", ".", "--json", "--jobs", "1", *words)


def hand_in(course: Course, student: Student, **others: str) -> None:
    """Everything right, and in words what WORDS say, in time but for ben."""
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(course.folder.parent / "words.md")), Solutions(bank)
    row = read_assigned(course, "words")[student.id]
    sheet = worksheet(problem_set, student, problem_set.variants(row))
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    written = {"X12_11_c": WORDS[student.id]} if WORDS[student.id] else {}
    path = course.notebook("submitted", student.id, "words")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(filled_in(sheet, right_sources(sheet, keys) | written | others), encoding="utf-8")
    assert problem_set.due is not None
    moment = problem_set.due + timedelta(hours=1 if student.id == "ben" else -1)
    path.with_name("timestamp.txt").write_text(f"{moment:%Y-%m-%d %H:%M:%S} UTC")


@pytest.fixture(scope="session")
def _marked_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("words")
    (folder / "words.md").write_text(SET)
    bank = chapter_bank()
    problem_set = find_set(bank, str(folder / "words.md"))
    course = generate(
        folder / "course", problem_set, STUDENTS, Solutions(bank), file=folder / "words.md"
    ).course
    for student in STUDENTS:
        hand_in(course, student)
    done = grade(course)
    assert done.status == 0, done.errors
    return folder


@pytest.fixture
def marked_course(_marked_once: Path, tmp_path: Path) -> Course:
    """A copy of the graded course; its set stays where it was."""
    shutil.copytree(_marked_once / "course", tmp_path / "course")
    shutil.copy(_marked_once / "words.md", tmp_path)
    origin = tmp_path / "course/.corollary/origin/words.json"
    origin.write_text(json.dumps(json.loads(origin.read_text()) | {"set": str(tmp_path / "words.md")}))
    return open_course(tmp_path / "course")
