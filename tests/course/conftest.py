"""A class of three that has handed in right answers to one exercise, ready to be graded by the command."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from tests import forked

from corollary.course.demo.players import right_sources
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student

SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"
STUDENTS = ("ada", "ben", "cyd")
COMMAND = forked.COMMAND


@dataclass(frozen=True, slots=True)
class Graded:
    status: int
    document: dict[str, Any]
    errors: str

    @property
    def points(self) -> dict[str, float]:
        return {student: each["points"] for student, each in self.document["students"].items()}


def grade(
    course: Path, *words: str, by: tuple[object, ...] = (), name: object = "one", **settings: str
) -> Graded:
    """`corollary grade NAME`, run by another command and with these settings of the environment besides."""
    line = [*by, COMMAND, "grade", name, "--course", course, "--json", "--jobs", "1", *words]
    done = forked.run(
        list(map(str, line)),
        env={**os.environ, **settings},
        capture_output=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    return Graded(done.returncode, json.loads(done.stdout) if done.stdout else {}, done.stderr)


@pytest.fixture(scope="session")
def _handed_in(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("class")
    (folder / "one.md").write_text(SET)
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(folder / "one.md")), Solutions(bank)
    made = generate(folder / "course", problem_set, map(Student, STUDENTS), solutions)
    for student, row in made.assigned.items():
        sheet = worksheet(problem_set, Student(student), row.variants)
        keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
        path = made.course.notebook("submitted", student, "one")
        path.parent.mkdir(parents=True)
        path.write_text(filled_in(sheet, right_sources(sheet, keys)), encoding="utf-8")
    return made.course.folder


@pytest.fixture(scope="session")
def _graded(_handed_in: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    course = tmp_path_factory.mktemp("graded") / "course"
    shutil.copytree(_handed_in, course)
    done = grade(course)
    assert (done.status, done.points) == (0, dict.fromkeys(STUDENTS, 5.0)), done.errors
    return course


@pytest.fixture
def handed_in(_handed_in: Path, tmp_path: Path) -> Path:
    """A course in which nothing is graded yet."""
    return Path(shutil.copytree(_handed_in, tmp_path / "course"))


@pytest.fixture
def graded(_graded: Path, tmp_path: Path) -> Path:
    """A course in which everybody is graded."""
    return Path(shutil.copytree(_graded, tmp_path / "course"))


@pytest.fixture
def before_grading(_handed_in: Path) -> Callable[[Path], None]:
    """Gives a course the gradebook of the day before: a backup that was restored."""
    return lambda course: shutil.copy(_handed_in / "gradebook.db", course / "gradebook.db") and None
