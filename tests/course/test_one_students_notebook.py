"""Whatever one student's notebook holds, the others get the marks that they would get without it."""

from __future__ import annotations

import json
import shutil
import signal
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from corollary.answers.verdict import Unmarked
from corollary.course import grade, workers
from corollary.course import grade as grading
from corollary.course.grade import grade_set
from corollary.course.up_to_date import up_to_date
from corollary.course.workers import in_turn, side_by_side
from corollary.formula.value import Value
from corollary.grading import judge as judging
from corollary.grading.solutions import Solutions
from corollary.grading.submission import Submission
from corollary.nbgrader.graded import GradedSubmission
from corollary.problem.late_penalty import IN_TIME
from corollary.problem.roster import Student
from corollary.problem.variant import at
from corollary.records.files import open_course
from corollary.records.origin import set_of
from corollary.records.submissions import read_failures
from corollary.sandbox.runner import Runner

from .small_class import POINTS, handed_in, order

pytestmark = pytest.mark.usefixtures("one_zygote")
ANSWERS: dict[str, str] = {
    "digits": "10**1_000_000",
    "text": "'9' * 10_000_000",
    "class": "type('float', (), {'__class__': property(lambda self: float), '__float__': lambda self: 1.0})()",
    "infinity": "float('inf')",
    "nothing": "float('nan')",
    "date": "__import__('datetime').datetime(1, 1, 1)",
    "object array": "__import__('numpy').array([object(), 'x'], dtype=object)",
    "void": "__import__('numpy').zeros(2, dtype='V8')",
    "time": "__import__('numpy').datetime64('NaT')",
    "surrogate": "'\\ud800'",
    "brackets": "'(' * 20_000",
    "towers": "'9^9^9^9^9 kg m/s'",
    "itself": "(lambda x: x.append(x) or x)([])",
}
FILES: dict[str, Callable[[dict[str, Any]], bytes]] = {
    "heading": lambda _: json.dumps(
        {"nbformat": 3, "worksheets": [{"cells": [{"cell_type": "heading", "level": 10**9, "source": "x"}]}]}
    ).encode(),
    "UTF-16": lambda book: json.dumps(book).encode("utf-16"),
    "nested": lambda _: b'{"cells":' + b"[" * 100_000,
    "version": lambda book: json.dumps({**book, "nbformat": 10**9, "nbformat_minor": "x"}).encode(),
    "NaN": lambda book: json.dumps({**book, "metadata": {"a": float("nan"), "b": 1e308 * 10}}).encode(),
    "marks": lambda book: json.dumps(
        {**book, "cells": [{**each, "metadata": {"nbgrader": [1]}, "id": "x"} for each in book["cells"]]}
    ).encode(),
}


def hostile(number: int, name: str, model: Submission) -> Submission:
    """A notebook with the answer or of the kind of this name."""
    book = json.loads(model.content) if isinstance(model.content, bytes) else {}
    if name in FILES:
        content = FILES[name](book)
    else:
        cell = {"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": None}
        first = next(each for each in book["cells"] if str(each["id"]).endswith("_answer"))
        asked = "".join(first["source"]).partition("=")[0].strip().splitlines()[-1]
        book["cells"].append({**cell, "id": "last", "source": f"{asked} = {ANSWERS[name]}"})
        content = json.dumps(book).encode()
    problem = model.variants[0].problem
    return Submission(Student(f"h{number}"), content, (at(problem, 200 + number),), IN_TIME, name)


def test_hostile_answers_and_files_cost_nobody_else_anything(tmp_path: Path) -> None:
    by = order(tmp_path)
    papers = handed_in(by)
    bad = [hostile(number, name, papers[0]) for number, name in enumerate((*ANSWERS, *FILES))]
    with in_turn(by, iter([papers[0], *bad, papers[1]])) as returned:
        found = {one.submission.student.id: one for one in returned}
    assert {who: found[who].marked.points for who in ("ada", "ben")} == {
        "ada": POINTS["ada"],
        "ben": POINTS["ben"],
    }
    assert not [each for one in found.values() for each in one.failures]
    assert len(found) == len(bad) + 2


