"""Who has until when, and what may be seen by then."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.deadlines import (
    Deadlines,
    Extension,
    all_extensions,
    read_deadlines,
    remove_extension,
    reveal_by_hand,
    write_extension,
)
from corollary.records.files import Course, NotACourse, create_course

DUE = datetime(2026, 12, 4, 23, 59, tzinfo=ZoneInfo("Europe/Oslo"))
WEEK, HOUR = timedelta(days=7), timedelta(hours=1)
SET = find_set(chapter_bank(), "momentum_1")


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "mech", [Student("ada"), Student("ben")])


def test_an_extension_is_ones_own_and_never_shortens_what_everybody_has():
    later = {"ada": Extension((DUE + WEEK).astimezone(UTC)), "ben": Extension(DUE - WEEK)}
    found = Deadlines(DUE, "no", later)
    assert (found.of("ada"), found.of("ben"), found.of("cyd"), found.last) == (
        DUE + WEEK,
        DUE,
        DUE,
        DUE + WEEK,
    )
    assert found.of("ada").tzinfo is DUE.tzinfo  # students read it in the course's zone
    assert Deadlines(None, "no", later).of("ada") is None


@pytest.mark.parametrize(
    ("reveal", "ben", "ada"),
    # What each sees an hour before the date, an hour after it, and an hour after Ada's extension.
    [
        ("no", (False, False, False), (False, False, False)),
        ("after due", (False, True, True), (False, False, True)),
        ("after extensions", (False, False, True), (False, False, True)),
        ("by hand", (False, False, False), (False, False, False)),
    ],
)
def test_what_is_revealed_when(reveal, ben, ada):
    found = Deadlines(DUE, reveal, {"ada": Extension(DUE + WEEK)})
    moments = (DUE - HOUR, DUE + HOUR, DUE + WEEK + HOUR)
    assert tuple(found.terms("ben", now).reveal for now in moments) == ben
    assert tuple(found.terms("ada", now).reveal for now in moments) == ada
    assert not found.terms("ben", DUE).reveal  # it is due at that very moment: in time, and still secret


def test_without_a_date_there_is_nothing_to_wait_for():
    now = DUE
    assert Deadlines(None, "after due", {}).terms("ada", now).reveal
    assert Deadlines(None, "after extensions", {}).terms("ada", now).reveal
    assert not Deadlines(None, "by hand", {}).terms("ada", now).reveal
    assert Deadlines(DUE, "by hand", {}, by_hand=True).terms("ada", now).reveal
    assert not Deadlines(DUE, "no", {}, by_hand=True).terms("ada", now + WEEK).reveal


def test_an_excused_student_holds_nobody_up():
    found = Deadlines(DUE, "after extensions", {"ada": Extension(DUE + WEEK, excused=True)})
    assert found.last == DUE
    assert found.excused("ada")
    assert not found.early("ada", DUE - HOUR)
    assert found.early("ben", DUE - HOUR)


def test_what_is_recorded_is_read_again(course: Course):
    assert read_deadlines(course, SET).extensions == {}
    write_extension(course, SET.name, "ada", Extension(DUE + WEEK))
    write_extension(course, SET.name, "ben", Extension(excused=True))
    found = read_deadlines(course, SET)
    assert found.of("ada") == DUE + WEEK
    assert found.excused("ben")
    assert all_extensions(course) == {SET.name: found.extensions}
    assert remove_extension(course, SET.name, "ada")
    assert not remove_extension(course, SET.name, "ada")
    assert read_deadlines(course, SET).of("ada") == SET.due
    reveal_by_hand(course, SET.name)
    assert read_deadlines(course, SET).by_hand


@pytest.mark.parametrize("content", ["", "{", '{"until": "soon"}', "[]"])
def test_a_damaged_record_is_no_silent_loss_of_a_deadline(course: Course, content: str):
    write_extension(course, SET.name, "ada", Extension(DUE))
    course.record("extensions", SET.name).joinpath("ada.json").write_text(content)
    with pytest.raises(NotACourse, match=r"ada\.json is damaged .* corollary extend"):
        read_deadlines(course, SET)
