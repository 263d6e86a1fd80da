"""Feedback pages go back through the LMS, each to the student whose it is."""

from __future__ import annotations

import csv
import json
import subprocess
import zipfile
from pathlib import Path

import nbformat
import pytest
from nbgrader.api import Gradebook
from tests import forked

from corollary.course.export import feedback_files
from corollary.course.lms_places import NoPlaces
from corollary.records.files import open_course
from corollary.records.origin import set_of
from corollary.records.submissions import Arrival, remember

from .conftest import COMMAND

ROSTER = "id,first_name,last_name,email,ID\nada,Ada,Lovelace,ada@example.org,2001\nben,Ben,Bool,ben@example.org,2002\ncyd,Cyd,Charisse,,\n"


@pytest.fixture
def course(graded: Path) -> Path:
    (graded / ".corollary" / "roster.csv").write_text(ROSTER)
    return graded


@pytest.mark.whole
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
    return forked.run(list(map(str, line)), capture_output=True, encoding="utf-8", timeout=120, check=False)


def test_the_command(course: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "submissions.zip", "w") as archive:
        archive.writestr("lovelaceada_2001_5001_one.ipynb", b"")
    done = exported(course, "--to", "feedback-zip", "--ids", tmp_path / "submissions.zip", "--json")
    assert done.returncode == 0, done.stderr
    (path,) = json.loads(done.stdout)["files"]
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist() == ["lovelaceada_2001_5001_one-feedback.ipynb"]
        notebook = nbformat.reads(archive.read(archive.namelist()[0]).decode(), as_version=4)
    nbformat.validate(notebook)
    text = "\n".join(cell.source for cell in notebook.cells)
    assert text.startswith("# One exercise\n\nFeedback for ada\n\n**5** of 5 points")
    assert "## X12.5 Kicking a ball" in text
    assert text.count("**Right** (1 of 1)") >= 3
    assert "Your answer, as read:" in text
    assert "ben, cyd: no file, since their number in Canvas is unknown" in done.stderr


WORKSHEET = (
    '\ufeffIdentifier,"Full name","Email address",Grade\n'
    '"Participant 171","Lovelace Ada",ada@example.org,\n'
    '"Participant 172","Ben Bool",,\n'
    '"Participant 173","Ben Bool",,\n'
    '"Participant 174","Cyd Charisse",,\n'
)


def test_a_person_of_whom_moodle_has_two_gets_nothing_that_may_be_anothers(
    course: Path, tmp_path: Path
) -> None:
    (tmp_path / "worksheet.csv").write_text(WORKSHEET, encoding="utf-8")
    done = exported(course, "--to", "feedback-zip", "--template", tmp_path / "worksheet.csv")
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(tmp_path / "out" / "one-feedback-moodle.zip") as archive:
        assert archive.namelist() == [
            "Ada Lovelace_171_assignsubmission_file_/one-feedback.html",
            "Cyd Charisse_174_assignsubmission_file_/one-feedback.html",
        ]
    assert "ben: no file, since their number in Moodle is unknown" in done.stderr


def test_what_a_person_gave_since_is_in_the_page_that_goes_back(course: Path, tmp_path: Path) -> None:
    (tmp_path / "worksheet.csv").write_text(WORKSHEET, encoding="utf-8")
    with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
        grade = book.find_grade("X12_5_a", "one", "one", "ada")
        grade.manual_score = 0.25
        book.find_comment("X12_5_a_answer", "one", "one", "ada").manual_comment = "Mind the sign, says Emmy."
        book.db.commit()
    done = exported(course, "--to", "feedback-zip", "--template", tmp_path / "worksheet.csv")
    assert done.returncode == 0, done.stderr
    assert (
        "1 score of one changed in the gradebook, not counted yet (ada); corollary grade one" in done.stderr
    )
    line = [COMMAND, "grade", "one", "--course", course, "--yes"]
    done = forked.run(list(map(str, line)), capture_output=True, encoding="utf-8", timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    done = exported(course, "--to", "feedback-zip", "--template", tmp_path / "worksheet.csv")
    assert done.returncode == 0, done.stderr
    assert "not counted yet" not in done.stderr
    with zipfile.ZipFile(tmp_path / "out" / "one-feedback-moodle.zip") as archive:
        pages = {name.split("_")[0]: archive.read(name).decode() for name in archive.namelist()}
    assert "Mind the sign, says Emmy." in pages["Ada Lovelace"]
    assert "Mind the sign, says Emmy." not in pages["Cyd Charisse"]
    with zipfile.ZipFile(tmp_path / "submissions.zip", "w") as archive:
        archive.writestr("lovelaceada_LATE_2001_5001_one.ipynb", b"")
        archive.writestr("charissecyd_2003_5003_one.html", b"")
    done = exported(course, "--to", "feedback-zip", "--ids", tmp_path / "submissions.zip")
    with zipfile.ZipFile(tmp_path / "out" / "one-feedback-canvas.zip") as archive:
        notebook, page = map(archive.read, archive.namelist())
        assert archive.namelist()[1] == "charissecyd_2003_5003_one-feedback.html"
    assert page.decode() == pages["Cyd Charisse"]
    text = "\n".join(cell.source for cell in nbformat.reads(notebook.decode(), as_version=4).cells)
    assert "**Marked by your teacher** (0.25 of 1)" in text
    assert "Mind the sign, says Emmy." in text
    assert exported(course, "--to", "moodle-grades").returncode == 0
    rows = list(csv.DictReader((tmp_path / "out" / "one-moodle-grades.csv").open(encoding="utf-8")))
    assert [row["One exercise"] for row in rows] == ["4.25", "5", "5"]
