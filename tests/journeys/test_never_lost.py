"""Never lost, never half-written: grading killed, a full disk, a locked gradebook, and hand-ins that do not fit."""

from __future__ import annotations

import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from corollary.atomic import write_whole
from corollary.course.demo.players import Hand, right_sources
from corollary.course.demo.stage import hand_in
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import Course, open_course
from corollary.records.marks import history, read_record, settle

pytestmark = pytest.mark.whole
BIN = Path(sys.executable).parent
SET = """\
---
title: Two exercises
due: 2026-12-04T23:59+00:00
credit: {late: 0.5}
problems: [X12.5, X12.10]
---
"""
ROSTER = tuple(Student(name) for name in ("ada", "ben", "chen", "dora", "elif", "finn"))
GRADES = (
    "select s.student_id, b.name, g.auto_score, g.manual_score, g.needs_manual_grade, n.late_submission_penalty "
    "from submitted_assignment s join submitted_notebook n on n.assignment_id = s.id join grade g on g.notebook_id = n.id "
    "join base_cell b on b.id = g.cell_id order by 1, 2"
)
COMMENTS = (
    "select s.student_id, b.name, c.auto_comment from submitted_assignment s join submitted_notebook n on n.assignment_id = s.id "
    "join comment c on c.notebook_id = n.id join base_cell b on b.id = c.cell_id order by 1, 2"
)


def in_gradebook(course: Course) -> list[tuple]:
    with sqlite3.connect(course.gradebook) as book:
        return [*book.execute(GRADES), *book.execute(COMMENTS)]


def start(pair: Path, course: Course, *words: str) -> subprocess.Popen[str]:
    line = [str(BIN / "corollary"), "grade", str(pair), "--course", str(course.folder), "--json", *words]
    return subprocess.Popen(
        line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )


def grade(pair: Path, course: Course, *words: str) -> tuple[int, dict, str]:
    running = start(pair, course, *words)
    out, said = running.communicate(timeout=240)
    return running.returncode, json.loads(out) if out else {}, said


def answers(
    course: Course, problem_set: ProblemSet, solutions: Solutions, student: Student, **others: str
) -> None:
    variants = read_assigned(course, problem_set)[student.id].variants
    paper = worksheet(problem_set, student, variants)
    keys = {variant.problem.code: solutions.key(variant) for variant in variants}
    hand_in(
        course,
        problem_set,
        paper,
        Hand(right_sources(paper, keys) | others, late=5.0 if student.id == "ben" else 0.0),
    )


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sets") / "pair.md"
    path.write_text(SET)
    return path


@pytest.fixture(scope="module")
def fresh(pair: Path, tmp_path_factory: pytest.TempPathFactory) -> Course:
    """Everybody has handed in, nothing is marked."""
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(pair)), Solutions(bank)
    folder = tmp_path_factory.mktemp("fresh") / "course"
    course = generate(folder, problem_set, ROSTER, solutions).course
    for student in ROSTER:
        wrong = {"X12_5_a_answer": "X12_5_a = 1234"} if student.id == "chen" else {}
        answers(course, problem_set, solutions, student, **wrong)
    return course


@pytest.fixture(scope="module")
def undisturbed(fresh: Course, pair: Path, tmp_path_factory: pytest.TempPathFactory) -> Course:
    course = copied(fresh, tmp_path_factory.mktemp("undisturbed"))
    status, told, said = grade(pair, course)
    assert (status, told["graded"]) == (0, len(ROSTER)), said
    return course


def copied(course: Course, to: Path) -> Course:
    shutil.copytree(course.folder, to / "course")
    return open_course(to / "course")


def test_killed_again_and_again_the_rest_is_finished_and_nothing_is_doubled(
    fresh: Course, undisturbed: Course, pair: Path, tmp_path: Path
) -> None:
    course, dice, killed = copied(fresh, tmp_path), random.Random(), 0
    for marked in range(5):
        running = start(pair, course)
        while running.poll() is None and len(list(history(course, "pair"))) <= marked:
            time.sleep(0.002)
        time.sleep(dice.uniform(0, 0.06))
        if running.poll() is None:
            os.killpg(running.pid, signal.SIGKILL)
            killed += 1
        running.communicate()
    assert killed >= 3, "the runs were over before they could be killed"
    status, told, said = grade(pair, course)
    assert status == 0, said
    assert told["graded"] + told["skipped"] == len(ROSTER)
    assert in_gradebook(course) == in_gradebook(undisturbed)
    assert sorted(entry["student"] for entry in history(course, "pair")) == [student.id for student in ROSTER]
    problem_set = find_set(chapter_bank(), str(pair))
    for student in ROSTER:
        kept, meant = (read_record(each, problem_set, student.id) for each in (course, undisturbed))
        assert kept is not None
        assert kept == meant


