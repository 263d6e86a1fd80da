"""A class of three with an exercise in words: ada in time, ben late (half is kept), cyd with nothing written; graded by the command."""

from __future__ import annotations

import io
import json
import logging
import shutil
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from tests import forked

from corollary.cli.main import main
from corollary.course.demo.players import right_sources
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import programs_on_path
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
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
WORDS = {"ada": "The floor takes the energy.", "ben": "The floor moves.", "cyd": "*Your answer here.*"}


@dataclass(frozen=True, slots=True)
class Done:
    status: int
    out: str
    errors: str

    @property
    def document(self) -> dict[str, Any]:
        return json.loads(self.out)


def run(course: Course, *words: object) -> Done:
    """A command in the course's folder: `corollary …` or `nbgrader …`, without a terminal and in this very process: nbgrader
    alone takes longer to start than to do anything here. What runs notebooks is forked, for the same reason."""
    program, *line = map(str, words)
    if line[0] in ("grade", "autograde"):
        done = forked.run([forked.COMMAND.with_name(program), *line], cwd=course.folder)
        return Done(done.returncode, done.stdout, done.stderr)
    out, errors = io.StringIO(), io.StringIO()
    before, sys.argv = sys.argv, [program, *line]
    try:
        with chdir(course.folder), redirect_stdout(out), redirect_stderr(errors):
            status = _nbgrader(line, errors) if program == "nbgrader" else _corollary()
    finally:
        sys.argv = before
    return Done(status, out.getvalue(), errors.getvalue())


def _corollary() -> int:
    try:
        main()
    except SystemExit as end:
        return int(end.code or 0)
    return 0


def _nbgrader(line: list[str], log: io.StringIO) -> int:
    from jupyter_core.application import NoStart
    from nbgrader.apps.baseapp import NbGrader
    from nbgrader.apps.nbgraderapp import NbGraderApp

    app = NbGraderApp.instance()
    try:
        with programs_on_path():
            app.initialize(line)
            app.init_logging(logging.StreamHandler, [log], color=False, subapps=True)
            app.start()
    except NoStart:  # how a subcommand says that it is done
        return 0
    except SystemExit as end:
        return int(end.code or 0)
    finally:
        app.reset()
        NbGrader.clear_instance()
    return 0


def grade(course: Course, *words: object) -> Done:
    return run(course, "corollary", "grade", "words", "--course", ".", "--json", "--jobs", "1", *words)


def hand_in(course: Course, student: Student, **others: str) -> None:
    """Everything right, and in words what WORDS say, in time but for ben."""
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(course.folder.parent / "words.md")), Solutions(bank)
    sheet = worksheet(problem_set, student, read_assigned(course, problem_set)[student.id].variants)
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    written = {"X12_11_c": WORDS[student.id]}
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
    course = generate(folder / "course", problem_set, STUDENTS, Solutions(bank)).course
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
