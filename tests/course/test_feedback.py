"""Feedback pages go back through the LMS, each to the student whose it is."""

from __future__ import annotations

import json
import subprocess
import zipfile
from pathlib import Path

import pytest

from corollary.course.feedback import feedback_files
from corollary.course.lms_places import NoPlaces
from corollary.records.collected import Arrival, remember
from corollary.records.files import open_course
from corollary.records.origin import set_of

from .conftest import COMMAND

ROSTER = "id,first_name,last_name,email,ID\nada,Ada,Lovelace,ada@example.org,2001\nben,Ben,Bool,ben@example.org,2002\ncyd,Cyd,Charisse,,\n"


@pytest.fixture
def course(graded: Path) -> Path:
    (graded / ".corollary" / "roster.csv").write_text(ROSTER)
    return graded


def test_by_the_numbers_of_what_was_collected(course: Path) -> None:
    opened = open_course(course)
    problem_set = set_of(opened, "one")[1]
    with pytest.raises(NoPlaces, match="give Moodle's grading worksheet or its archive"):
        feedback_files(opened, problem_set)
    names = {
        "ada": "Ada Lovelace_171_assignsubmission_file_/one.ipynb",
        "ben": "Ben Bool_172_assignsubmission_file_/one.ipynb",
    }
    remember(opened, "one", [Arrival(who, name, "", "accepted") for who, name in names.items()])
    found = feedback_files(opened, problem_set)
    assert (found.lms, found.without) == ("moodle", ("cyd",))
    assert set(found.files) == {
        "Ada Lovelace_171_assignsubmission_file_/one-feedback.html",
        "Ben Bool_172_assignsubmission_file_/one-feedback.html",
    }
    for name, page in found.files.items():
        assert page == (course / "feedback" / name[:3].lower() / "one" / "one.html").read_bytes()


def exported(course: Path, *words: object) -> subprocess.CompletedProcess[str]:
    line = [COMMAND, "export", "one", "--course", course, "-o", course.parent / "out", *words]
    return subprocess.run(
        list(map(str, line)), capture_output=True, encoding="utf-8", timeout=120, check=False
    )


def test_the_command(course: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "submissions.zip", "w") as archive:
        archive.writestr("lovelaceada_2001_5001_one.ipynb", b"")
    done = exported(course, "--to", "feedback-zip", "--ids", tmp_path / "submissions.zip", "--json")
    assert done.returncode == 0, done.stderr
    (path,) = json.loads(done.stdout)["files"]
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist() == ["lovelaceada_2001_5001_one-feedback.html"]
    assert "ben, cyd: Canvas has no number of theirs that is known" in done.stderr