def test_a_history_cut_short_at_either_end_of_its_last_line_is_settled(
    undisturbed: Course, pair: Path, tmp_path: Path
) -> None:
    course, problem_set = copied(undisturbed, tmp_path), find_set(chapter_bank(), str(pair))
    path = course.folder / ".corollary/history/pair.jsonl"
    student = list(history(course, "pair"))[-1]["student"]
    before = read_record(course, problem_set, student)
    record = course.folder / f".corollary/graded/pair/{student}.json"
    record.unlink()
    settle(course, problem_set)
    assert read_record(course, problem_set, student) == before
    record.unlink()
    *whole, last = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(whole) + last[:100])
    settle(course, problem_set)
    assert read_record(course, problem_set, student) is None, "half a line proves nothing: it is marked again"
    _, told, _ = grade(pair, course)
    assert told["graded"] == 1
    assert sorted(entry["student"] for entry in history(course, "pair")) == [student.id for student in ROSTER]


def test_a_locked_gradebook_is_said_and_nothing_is_half_kept(
    fresh: Course, pair: Path, tmp_path: Path
) -> None:
    course = copied(fresh, tmp_path)
    other = sqlite3.connect(course.gradebook, isolation_level=None)
    other.execute("BEGIN IMMEDIATE")
    try:
        status, _, said = grade(pair, course)
    finally:
        other.rollback()
        other.close()
    assert status == 2
    assert "is locked by another program; close formgrader" in said
    assert not list(history(course, "pair")), "what is not in the gradebook is not kept as if it were"


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can mount a small disk")
def test_a_full_disk_is_said_and_the_next_run_finishes(
    fresh: Course, undisturbed: Course, pair: Path, tmp_path: Path
) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=16m", "tmpfs", str(disk)], check=False, capture_output=True
    ).returncode:
        pytest.skip("no disk can be mounted here")
    try:
        course = copied(fresh, disk)
        ballast = disk / "ballast"
        free = shutil.disk_usage(disk).free
        ballast.write_bytes(bytes(free - 300_000))
        status, _, said = grade(pair, course)
        assert status == 2, said
        assert "No space left on device" in said
        ballast.unlink()
        assert grade(pair, course)[0] == 0
        assert in_gradebook(course) == in_gradebook(undisturbed)
        assert sorted(entry["student"] for entry in history(course, "pair")) == [
            student.id for student in ROSTER
        ]
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=False)


def test_hand_ins_that_do_not_fit_have_a_defined_outcome(
    undisturbed: Course, pair: Path, tmp_path: Path
) -> None:
    course = copied(undisturbed, tmp_path)
    mine = course.notebook("submitted", "ada", "pair")
    write_whole(course.notebook("submitted", "zoe", "pair"), mine.read_bytes())
    shutil.copy(course.notebook("submitted", "dora", "pair"), course.notebook("submitted", "elif", "pair"))
    place = course.place("submitted", "finn", "pair")
    shutil.copy(place / "pair.ipynb", place / "pair (1).ipynb")
    (place / "pair.ipynb").rename(place / "pair (2).ipynb")
    status, told, said = grade(pair, course)
    assert status == 0, "the run is finished; what is wrong with whose file is listed"
    assert grade(pair, course, "--strict")[0] == 1
    assert told["strangers"] == ["zoe"]
    assert "zoe handed in but is not on the roster" in said
    assert "zoe" not in told["students"]
    assert told["unclear"] == {"finn": ["pair (1).ipynb", "pair (2).ipynb"]}
    assert "finn handed in 2 notebooks, none called pair.ipynb" in said
    assert any("made for dora" in note for note in told["students"]["elif"]["notes"])
    assert told["students"]["elif"]["points"] < told["students"]["dora"]["points"]
    assert told["students"]["ben"]["points"] == told["students"]["ada"]["points"] / 2


def test_a_regrade_shows_who_changes_before_it_writes(
    undisturbed: Course, pair: Path, tmp_path: Path
) -> None:
    course = copied(undisturbed, tmp_path)
    before = in_gradebook(course)
    own = tmp_path / "pair.md"
    own.write_text(pair.read_text().replace("late: 0.5", "late: 0.8"))
    status, told, said = grade(own, course, "--regrade", "--dry-run")
    assert status == 0
    assert [(each["student"], round(each["by"], 3)) for each in told["changed"]] == [
        ("ben", round(0.3 * 10, 3))
    ]
    assert "ben" in said
    assert in_gradebook(course) == before
    assert len(list(history(course, "pair"))) == len(ROSTER)
    assert told["written"] is False
    assert "nothing was written" in said
    status, told, said = grade(own, course, "--regrade")
    assert (status, told["written"]) == (1, False), "there is nobody to ask"
    assert "--yes agrees" in said
    assert in_gradebook(course) == before
    status, told, _ = grade(own, course, "--regrade", "--yes")
    assert (status, told["written"]) == (0, True)
    assert [each["student"] for each in told["changed"]] == ["ben"]
    assert told["changed"][0]["why"] == "changed: what late work keeps"
    assert in_gradebook(course) != before
    # What nobody agreed to left no trace, not even with those whose marks stay as they are.
    assert len(list(history(course, "pair"))) == 2 * len(ROSTER)
