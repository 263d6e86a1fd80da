"""A time that nobody said makes nobody late, and what stood in its place is not lost."""

from __future__ import annotations

import os
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from corollary.atomic import write_whole
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.deadlines import Terms
from corollary.records.files import Course, create_course
from corollary.records.submissions import (
    GuessedTime,
    all_guessed,
    guessed_time,
    handed_in,
    lateness,
    settle_time,
    why_guessed,
)

SET = find_set(chapter_bank(), "momentum_1")
DUE = datetime(2023, 11, 14, 12, tzinfo=UTC)
AFTER = datetime.fromtimestamp(1_700_000_000, UTC)  # ten hours later
TERMS = Terms(DUE)


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """Ada's folder, with a notebook that is from after the deadline."""
    course = create_course(tmp_path / "mech", [Student("ada")])
    notebook = course.notebook("submitted", "ada", SET.name)
    write_whole(notebook, "{}")
    os.utime(notebook, (AFTER.timestamp(), AFTER.timestamp()))
    return notebook.parent


def course_of(place: Path) -> Course:
    return create_course(place.parents[2], [Student("ada")])


def settled(place: Path, terms: Terms = TERMS) -> str:
    """What the instructor reads of it."""
    settle_time(course_of(place), SET.name, "ada", terms)
    guess = guessed_time(course_of(place), SET.name, "ada")
    return why_guessed(SET.name, "ada", guess) if guess is not None else ""


def late(place: Path, terms: Terms = TERMS) -> float:
    return lateness(course_of(place), SET, "ada", terms).seconds


@pytest.mark.parametrize("kind", ["words", "bytes", "empty", "long", "pipe", "link", "folder", "none"])
def test_a_guess_makes_nobody_late_and_what_was_there_is_kept(kind: str, place: Path) -> None:
    stamp = place / "timestamp.txt"
    content = {
        "words": b"4th of December, 9 pm",
        "bytes": b"\xff\xfe2\x000",
        "empty": b"",
        "long": b"9" * 5000,
    }.get(kind)
    if content is not None:
        stamp.write_bytes(content)
    elif kind == "pipe":
        os.mkfifo(stamp)
    elif kind == "link":
        stamp.symlink_to("/etc/hostname")
    elif kind == "folder":
        stamp.mkdir()
        (stamp / "inside").write_text("9 pm")
    assert late(place) == 0.0
    for _ in range(2):
        said = settled(place)
        assert "counted as in time" in said
        assert ("held no time but" in said, "was empty" in said) == {
            "words": (True, False),
            "bytes": (True, False),
            "none": (False, False),
        }.get(kind, (False, True))
    assert late(place) == 0.0
    assert handed_in(course_of(place), SET.name, "ada") == DUE
    assert stamp.read_text() == "2023-11-14 12:00:00.000000 UTC"
    aside = place.parents[2] / ".corollary/times/momentum_1/ada.1.txt"
    if content is not None:
        assert aside.read_bytes() == content
    elif kind == "folder":
        assert (aside / "inside").read_text() == "9 pm"
    else:
        assert os.path.lexists(aside) == (kind != "none")
    # The deadline is moved to before the guess: a guess is no reason to be late.
    assert late(place, Terms(DUE - timedelta(days=3))) == 0.0


def test_the_time_that_is_found_out_later_counts(place: Path) -> None:
    (place / "timestamp.txt").write_text("soon")
    assert "'soon'" in settled(place)
    (place / "timestamp.txt").write_text("2023-11-14 14:00:00 UTC")
    assert settled(place) == ""
    assert late(place) == 7200.0
    (place / "timestamp.txt").write_text("sooner")  # a second one is kept beside the first
    assert "'sooner'" in settled(place)
    kept = place.parents[2] / ".corollary/times/momentum_1"
    assert [(kept / f"ada.{n}.txt").read_text() for n in (1, 2)] == ["soon", "sooner"]


def test_one_line_names_all_of_whom_there_is_the_same_to_say() -> None:
    unsaid, early = GuessedTime(AFTER, after_due=True), GuessedTime(AFTER)
    lines = all_guessed(
        "words", {"ada": unsaid, "ben": early, "cyd": unsaid, "dag": GuessedTime(AFTER, "soon")}
    )
    both, alone = lines
    assert both.startswith("ada, cyd: no time of handing in")
    assert both.endswith("write the time into submitted/STUDENT/words/timestamp.txt if you know it")
    assert alone.startswith("dag: timestamp.txt held no time but 'soon'")
    assert alone.endswith("write the time into submitted/dag/words/timestamp.txt if you know it")


def test_what_a_student_hands_in_is_no_word_on_whether_a_time_was_guessed(place: Path) -> None:
    """A record of ours lies where students put nothing: a file of theirs that looks like one changes nothing."""
    (place / "timestamp.txt").write_text("2023-11-14 14:00:00 UTC")
    for name in ("ada.json", "timestamp.json", "ada.1.txt"):
        (place / name).write_text('{"moment": "2023-11-14T14:00:00Z"}')
    assert settled(place) == ""
    assert late(place) == 7200.0


def test_a_file_of_before_the_deadline_has_its_own_time_and_nobody_is_bothered(place: Path) -> None:
    terms = Terms(AFTER + timedelta(days=1))
    assert settled(place, terms) == ""
    assert handed_in(course_of(place), SET.name, "ada") == AFTER
    assert late(place, terms) == 0.0


def test_a_folder_that_leads_to_another_student_gets_no_file(place: Path) -> None:
    (place.parents[1] / "bob").symlink_to("ada")
    settle_time(course_of(place), SET.name, "bob", TERMS)
    assert not (place / "timestamp.txt").exists()