@pytest.fixture
def course(_handed_in: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(_handed_in, tmp_path / "course"))


def graded_here(course: Path, **more: Any) -> grading.Outcome:
    opened = open_course(course)
    bank, problem_set = set_of(opened, "one")
    return grade_set(opened, problem_set, Solutions(bank), partial(Runner, require=1), jobs=1, **more)


def test_a_failure_over_one_answer_leaves_it_to_a_person_and_is_logged(course: Path, monkeypatch) -> None:
    real, met = judging.read, list[str]()

    def stumbling(part: Any, value: Value, *about: Any) -> Any:
        met.append(part.id)
        if len(met) == 3:
            raise ZeroDivisionError("a fault of ours")
        return real(part, value, *about)

    monkeypatch.setattr(judging, "read", stumbling)
    done = graded_here(course)
    (who,) = done.failures
    assert done.failures[who] == "ZeroDivisionError: a fault of ours"
    assert [part.verdict for part in done.records[who].parts.values()].count("unmarked") == 1
    assert {one: record.points for one, record in done.records.items() if one != who} == dict.fromkeys(
        {"ada", "ben", "cyd"} - {who}, 5.0
    )
    assert done.log is not None
    assert "in stumbling" in done.log.read_text()
    assert done.log.stat().st_mode & 0o777 == 0o600
    assert "ZeroDivision" not in (course / "feedback" / who / "one" / "one.html").read_text()


def test_a_failure_while_reading_or_writing_one_students_work(course: Path, monkeypatch) -> None:
    write, read = grade.write_graded, grading.read_submission

    def unwritable(where: Any, problem_set: Any, several: Sequence[GradedSubmission], *about: Any) -> None:
        if any(one.submission.student.id == "ben" and one.answers and one.marked.points for one in several):
            raise UnicodeEncodeError("utf-8", "\ud800", 0, 1, "surrogates not allowed")
        write(where, problem_set, several, *about)

    def unreadable(where: Any, problem_set: Any, student: Student, *about: Any) -> Submission:
        if student.id == "cyd":
            raise RecursionError("too deep")
        return read(where, problem_set, student, *about)

    monkeypatch.setattr(grade, "write_graded", unwritable)
    monkeypatch.setattr(grading, "read_submission", unreadable)
    done = graded_here(course)
    assert done.records["ada"].points == 5.0
    assert set(done.failures) == {"ben", "cyd"}
    assert set(done.failed) == {"ben", "cyd"}
    assert {part.verdict for part in done.records["ben"].parts.values()} == {"unmarked"}
    assert "cyd" not in done.records
    assert "RecursionError: too deep" in dict(done.report.unusable)["cyd"]
    page = done.page.read_text()
    assert "corollary failed on this file" in page
    monkeypatch.undo()
    opened = open_course(course)
    later = up_to_date(opened, set_of(opened, "one")[1])
    why = "corollary failed on this file, so mark it by hand (RecursionError: too deep)"
    assert dict(later.unusable)["cyd"] == why
    again = graded_here(course, regrade=True)
    assert {one: record.points for one, record in again.records.items()} == dict.fromkeys(
        ("ada", "ben", "cyd"), 5.0
    )
    assert not again.report.unusable
    assert not read_failures(opened, "one")


@pytest.mark.whole
def test_what_hears_no_signal_is_ended_and_the_others_are_marked(tmp_path: Path, monkeypatch) -> None:
    by = order(tmp_path)
    papers = handed_in(by)
    real, first = Solutions.key, papers[0].variants[0].index

    def deaf(self: Solutions, variant: Any) -> Any:
        if variant.index == first:
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGPROF})  # as inside a library
            while True:
                pass
        return real(self, variant)

    monkeypatch.setattr(Solutions, "key", deaf)
    monkeypatch.setattr(workers, "LONGEST", 2.0)
    with side_by_side(2)(by, iter(papers[:2])) as returned:
        found = {one.submission.student.id: one.marked for one in returned}
    assert found["ben"].points == POINTS["ben"]
    assert all(isinstance(part.verdict, Unmarked) for part in found["ada"].grades[0].parts)
    assert "died twice" in found["ada"].trouble
