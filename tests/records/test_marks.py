"""The marks of a course: recorded whole, and settled after a cut."""

from __future__ import annotations

import json
import runpy
from dataclasses import replace
from pathlib import Path

import pytest

from corollary.grading.part_grades import Marked
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.files import Course, create_course
from corollary.records.marks import (
    NewMarks,
    history,
    read_record,
    read_records,
    record_of,
    settle,
    write_marks,
)

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))


@pytest.fixture
def of(tmp_path: Path) -> ProblemSet:
    return SAMPLE["problem_set"](tmp_path)


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "mech", [Student("ada", "Ada"), Student("bo")])


@pytest.fixture
def work(of: ProblemSet) -> Marked:
    return SAMPLE["marked"](of)


def write(course: Course, of: ProblemSet, work: Marked, fingerprint: str) -> None:
    write_marks(course, of, [NewMarks("ada", record_of(work, fingerprint), b"{}", "the page")])


def place(course: Course, of: ProblemSet) -> Path:
    return course.folder / ".corollary/graded" / of.name / "ada.json"


def test_what_is_written_reads_back(course: Course, of: ProblemSet, work: Marked) -> None:
    write(course, of, work, "f")
    record = read_record(course, of, "ada")
    assert record == record_of(work, "f")
    assert read_records(course, of, ["ada", "bo"]) == {"ada": record}
    assert (course.folder / f"feedback/ada/{of.name}/{of.name}.html").read_text() == "the page"
    entry = json.loads(place(course, of).read_text())
    assert entry["parts"]["X12_5_c"]["mistake"] == "You forgot the $\\frac12$."
    assert "slip" not in entry["parts"]["X12_5_c"]
    assert entry["rows"][2]["error"] == "You forgot the $\\frac12$."


@pytest.mark.parametrize("text", ["", "null", "[]", "{", '{"points": 1}', '{"points": "many"}'])
def test_a_damaged_record_counts_as_none(course: Course, of: ProblemSet, work: Marked, text: str) -> None:
    write(course, of, work, "f")
    place(course, of).write_text(text)
    assert read_record(course, of, "ada") is None


@pytest.mark.parametrize("left", [0, 1, 40])
def test_a_line_cut_short_is_no_mark_and_spoils_no_other(
    course: Course, of: ProblemSet, work: Marked, left: int
) -> None:
    write(course, of, work, "first")
    path = course.folder / f".corollary/history/{of.name}.jsonl"
    whole = path.read_bytes()
    write(course, of, replace(work, late=60.0), "second")
    path.write_bytes(path.read_bytes()[: len(whole) + left])
    settle(course, of)
    write(course, of, work, "third")
    assert [each["fingerprint"] for each in history(course, of.name)] == ["first", "third"]


def together(course: Course, of: ProblemSet, work: Marked, fingerprint: str) -> None:
    """The marks of two students, written at once."""
    new = [
        NewMarks(one, record_of(work, f"{fingerprint} of {one}"), b"{}", "the page") for one in ("ada", "bo")
    ]
    write_marks(course, of, new)


def test_records_of_marks_written_together_are_settled_together(
    course: Course, of: ProblemSet, work: Marked
) -> None:
    write(course, of, work, "first")
    together(course, of, work, "second")
    places = [place(course, of), place(course, of).with_name("bo.json")]
    before = [path.read_bytes() for path in places]
    for lost in (places[:1], places[1:], places):
        for path in lost:
            path.unlink()
        settle(course, of)
        assert [path.read_bytes() for path in places] == before


def test_of_marks_written_together_whole_lines_count_and_the_one_cut_short_does_not(
    course: Course, of: ProblemSet, work: Marked
) -> None:
    together(course, of, work, "first")
    for student in ("ada", "bo"):
        place(course, of).with_name(f"{student}.json").unlink()
    path = course.folder / f".corollary/history/{of.name}.jsonl"
    path.write_bytes(path.read_bytes()[:-100])
    settle(course, of)
    record = read_record(course, of, "ada")
    assert record is not None
    assert record.fingerprint == "first of ada"
    assert read_record(course, of, "bo") is None
