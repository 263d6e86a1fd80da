"""What was handed in, and when: found however it was named, dated as nbgrader dates it."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from corollary.atomic import write_whole
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import AssignedSheet
from corollary.records.deadlines import Terms
from corollary.records.files import Course, create_course
from corollary.records.submissions import (
    fingerprint,
    handed_in,
    lateness,
    moment,
    read_submission,
    submissions,
)

NO_DATE = Terms()


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "mech", [Student("ada")])


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("2026-12-04 21:03:11.500000 UTC", 0),
        ("2026-12-04 21:03:11.5", 0),
        ("2026-12-04 22:03:11.500000 +0100", 0),
        ("2026-12-04T22:03:11.500000+01:00\n", 0),
        ("2026-12-04 22:03:11.500000 Europe/Oslo", 0),
        ("2026-12-04 21:03:12 UTC", 0.5),
    ],
)
def test_timestamps_as_nbgrader_and_others_write_them(text: str, seconds: float):
    base = datetime(2026, 12, 4, 21, 3, 11, 500000, tzinfo=UTC)
    assert (moment(text) - base).total_seconds() == seconds


def test_the_same_moments_as_nbgrader_reads():
    parse_utc = pytest.importorskip("nbgrader.utils").parse_utc
    for text in ("2026-12-04 21:03:11.500000 UTC", "2026-07-04 21:03:11", "2026-12-04T22:03:11.5+01:00"):
        assert moment(text).replace(tzinfo=None) == parse_utc(text)


def test_handed_in_is_the_timestamp_or_the_age_of_the_file(course: Course):
    assert handed_in(course, "week_1", "ada") is None
    notebook = course.notebook("submitted", "ada", "week_1")
    write_whole(notebook, "{}")
    os.utime(notebook, (1_700_000_000, 1_700_000_000))
    assert handed_in(course, "week_1", "ada") == datetime.fromtimestamp(1_700_000_000, UTC)
    (notebook.parent / "timestamp.txt").write_text("soon")
    assert handed_in(course, "week_1", "ada") == datetime.fromtimestamp(1_700_000_000, UTC)
    (notebook.parent / "timestamp.txt").write_text("2026-12-04 21:03:11 UTC\n")
    assert handed_in(course, "week_1", "ada") == datetime(2026, 12, 4, 21, 3, 11, tzinfo=UTC)


@pytest.mark.parametrize("kind", ["pipe", "link", "folder", "sparse", "year 1", "zone"])
def test_a_timestamp_that_is_none_is_passed_over(course: Course, kind: str):
    notebook = course.notebook("submitted", "ada", "week_1")
    write_whole(notebook, "{}")
    os.utime(notebook, (1_700_000_000, 1_700_000_000))
    stamp = notebook.parent / "timestamp.txt"
    match kind:
        case "pipe":
            os.mkfifo(stamp)
        case "link":
            stamp.symlink_to("/dev/zero")
        case "folder":
            stamp.mkdir()
        case "sparse":
            with stamp.open("wb") as file:
                file.truncate(40 << 30)
        case "year 1":
            stamp.write_text("0001-01-01 00:00:00 +0500")
        case _:
            stamp.write_text("2026-12-04 21:03:11 Zone/../../etc/passwd")
    assert handed_in(course, "week_1", "ada") == datetime.fromtimestamp(1_700_000_000, UTC)


def test_a_students_folder_that_is_a_link_is_not_followed(course: Course):
    write_whole(course.notebook("submitted", "ada", "week_1"), "{}")
    (course.folder / "submitted" / "bob").symlink_to(course.folder / "submitted" / "ada")
    problem_set = find_set(chapter_bank(), "momentum_1")
    for student, content in (("ada", b"{}"), ("bob", None)):
        path = course.notebook("submitted", student, "week_1")
        read = read_submission(
            course, problem_set, Student(student), path, AssignedSheet((), ""), "", Terms()
        ).content
        assert read == content if content is not None else "link" in str(read)


def test_submissions_are_found_even_when_renamed(course: Course):
    for student, name in [
        ("ada", "week_1"),
        ("ada", "scratch"),
        ("bob", "week_1 (2)"),
        ("eve", "one"),
        ("eve", "two"),
    ]:
        write_whole(course.place("submitted", student, "week_1") / f"{name}.ipynb", "{}")
    write_whole(course.place("submitted", "sam", "week_2") / "week_2.ipynb", "{}")
    assert {student: path.name for student, path in submissions(course, "week_1").items()} == {
        "ada": "week_1.ipynb",
        "bob": "week_1 (2).ipynb",
    }


def test_the_fingerprint_tells_whatever_marks_depend_on(course: Course):
    notebook = course.notebook("submitted", "ada", "week_1")
    write_whole(notebook, "{}")
    os.utime(notebook, (1_700_000_000, 1_700_000_000))

    def now(identity: str, state: str = "s", terms: Terms = NO_DATE) -> str:
        return fingerprint(course, "week_1", "ada", notebook, AssignedSheet((), identity), state, terms)

    before = now("sheet")
    assert now("sheet") == before
    assert now("another") != before
    assert now("sheet", "t") != before
    due = datetime(2026, 12, 4, 23, tzinfo=UTC)
    for terms in (Terms(due), Terms(excused=True), Terms(reveal=True)):  # the page says each of them
        assert now("sheet", terms=terms) != before
    os.utime(notebook, (1_700_000_001, 1_700_000_001))
    later = now("sheet")
    assert later != before
    notebook.write_text("{ }")
    os.utime(notebook, (1_700_000_001, 1_700_000_001))
    assert now("sheet") != later


def test_late_is_after_ones_own_deadline(course: Course):
    problem_set = find_set(chapter_bank(), "momentum_1")
    place = course.place("submitted", "ada", "momentum_1")
    write_whole(place / "momentum_1.ipynb", "{}")
    write_whole(place / "timestamp.txt", "2026-12-05 12:00:00 UTC")
    oslo = ZoneInfo("Europe/Oslo")
    for terms, seconds in [
        (Terms(datetime(2026, 12, 5, 12, 0, tzinfo=oslo)), 3600),
        (Terms(datetime(2026, 12, 5, 13, 0, tzinfo=oslo)), 0),
        (Terms(datetime(2026, 12, 4, 12, 0, tzinfo=UTC)), 86400),
        (Terms(datetime(2026, 12, 4, 12, 0, tzinfo=UTC), excused=True), 0),
        (NO_DATE, 0),
    ]:
        assert lateness(course, problem_set, "ada", terms).seconds == seconds
