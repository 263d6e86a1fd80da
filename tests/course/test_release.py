"""Each student's own sheet on its way out, in the layouts that Moodle and Canvas give files back by."""

from __future__ import annotations

import csv
import io
import json
import re
import zipfile
from pathlib import Path

import pytest

from corollary.course.lms_places import NoPlaces
from corollary.course.release import NoSheets, Release, release
from corollary.records.files import open_course, students
from corollary.records.lms_names import Directory, lms_name
from corollary.records.origin import set_of

ROSTER = (
    "id,first_name,last_name,email,ID\n"
    "ada,Ada,Lovelace,ada@example.org,2001\nben,Ben,Bóol_x,ben@example.org,2002\ncyd,,,,\n"
)
WORKSHEET = (
    'Identifier,"Full name","Email address",Status,Grade,"Maximum Grade","Last modified (grade)","Feedback comments"\n'
    "Participant 171,Ada Lovelace,ada@example.org,No submission,,10.00,-,\n"
    "Participant 172,Somebody,ben@example.org,No submission,,10.00,-,\n"
)


@pytest.fixture
def course(handed_in: Path) -> Path:
    (handed_in / ".corollary" / "roster.csv").write_text(ROSTER)
    return handed_in


def released(course: Path, to: str, ids: Path | None = None) -> Release:
    opened = open_course(course)
    return release(opened, set_of(opened, "one")[1], to, ids)


def owner(content: bytes) -> str:
    return json.loads(content)["metadata"]["corollary"]["student"]


def unzipped(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def moodles_importer(name: str, participants: dict[int, str]) -> tuple[str, str] | None:
    """The rules of Moodle's assignfeedback_file_zip_importer: whose a file of the archive is, and what it is called there."""
    parts = name.split("/")
    while parts:
        info = parts.pop(0).split("_", 4)
        if len(info) < 4 or not info[1].isdigit() or int(info[1]) not in participants:
            continue
        if (info[2], info[3]) not in {("assignsubmission", "file"), ("assignfeedback", "file")}:
            continue
        return participants[int(info[1])], "/".join([*info[4:], *parts]).strip("/")
    return None


def canvas_importer(name: str, attachments: dict[tuple[str, str], str]) -> str | None:
    """The rules of Canvas's generate_comments_from_files: the first two numbers between underscores are user and attachment."""
    numbers = [part for part in name.split("_") if re.fullmatch(r"\d+", part)]
    return attachments.get((numbers[0], numbers[1])) if len(numbers) > 1 else None


def test_a_folder_for_each(course: Path) -> None:
    made = released(course, "folder")
    assert {name: owner(content) for name, content in made.files.items()} == {
        f"{who}/one.ipynb": who for who in ("ada", "ben", "cyd")
    }


def test_an_archive_for_each_under_a_name_that_a_person_recognises(course: Path) -> None:
    made = released(course, "zip")
    assert {name: owner(unzipped(content)["one.ipynb"]) for name, content in made.files.items()} == {
        "Lovelace Ada (ada) - one.zip": "ada",
        "Bóol x Ben (ben) - one.zip": "ben",
        "cyd - one.zip": "cyd",
    }
    assert released(course, "zip").files == made.files


def test_a_mailing(course: Path) -> None:
    made = released(course, "mail")
    rows = list(csv.DictReader(io.StringIO(made.files["mail-merge.csv"].decode("utf-8-sig"))))
    assert [(row["email"], row["subject"], owner(made.files[row["file"]])) for row in rows] == [
        ("ada@example.org", "One exercise", "ada"),
        ("ben@example.org", "One exercise", "ben"),
    ]
    assert made.without == {"cyd": "the roster has no email"}


def test_a_name_on_the_mailing_is_no_formula(course: Path) -> None:
    roster = ROSTER.replace(",Ada,Lovelace,", ',"=HYPERLINK(""http://evil.example"")",@Lovelace,')
    (course / ".corollary" / "roster.csv").write_text(roster)
    made = released(course, "mail")
    text = made.files["mail-merge.csv"].decode("utf-8-sig")
    assert text.count("\r\n") == text.count("\n") == 3
    row = next(csv.DictReader(io.StringIO(text)))
    assert row["first_name"] == '\'=HYPERLINK("http://evil.example")'
    assert row["last_name"] == "'@Lovelace"
    assert owner(made.files[row["file"]]) == "ada"


def test_moodle_gives_each_the_own_notebook(course: Path, tmp_path: Path) -> None:
    (tmp_path / "Grades.csv").write_text(WORKSHEET)
    made = released(course, "moodle", tmp_path / "Grades.csv")
    participants = {171: "ada", 172: "ben", 173: "cyd"}
    found = {
        moodles_importer(name, participants): owner(content)
        for name, content in unzipped(made.files["one-moodle.zip"]).items()
    }
    assert found == {("ada", "one.ipynb"): "ada", ("ben", "one.ipynb"): "ben"}
    assert made.without == {"cyd": "the number in Moodle is unknown; give a grading worksheet with --ids"}
    # and its own archive of all submissions says the numbers as well
    with zipfile.ZipFile(tmp_path / "all.zip", "w") as archive:
        archive.writestr("Ada Lovelace_171_assignsubmission_file/x.pdf", b"")
    assert released(course, "moodle", tmp_path / "all.zip").students == ("ada",)


def test_canvas_gives_each_who_handed_in_the_own_notebook(course: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "submissions.zip", "w") as archive:
        archive.writestr("lovelaceada_2001_5001_x.pdf", b"")
        archive.writestr("bóolxben_LATE_2002_5002_hello.txt", b"")
        archive.writestr(
            "cyd_2003_text.html", b"<p>here</p>"
        )  # Canvas (infer_comment_context_from_filename) wants a file
    made = released(course, "canvas", tmp_path / "submissions.zip")
    attachments = {("2001", "5001"): "ada", ("2002", "5002"): "ben"}
    found = {
        canvas_importer(name, attachments): owner(content)
        for name, content in unzipped(made.files["one-canvas.zip"]).items()
    }
    assert found == {"ada": "ada", "ben": "ben"}
    assert made.without["cyd"].startswith("no uploaded file in Canvas is known")


def test_what_goes_out_is_read_again_as_it_comes_back(course: Path, tmp_path: Path) -> None:
    (tmp_path / "Grades.csv").write_text(WORKSHEET)
    directory = Directory(students(open_course(course)))
    for name in unzipped(released(course, "moodle", tmp_path / "Grades.csv").files["one-moodle.zip"]):
        found = lms_name(name.split("/"))
        assert found is not None
        assert directory.of_lms(found) in ("ada", "ben")


@pytest.mark.parametrize(
    ("to", "sentence"),
    [
        ("moodle", "give Moodle's grading worksheet or its archive of all submissions with --ids"),
        ("canvas", "give Canvas's archive of all submissions with --ids"),
    ],
)
def test_without_the_numbers_of_the_lms_it_says_which_file_has_them(
    course: Path, to: str, sentence: str
) -> None:
    with pytest.raises(NoPlaces, match=sentence):
        released(course, to)


def test_a_set_that_was_never_generated(course: Path) -> None:
    for path in course.glob("release/*/one/one.ipynb"):
        path.unlink()
    with pytest.raises(NoSheets, match="nobody has a sheet of one"):
        released(course, "zip")
