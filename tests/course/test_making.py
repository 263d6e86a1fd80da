"""A set made on several processes is the same, to the byte, as one made on one; a process that dies costs nothing."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import nbformat
import pytest

from corollary.course import generate
from corollary.grading.solutions import Solutions
from corollary.problem.roster import Student
from corollary.records.files import create_course

from .changing_bank import ChangingBank, Text, replace

KEY = bytes(range(32))
ROSTER = [Student(f"s{number:02}") for number in range(20)]
# Fewer than there are students: some must share.
NARROW = {
    "m": "value: 0.43, from: 0.3, to: 0.4, step: 0.1, unit: kg",
    "v": "value: 20, from: 10, to: 35, step: 5, unit: m/s",
    "dt": "value: 0.1, unit: s",
}


@pytest.fixture
def ball(tmp_path: Path) -> ChangingBank:
    ball = ChangingBank(tmp_path)
    ball.write(Text(), replace(Text(), code="X1.2", givens=NARROW))
    return ball


def made(ball: ChangingBank, name: str, jobs: int) -> dict[str, bytes]:
    folder = ball.folder / name / "course"
    (folder / ".corollary").mkdir(parents=True)
    (folder / ".corollary" / "key").write_bytes(KEY)
    generate.generate(folder, ball.problem_set, ROSTER, Solutions(ball.bank), jobs=jobs)
    files = [*folder.glob("release/*/week/week.ipynb"), folder / ".corollary" / "assigned" / "week.json"]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@pytest.mark.whole
def test_the_same_on_one_and_on_two_processes(ball: ChangingBank) -> None:
    one, two = made(ball, "one", 1), made(ball, "two", 2)
    assert len(one) == len(ROSTER) + 1
    assert one == two


def test_a_file_is_what_nbformat_would_write(ball: ChangingBank) -> None:
    for name, content in made(ball, "one", 1).items():
        if name.endswith(".ipynb"):
            nb = nbformat.reads(content.decode(), as_version=4)
            nbformat.validate(nb)
            assert content.decode() == nbformat.writes(nb) + "\n"


@pytest.mark.skipif(sys.platform != "linux", reason="a fork takes the changed function along")
def test_a_process_that_is_killed_costs_nothing(ball: ChangingBank, monkeypatch: pytest.MonkeyPatch) -> None:
    course = create_course(ball.course, ROSTER)
    solutions = Solutions(ball.bank)
    students = [each.id for each in ROSTER]
    dealt = ball.problem_set.deal(course.key, students)
    with generate.makers(course, ball.problem_set, solutions, len(students), 1, dealt) as by:
        expected = list(by.draw(students))
    here, draw = os.getpid(), generate._draw

    def deadly(by: generate.Makers, part: list[str]) -> list[generate.Drawn]:
        if os.getpid() != here and "s09" in part:
            os._exit(1)
        return draw(by, part)

    deadly.__module__, deadly.__qualname__ = generate.__name__, "_draw"
    monkeypatch.setattr(generate, "_draw", deadly)
    with generate.makers(course, ball.problem_set, solutions, len(students), 2, dealt) as by:
        assert list(by.draw(students)) == expected
