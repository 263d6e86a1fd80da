"""A course folder: made once, opened for ever, and never half written."""

from __future__ import annotations

from pathlib import Path
from threading import Event, Thread
from time import sleep

import pytest

from corollary.problem.roster import Student
from corollary.records.files import (
    BeingGraded,
    Course,
    NotACourse,
    create_course,
    find_student,
    one_writer,
    open_course,
    students,
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


@pytest.mark.parametrize(
    "content", ["", "id,first_name\nada,Ada\n", "id,first_name,last_name,email\n/etc,a,b,c\n"]
)
def test_a_damaged_roster_is_named(course: Course, content: str):
    (course.folder / ".corollary/roster.csv").write_text(content)
    with pytest.raises(NotACourse, match=r"is damaged: .*roster\.csv:\d: .*generate again with --roster"):
        students(course)


def test_an_id_that_could_not_name_a_folder_is_remembered(course: Course):
    roster = [
        Student("Lukasz-c57b4f3a", "Łukasz", ids=(("id", "Łukasz"), ("Login", "lz"))),
        Student("ada", "Ada", "Lovelace", ids=(("id", "ada"),)),
    ]
    create_course(course.folder, roster)
    assert [each.ids for each in students(course)] == [each.ids for each in roster]
    assert find_student(course, "Łukasz").id == "Lukasz-c57b4f3a"


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


def test_a_second_writer_is_told_and_the_next_one_may(tmp_path: Path) -> None:
    course = create_course(tmp_path / "course", [Student("ada")])
    before = sorted(path.name for path in (course.folder / ".corollary").iterdir())
    with (
        one_writer(course),
        pytest.raises(BeingGraded, match="another corollary command is running"),
        one_writer(course),
    ):
        pass
    with one_writer(course):
        assert sorted(path.name for path in (course.folder / ".corollary").iterdir()) == before


def test_a_second_writer_waits_for_one_that_is_soon_done(tmp_path: Path) -> None:
    course = create_course(tmp_path / "course", [Student("ada")])
    begun = Event()

    def first() -> None:
        with one_writer(course):
            begun.set()
            sleep(0.3)

    thread = Thread(target=first)
    thread.start()
    begun.wait()
    with one_writer(course):
        thread.join()
