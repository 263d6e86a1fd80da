"""A set is marked by the bank it was generated from, and one that has moved is asked for."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from corollary.problem.bank import Bank, UnknownCode, chapter_bank
from corollary.problem.roster import Student
from corollary.records.files import Course, NotACourse, create_course, open_course
from corollary.records.origin import remember, set_of, write_origin

SET = "---\ntitle: Kicks\nproblems:\n  - X12.5\n---\nKick it.\n"


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "course", [Student("ada")])


@pytest.fixture
def foreign(tmp_path: Path) -> Bank:
    """A bank of somebody's own, with one problem and the set `kicks`."""
    theirs = tmp_path / "theirs"
    for step in ("problems", "solutions"):
        shutil.copytree(chapter_bank().folder / step / "impulse", theirs / step / "impulse")
    (theirs / "problems" / "sets").mkdir()
    (theirs / "problems" / "sets" / "kicks.md").write_text(SET)
    return Bank(theirs)


def test_the_bank_it_was_generated_from_needs_no_naming(course: Course, foreign: Bank) -> None:
    write_origin(course, "kicks", foreign)
    bank, found = set_of(course, "kicks")
    assert bank.folder == foreign.folder
    assert [problem.code for problem in found.problems] == ["X12.5"]


def test_a_bank_that_has_moved_is_asked_for_and_may_be_named(
    course: Course, foreign: Bank, tmp_path: Path
) -> None:
    write_origin(course, "kicks", foreign)
    moved = foreign.folder.rename(tmp_path / "moved")
    with pytest.raises(
        UnknownCode,
        match=r"kicks was generated from the bank .*theirs, which is not there any more; .* --bank DIR.* remembers it",
    ):
        set_of(course, "kicks")
    assert set_of(course, "kicks", moved)[0].folder == moved
    assert set_of(course, "kicks")[0].folder == moved


@pytest.mark.parametrize("moving", [("course",), ("course", "theirs", "extra.md")])
def test_a_course_is_found_again_alone_or_with_what_lies_beside_it(
    course: Course, foreign: Bank, tmp_path: Path, moving: tuple[str, ...]
) -> None:
    (tmp_path / "extra.md").write_text(SET)
    write_origin(course, "extra", foreign, tmp_path / "extra.md")
    write_origin(course, "kicks", foreign)
    for place in ("here", "there"):
        (tmp_path / place).mkdir()
        for each in moving:
            shutil.move(tmp_path / each, tmp_path / place / each)
        moved = open_course(tmp_path / place / "course")
        beside = tmp_path / place if "theirs" in moving else tmp_path
        bank, found = set_of(moved, "extra")
        assert (bank.folder, found.file) == (beside / "theirs", beside / "extra.md")
        remember(moved, "extra", bank, found.file)
        assert set_of(moved, "kicks")[0].folder == beside / "theirs"
        for each in moving:
            shutil.move(tmp_path / place / each, tmp_path / each)


def test_a_bank_and_a_file_are_asked_for_once_for_all_sets(
    course: Course, foreign: Bank, tmp_path: Path
) -> None:
    for name in ("one", "two"):
        (tmp_path / f"{name}.md").write_text(SET)
        write_origin(course, name, foreign, tmp_path / f"{name}.md")
    bank = foreign.folder.rename(tmp_path / "moved")
    (tmp_path / "sets").mkdir()
    for name in ("one", "two"):
        (tmp_path / f"{name}.md").rename(tmp_path / "sets" / f"{name}.md")
    with pytest.raises(UnknownCode, match="one was generated from the bank"):
        set_of(course, "one")
    set_of(course, str(tmp_path / "sets" / "one.md"), bank)
    for name in ("one", "two"):
        found = set_of(course, name)
        assert (found[0].folder, found[1].file) == (bank, tmp_path / "sets" / f"{name}.md")


def test_the_courses_setting_stands_in_for_a_bank_that_is_gone(
    course: Course, foreign: Bank, tmp_path: Path
) -> None:
    write_origin(course, "kicks", foreign)
    foreign.folder.rename(tmp_path / "moved")
    (course.folder / "corollary.toml").write_text('bank = "../moved"\n')
    assert set_of(course, "kicks")[0].folder == tmp_path / "moved"


def test_a_set_outside_the_bank_is_found_again_by_name_or_by_path(
    course: Course, foreign: Bank, tmp_path: Path
) -> None:
    file = tmp_path / "extra.md"
    file.write_text(SET.replace("Kicks", "More kicks"))
    write_origin(course, "extra", foreign, file)
    assert set_of(course, "extra")[1].title == "More kicks"
    elsewhere = file.rename(tmp_path / "course" / "extra.md")
    bank, found = set_of(course, str(elsewhere))
    assert (bank.folder, found.title) == (foreign.folder, "More kicks")


