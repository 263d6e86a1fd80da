"""Options that were left out: the course around the working folder, and its settings, stand in for them."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from corollary.cli.ending import Refusal
from corollary.cli.left_out import completed, find_course
from corollary.problem.roster import Student
from corollary.records.files import create_course

GRADE = {"course": None, "jobs": None, "executor": "", "require": None, "bank": []}
SHOW = {"course": None, "student": None, "variant": None, "bank": []}


@pytest.fixture
def course(tmp_path: Path, monkeypatch) -> Path:
    """A course whose folder is the working folder."""
    folder = create_course(tmp_path / "mech", [Student("ada")]).folder
    monkeypatch.chdir(folder)
    monkeypatch.delenv("COROLLARY_COURSE", raising=False)
    monkeypatch.delenv("COROLLARY_BANK", raising=False)
    return folder


def test_the_course_is_the_one_around(course: Path, tmp_path: Path, monkeypatch):
    found = completed(GRADE, course_needed=True, any_bank=False)
    assert found == {"course": course, "jobs": None, "executor": "", "require": 1, "bank": []}
    monkeypatch.chdir(tmp_path)
    with pytest.raises(Refusal, match="name the course with --course, or change into its folder"):
        completed(GRADE, course_needed=True, any_bank=False)
    monkeypatch.setenv("COROLLARY_COURSE", str(course))
    assert completed(GRADE, course_needed=True, any_bank=False)["course"] == course
    other = tmp_path / "other"
    assert completed(GRADE | {"course": other}, course_needed=True, any_bank=False)["course"] == other


def test_settings_stand_in_for_what_was_left_out_and_for_nothing_else(course: Path):
    (course / "corollary.toml").write_text(
        'jobs = 3\nisolation = 0\nexecutor = "tcp://here:1"\nbank = "mine"'
    )
    found = completed(GRADE, course_needed=True, any_bank=False)
    assert (found["jobs"], found["require"], found["executor"]) == (3, 0, "tcp://here:1")
    given = completed(GRADE | {"jobs": 1, "require": 2}, course_needed=True, any_bank=False)
    assert (given["jobs"], given["require"]) == (1, 2)
    assert given["bank"] == []  # a generated set remembers its own


def test_the_courses_bank_is_the_usual_one(course: Path, monkeypatch):
    (course / "corollary.toml").write_text('bank = "mine"')
    assert completed({"bank": []}, course_needed=False, any_bank=True)["bank"] == ["mine"]
    assert completed({"bank": ["theirs"]}, course_needed=False, any_bank=True)["bank"] == ["theirs"]
    monkeypatch.setenv("COROLLARY_BANK", "chapter")
    assert completed({"bank": []}, course_needed=False, any_bank=True)["bank"] == []


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"student": "ada"}, True),
        ({}, False),  # the chapter's numbers: nobody's
        ({"student": "ada", "variant": 3}, False),
        ({"roster": Path("r.csv"), "student": ""}, False),
    ],
)
def test_a_course_that_nobody_named_gives_way(course: Path, given: dict[str, object], expected: bool):
    found = completed(SHOW | given, course_needed=False, any_bank=True)
    assert (found["course"] == course) is expected


def test_no_course_is_looked_for_before_help(course: Path):
    (course / "corollary.toml").write_text("nonsense")
    from click.testing import CliRunner

    from corollary.cli.commands import app

    assert isinstance(app, click.Group)
    assert CliRunner().invoke(app, ["key", "--help"]).exit_code == 0
    done = CliRunner().invoke(app, ["key", "X12.5"])
    assert done.exit_code == 2
    assert done.stderr.startswith("corollary: corollary.toml:1: is not TOML")


def test_a_course_is_found_from_below(tmp_path: Path):
    course = create_course(tmp_path / "mech", [Student("ada")])
    below = course.folder / "release" / "ada"
    below.mkdir(parents=True)
    assert find_course(below) == find_course(course.folder) == course.folder
    assert find_course(tmp_path) is None
    (tmp_path / "corollary.toml").write_text("")  # set up, and nothing generated yet
    assert find_course(tmp_path / "elsewhere") == tmp_path
