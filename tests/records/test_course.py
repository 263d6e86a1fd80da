"""A course folder: made once, opened for ever, and never half written."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from pathlib import Path

import pytest

from corollary.problem.roster import Student
from corollary.records.course import (
    Course,
    NotACourse,
    create_course,
    dealt_anywhere,
    handed_in,
    moment,
    open_course,
    read_dealt,
    students,
    submissions,
    write_atomically,
    write_dealt,
)

ROSTER = [
    Student("ada", "Ada", "Lovelace", "ada@example.org"),
    Student("emilie", 'Émilie, "la"', "du Châtelet"),
]


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "mech", ROSTER)


def test_a_course_opens_again_with_its_key_and_its_students(course: Course):
    again = open_course(course.folder)
    assert again == course
    assert len(course.key) == 32
    assert list(students(again)) == ROSTER


def test_made_again_it_keeps_the_key_and_takes_the_new_roster(course: Course):
    again = create_course(course.folder, [*ROSTER, Student("bob")])
    assert again.key == course.key
    assert [student.id for student in students(again)] == ["ada", "emilie", "bob"]


def test_two_courses_have_two_keys(course: Course, tmp_path: Path):
    assert create_course(tmp_path / "other", ROSTER).key != course.key


def test_the_key_is_for_its_owner_only_and_never_printed(course: Course):
    secret = course.folder / ".corollary"
    assert (secret / "key").stat().st_mode & 0o777 == 0o600
    assert secret.stat().st_mode & 0o777 == 0o700
    assert repr(course.key) not in repr(course)


@pytest.mark.parametrize("damage", ["absent", "empty", "short"])
def test_a_folder_without_a_whole_key_is_no_course(course: Course, damage: str):
    key = course.folder / ".corollary" / "key"
    if damage == "absent":
        key.unlink()
    else:
        key.write_bytes(b"" if damage == "empty" else b"x" * 31)
    with pytest.raises(NotACourse) as error:
        open_course(course.folder)
    assert str(course.folder) in str(error.value)
    assert "\n" not in str(error.value)


def test_a_damaged_key_is_never_replaced(course: Course):
    (course.folder / ".corollary" / "key").write_bytes(b"x")
    with pytest.raises(NotACourse):
        create_course(course.folder, ROSTER)
    assert (course.folder / ".corollary" / "key").read_bytes() == b"x"


def test_what_was_dealt_reads_back(course: Course):
    assert read_dealt(course, "week_1") == {}
    dealt = {"ada": {"X12.5": 817, "E12.3.1s": 10**30}, "bob": {"X12.5": 0, "E12.3.1s": 1}}
    write_dealt(course, "week_1", dealt)
    assert read_dealt(course, "week_1") == dealt


def test_a_students_numbers_are_found_in_whatever_set(course: Course):
    write_dealt(course, "week_1", {"ada": {"X12.5": 817}, "bob": {"X12.5": 3}})
    write_dealt(course, "week_2", {"ada": {"P12.1": 5}})
    assert dealt_anywhere(course, "ada") == {"X12.5": 817, "P12.1": 5}
    assert dealt_anywhere(course, "bob") == {"X12.5": 3}
    assert dealt_anywhere(course, "eve") == {}


@pytest.mark.parametrize("text", ["", "[]", '{"ada": 3}', '{"ada": {"X": "y"}}', "{"])
def test_a_damaged_record_is_said_and_not_dealt_anew(course: Course, text: str):
    write_dealt(course, "week_1", {})
    (course.folder / ".corollary/dealt/week_1.json").write_text(text)
    with pytest.raises(NotACourse, match=r"week_1\.json is damaged"):
        read_dealt(course, "week_1")


def test_a_file_is_written_wholly_or_not_at_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "deep" / "file.txt"
    write_atomically(path, "before")

    def power_cut(*_: object) -> None:
        raise OSError("power cut")

    monkeypatch.setattr(os, "replace", power_cut)
    with pytest.raises(OSError, match="power cut"):
        write_atomically(path, "after")
    assert path.read_text() == "before"
    assert [each.name for each in path.parent.iterdir()] == ["file.txt"]


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
    write_atomically(notebook, "{}")
    os.utime(notebook, (1_700_000_000, 1_700_000_000))
    assert handed_in(course, "week_1", "ada") == datetime.fromtimestamp(1_700_000_000, UTC)
    (notebook.parent / "timestamp.txt").write_text("soon")
    assert handed_in(course, "week_1", "ada") == datetime.fromtimestamp(1_700_000_000, UTC)
    (notebook.parent / "timestamp.txt").write_text("2026-12-04 21:03:11 UTC\n")
    assert handed_in(course, "week_1", "ada") == datetime(2026, 12, 4, 21, 3, 11, tzinfo=UTC)


def test_submissions_are_found_even_when_renamed(course: Course):
    for student, name in [
        ("ada", "week_1"),
        ("ada", "scratch"),
        ("bob", "week_1 (2)"),
        ("eve", "one"),
        ("eve", "two"),
    ]:
        write_atomically(course.place("submitted", student, "week_1") / f"{name}.ipynb", "{}")
    write_atomically(course.place("submitted", "sam", "week_2") / "week_2.ipynb", "{}")
    assert {student: path.name for student, path in submissions(course, "week_1").items()} == {
        "ada": "week_1.ipynb",
        "bob": "week_1 (2).ipynb",
    }