def test_with_another_bank_it_is_still_the_sets_own_file(
    course: Course, foreign: Bank, tmp_path: Path
) -> None:
    """As after the chapter's bank was copied to correct a solution."""
    file = tmp_path / "week1.md"
    file.write_text(SET.replace("Kicks", "Week 1"))
    write_origin(course, "week1", chapter_bank(), file)
    bank, found = set_of(course, "week1", foreign.folder)
    assert (bank.folder, found.title) == (foreign.folder, "Week 1")
    file.unlink()
    with pytest.raises(UnknownCode, match=r"theirs has no set week1, and the file .* is gone") as gone:
        set_of(course, "week1", foreign.folder)
    assert "is lost" not in str(gone.value)
    (foreign.sets / "week1.md").write_text(SET)
    assert set_of(course, "week1", foreign.folder)[1].title == "Kicks"


def test_without_a_record_it_is_the_chapters_and_a_damaged_one_is_told(course: Course) -> None:
    assert set_of(course, "momentum_1")[0] == chapter_bank()
    path = course.folder / ".corollary" / "origin" / "momentum_1.json"
    path.parent.mkdir(parents=True)
    path.write_text("{")
    with pytest.raises(NotACourse, match="does not say which bank momentum_1 comes from"):
        set_of(course, "momentum_1")


def test_a_lost_record_is_said_and_the_sets_file_or_bank_may_be_named(course: Course, foreign: Bank) -> None:
    assigned = course.folder / ".corollary" / "assigned" / "kicks.json"
    assigned.parent.mkdir(parents=True)
    assigned.write_text("{}")
    with pytest.raises(UnknownCode, match=r"has numbers of kicks.*origin/kicks.json is lost.*--bank"):
        set_of(course, "kicks")
    assert set_of(course, str(foreign.sets / "kicks.md"))[0].folder == foreign.folder
    assert set_of(course, "kicks", foreign.folder)[0].folder == foreign.folder
    with pytest.raises(UnknownCode, match=r"did you mean kicks.*course has: kicks"):
        set_of(course, "kick")


def test_another_set_of_the_bank_of_its_other_sets_is_found(
    course: Course, foreign: Bank, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("COROLLARY_BANK", raising=False)
    write_origin(course, "kicks", foreign)
    (foreign.sets / "throws.md").write_text(SET.replace("Kicks", "Throws"))
    bank, found = set_of(course, "throws")
    assert (bank.folder, found.title) == (foreign.folder, "Throws")
    with pytest.raises(UnknownCode, match=rf"the bank {foreign.place} has: kicks, throws"):
        set_of(course, "rolls")


def test_the_banks_own_set_has_no_file_of_its_own_however_it_was_named(course: Course, foreign: Bank) -> None:
    write_origin(course, "kicks", foreign, foreign.sets / "kicks.md")
    assert json.loads(record(course, "kicks").read_text())["set"] is None


def test_the_name_of_a_link_is_the_sets(course: Course, foreign: Bank, tmp_path: Path) -> None:
    (tmp_path / "of_last_year.md").write_text(SET)
    (tmp_path / "extra.md").symlink_to("of_last_year.md")
    write_origin(course, "extra", foreign, tmp_path / "extra.md")
    assert set_of(course, "extra")[1].name == "extra"


def test_a_set_in_the_courses_folder_moves_with_it(course: Course, foreign: Bank, tmp_path: Path) -> None:
    (course.folder / "extra.md").write_text(SET)
    write_origin(course, "extra", foreign, course.folder / "extra.md")
    moved = open_course(course.folder.rename(tmp_path / "moved"))
    assert set_of(moved, "extra")[1].title == "Kicks"


@pytest.mark.parametrize("damage", ["null", "gone", "{"])
def test_a_file_no_longer_known_is_said_and_generating_from_it_records_it(
    course: Course, foreign: Bank, tmp_path: Path, damage: str
) -> None:
    """Null, a file that is gone, and a file cut short."""
    file = tmp_path / "extra.md"
    file.write_text(SET)
    write_origin(course, "extra", foreign, file)
    match damage:
        case "null":
            record(course, "extra").write_text(json.dumps({"bank": foreign.place, "set": None}))
        case "gone":
            file = file.rename(tmp_path / "course" / "extra.md")
        case text:
            record(course, "extra").write_text(text)
    with pytest.raises((UnknownCode, NotACourse), match=r"path/extra\.md"):
        set_of(course, "extra")
    bank, found = set_of(course, str(file))
    write_origin(course, found.name, bank, found.file)
    assert set_of(course, "extra")[1].file == file


def record(course: Course, name: str) -> Path:
    return course.record("origin", f"{name}.json")
