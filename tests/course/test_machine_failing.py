"""A machine's failing costs no marks: nothing is recorded, the run says so, and the next one marks what is left."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, cast

import pytest
from click.testing import CliRunner, Result

from corollary.cli.commands import app
from corollary.course.grade import grade_set
from corollary.grading.solutions import Solutions
from corollary.records.files import open_course
from corollary.records.origin import set_of
from corollary.sandbox.job import ExecutionResult, Job, Limits
from corollary.sandbox.runner import Runner

SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"


class Failing:
    """A runner whose every second notebook meets a process that dies before its first cell."""

    def __init__(self) -> None:
        self.real = Runner(Limits(memory_bytes=24 << 20), require=1)
        self.ran = 0

    def __enter__(self) -> Failing:
        self.real.__enter__()
        return self

    def __exit__(self, *about: Any) -> None:
        self.real.__exit__(None, None, None)

    def execute(self, job: Job) -> ExecutionResult:
        self.ran += 1
        if self.ran % 2:
            job = replace(job, cells=(replace(job.cells[0], source="#" + "x" * (200 << 20)), *job.cells[1:]))
            return self.real.execute(job)
        with Runner(require=1) as healthy:
            return healthy.execute(job)


def command(*words: object) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words], catch_exceptions=False)


@pytest.mark.whole
def test_who_could_not_be_run_is_named_and_marked_by_the_next_run(tmp_path: Path) -> None:
    place = tmp_path / "course"
    roster = tmp_path / "roster.csv"
    roster.write_text("id\nada\nben\n")
    (tmp_path / "one.md").write_text(SET)
    assert command("generate", tmp_path / "one.md", "--course", place, "--roster", roster).exit_code == 0
    for student in ("ada", "ben"):
        sheet = place / "release" / student / "one" / "one.ipynb"
        target = place / "submitted" / student / "one" / "one.ipynb"
        target.parent.mkdir(parents=True)
        target.write_bytes(sheet.read_bytes())
    course = open_course(place)
    bank, problem_set = set_of(course, "one", None)
    grade = partial(grade_set, course, problem_set, Solutions(bank), jobs=1)
    first = grade(cast(Callable[[], Runner], Failing))
    assert list(first.not_run) == ["ada"]
    assert "before its first cell" in first.not_run["ada"]
    assert (first.graded, first.failed, list(first.records)) == (("ben",), ("ada",), ["ben"])
    second = grade(partial(Runner, require=1))
    assert (second.graded, second.skipped, second.failed) == (("ada",), ("ben",), ())
    assert second.records["ada"].points == second.records["ben"].points
    third = command("grade", "one", "--course", place, "--regrade", "--dry-run")
    assert third.exit_code == 0
    assert third.stderr.startswith("isolation level ")
