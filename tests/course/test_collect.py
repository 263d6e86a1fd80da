"""What an LMS gives is put where it is marked: files named and laid out as Moodle and Canvas name and lay them out."""

from __future__ import annotations

import io
import json
import os
import shutil
import stat
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest
from tests import forked

from corollary.course.collect import Collected, collect
from corollary.records.deadlines import Extension, read_deadlines, write_extension
from corollary.records.files import open_course
from corollary.records.notebook_archive import hand_ins
from corollary.records.origin import set_of
from corollary.records.report_model import report_of
from corollary.records.submissions import ACCEPTED, NOBODY, OLDER, UNCHANGED, UNUSABLE, settle_time
from corollary.records.submissions import handed_in as moment_of

from .conftest import COMMAND, grade

NOW = datetime(2026, 12, 20, tzinfo=UTC)
ROSTER = (
    "id,first_name,last_name,email,ID\n"
    "ada,Ada,Lovelace,ada@example.org,2001\nben,Ben,Bóol,ben@example.org,2002\ncyd,Cyd,Charisse,cyd@example.org,2003\n"
)
SET = "---\ntitle: One exercise\ndue: 2026-12-04T23:59+00:00\nproblems:\n  - X12.5\n---\nOne exercise.\n"


@pytest.fixture
def course(handed_in: Path) -> Path:
    """Generated, with names on the roster; what everybody is about to hand in lies in `sheets/`."""
    (handed_in / ".corollary" / "roster.csv").write_text(ROSTER)
    (handed_in / "corollary.toml").write_text('timezone = "UTC"\n')
    (handed_in.parent / "one.md").write_text(SET)
    sheets = handed_in.parent / "sheets"
    for who in ("ada", "ben", "cyd"):
        (sheets / who).mkdir(parents=True)
        shutil.move(handed_in / "submitted" / who / "one" / "one.ipynb", sheets / who / "one.ipynb")
    shutil.rmtree(handed_in / "submitted")
    return handed_in


def sheet(course: Path, who: str, **about: str) -> bytes:
    """A student's notebook, with other metadata; every one with these has other bytes."""
    notebook = json.loads((course.parent / "sheets" / who / "one.ipynb").read_text())
    notebook["metadata"]["corollary"] |= about
    return json.dumps(notebook).encode()


def archive(path: Path, files: dict[str, bytes], day: int = 3, minutes: int = 60) -> Path:
    """Each file `minutes` after the one before."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        for at, (name, content) in enumerate(files.items()):
            hour, minute = divmod(at * minutes, 60)
            made.writestr(zipfile.ZipInfo(name, (2026, 12, day, 9 + hour, minute, 0)), content)
    return path


def collected(course: Path, *sources: Path, times: Path | None = None, dry_run: bool = False) -> Collected:
    opened = open_course(course)
    problem_set = set_of(opened, str(course.parent / "one.md"))[1]
    return collect(opened, problem_set, sources, now=NOW, times=times, dry_run=dry_run)


def outcomes(found: Collected) -> dict[str, str]:
    return {each.file: each.outcome for each in found.arrivals}


def taken(course: Path) -> dict[str, bytes]:
    return {path.parts[-3]: path.read_bytes() for path in course.glob("submitted/*/one/one.ipynb")}


def when(course: Path, who: str) -> str:
    found = moment_of(open_course(course), "one", who)
    assert found is not None
    return f"{found:%d %H:%M}"


def test_what_is_nobodys_stays_in_the_report_until_it_is_somebodys(course: Path, tmp_path: Path) -> None:
    folder = tmp_path / "came"
    folder.mkdir()
    (folder / "unnamed.ipynb").write_bytes(sheet(course, "ada", student=""))
    (folder / "stranger.ipynb").write_bytes(sheet(course, "ben", student="zoe"))
    (folder / "cyd.ipynb").write_bytes(sheet(course, "cyd"))
    assert len(collected(course, folder).of(NOBODY)) == 2
    opened = open_course(course)
    problem_set = set_of(opened, str(course.parent / "one.md"))[1]
    nobodys = dict(report_of(opened, problem_set).nobodys)
    assert len(nobodys) == 2
    assert any("does not name its student" in why for why in nobodys.values())
    done = grade(course)
    assert len(done.document["nobodys"]) == 2
    page = Path(done.document["report"]).read_text()
    assert "Collected, owner unknown" in page
    assert "made for zoe, who is not on the roster" in page
    (folder / "unnamed.ipynb").rename(folder / "ada.ipynb")
    collected(course, folder)
    assert [file.rpartition("/")[2] for file, _ in report_of(opened, problem_set).nobodys] == [
        "stranger.ipynb"
    ]


def test_moodles_archive_of_all_submissions(course: Path, tmp_path: Path) -> None:
    inner = archive(tmp_path / "inner.zip", {"my work/one.ipynb": sheet(course, "ben")})
    files = {
        "Ada Lovelace_171_assignsubmission_file_/one.ipynb": sheet(course, "ada"),
        "Ben Bóol_172_assignsubmission_file/work.zip": inner.read_bytes(),  # since Moodle 4.1 without the last _
        "Ben Bóol_172_assignsubmission_onlinetext/onlinetext.html": b"<p>see file</p>",
        "Cyd Charisse_173_assignsubmission_file_/one.html": b"<html>",
    }
    zipped = archive(tmp_path / "M1-Week 1-17.zip", files)
    found = collected(course, zipped)
    assert [each.student for each in found.of(ACCEPTED)] == ["ada", "ben"]
    assert taken(course) == {"ada": sheet(course, "ada"), "ben": sheet(course, "ben")}
    assert (when(course, "ada"), when(course, "ben")) == ("03 09:00", "03 09:00")
    assert {(each.student, each.why) for each in found.of(UNUSABLE)} >= {
        ("cyd", "is not a notebook; ask for one.ipynb")
    }
    assert found.missing == ("cyd",)
    opened = open_course(course)
    report = report_of(opened, set_of(opened, str(course.parent / "one.md"))[1])
    assert report.unusable == (
        ("cyd", "Cyd Charisse_173_assignsubmission_file_/one.html: is not a notebook; ask for one.ipynb"),
    )
    before = {path: path.read_bytes() for path in course.rglob("*") if path.is_file()}
    again = collected(course, zipped)
    assert [each.student for each in again.of(UNCHANGED)] == ["ada", "ben"]
    assert {path: path.read_bytes() for path in course.rglob("*") if path.is_file()} == before


def test_canvas_archive_with_late_and_second_submissions(course: Path, tmp_path: Path) -> None:
    second = sheet(course, "ada", note="second")
    files = {
        "lovelaceada_2001_5001_one.ipynb": sheet(course, "ada"),
        "lovelaceada_2001_5009_one-1.ipynb": second,
        "bóolben_LATE_2002_5002_one.ipynb": sheet(course, "ben"),
        "somebodyelse_2003_5003_one-2.ipynb": sheet(
            course, "cyd"
        ),  # Canvas's number counts for more than the name
        "charissecyd_2003_text.html": b"<p>",
    }
    found = collected(course, archive(tmp_path / "submissions.zip", files, day=6, minutes=0))
    assert taken(course) == {"ada": second, "ben": sheet(course, "ben"), "cyd": sheet(course, "cyd")}
    assert outcomes(found)["lovelaceada_2001_5001_one.ipynb"] == OLDER
    # Canvas dates the files with the download, two days after the deadline, and says LATE of one
    assert [when(course, who) for who in ("ada", "ben", "cyd")] == ["04 23:59", "06 09:00", "04 23:59"]
    remembered = hand_ins(open_course(course), "one", "ada")
    assert set(remembered.values()) == {sheet(course, "ada"), second}


def test_a_folder_of_renamed_notebooks(course: Path, tmp_path: Path) -> None:
    inbox = tmp_path / "inbox"
    (inbox / "Bóol, Ben").mkdir(parents=True)
    (inbox / "one (1).ipynb").write_bytes(sheet(course, "ada"))
    (inbox / "Bóol, Ben" / "final.ipynb").write_bytes(sheet(course, "ben"))
    (inbox / "Lösung_Cyd_Charisse.ipynb.txt").write_bytes(sheet(course, "cyd", student=""))
    (inbox / "one.ipynb").write_bytes(sheet(course, "ada", note="later"))
    os.utime(inbox / "one (1).ipynb", (1_796_000_000, 1_796_000_000))
    os.utime(inbox / "one.ipynb", (1_796_000_600, 1_796_000_600))
    (inbox / "whose.ipynb").write_bytes(sheet(course, "ada", student="zoe"))
    (inbox / "notes.txt").write_text("hello")
    (inbox / "all.tar.gz").write_bytes(b"\x1f\x8b")
    found = collected(course, inbox)
    assert taken(course) == {
        "ada": sheet(course, "ada", note="later"),
        "ben": sheet(course, "ben"),
        "cyd": sheet(course, "cyd", student=""),
    }
    assert outcomes(found)["one (1).ipynb"] == OLDER
    why = {each.file: each.why for each in found.of(NOBODY)}
    assert why.keys() == {"whose.ipynb", "notes.txt", "all.tar.gz"}
    assert why["all.tar.gz"] == "is not a zip archive; unpack it, or ask for one.ipynb"
    # what came before does not replace what is there
    (tmp_path / "old").mkdir()
    shutil.copy2(inbox / "one (1).ipynb", tmp_path / "old")
    assert [each.why for each in collected(course, tmp_path / "old").of(OLDER)] == [
        "the file in submitted/ is newer"
    ]


def test_the_name_counts_for_more_than_what_a_notebook_says_of_itself(course: Path, tmp_path: Path) -> None:
    files = {
        "Ada Lovelace_171_assignsubmission_file_/one.ipynb": sheet(course, "ada"),
        "Cyd Charisse_173_assignsubmission_file_/one.ipynb": sheet(course, "ada"),
    }
    found = collected(course, archive(tmp_path / "all.zip", files))
    assert set(taken(course)) == {"ada", "cyd"}
    (conflict,) = found.conflicts
    assert "was handed in by cyd but made for ada; it is marked with the numbers of cyd" in conflict
    assert "made for ada, marked with the numbers of cyd" in found.of(ACCEPTED)[1].why


@pytest.mark.parametrize(
    ("outer", "inner"),
    [
        ("lovelaceada_2001_5001_work.zip", "bóolben_2002_5002_one.ipynb"),
        ("Ada Lovelace_171_assignsubmission_file_/work.zip", "Ben Bóol_172_assignsubmission_file_/one.ipynb"),
        ("ada.zip", "ben/ben.ipynb"),
    ],
)
def test_nobody_can_hand_in_as_somebody_else_by_names_in_an_archive_of_ones_own(
    course: Path, tmp_path: Path, outer: str, inner: str
) -> None:
    own = archive(tmp_path / "own.zip", {inner: sheet(course, "ben")})
    found = collected(course, archive(tmp_path / "all.zip", {outer: own.read_bytes()}))
    assert set(taken(course)) == {"ada"}
    assert "made for ben; it is marked with the numbers of ada" in found.conflicts[0]


def test_a_notebook_of_another_set_is_said_and_not_taken(course: Path, tmp_path: Path) -> None:
    found = collected(
        course, archive(tmp_path / "all.zip", {"ada/two.ipynb": sheet(course, "ada", set="two")})
    )
    assert [(each.student, each.why) for each in found.of(UNUSABLE)] == [
        ("ada", "is a notebook of two; ask for one.ipynb")
    ]
    assert taken(course) == {}


def test_a_notebook_that_is_no_sheet_is_said_to_whoever_collects(course: Path, tmp_path: Path) -> None:
    notes = {"cell_type": "markdown", "metadata": {}, "source": "My notes."}
    own = json.dumps({"cells": [notes], "metadata": {}, "nbformat": 4, "nbformat_minor": 4}).encode()
    found = collected(course, archive(tmp_path / "all.zip", {"ada/one.ipynb": own}))
    why = "has none of the exercises of one; ask for one.ipynb"
    assert [(each.student, each.why) for each in found.of(UNUSABLE)] == [("ada", why)]


def test_who_is_excused_is_not_waited_for(course: Path, tmp_path: Path) -> None:
    zipped = archive(tmp_path / "all.zip", {"ada/one.ipynb": sheet(course, "ada")})
    assert collected(course, zipped, dry_run=True).missing == ("ben", "cyd")
    write_extension(open_course(course), "one", "cyd", Extension(excused=True))
    assert collected(course, zipped).missing == ("ben",)


def test_a_dry_run_writes_nothing(course: Path, tmp_path: Path) -> None:
    before = sorted(course.rglob("*"))
    found = collected(
        course, archive(tmp_path / "all.zip", {"ada.ipynb": sheet(course, "ada")}), dry_run=True
    )
    assert [each.student for each in found.of(ACCEPTED)] == ["ada"]
    assert sorted(course.rglob("*")) == before


def test_the_time_of_a_download_makes_nobody_late(course: Path, tmp_path: Path) -> None:
    files = {f"{name}_{number}_assignsubmission_file_/one.ipynb": sheet(course, who) for name, number, who in
             (("Ada Lovelace", 171, "ada"), ("Ben Bóol", 172, "ben"))}  # fmt: skip
    zipped = archive(tmp_path / "all.zip", files, day=10, minutes=0)
    found = collected(course, zipped, dry_run=True)
    assert {each.when[:16] for each in found.of(ACCEPTED)} == {"2026-12-04 23:59"}
    assert "does not say when anything was handed in" in found.remarks[0]
    worksheet = tmp_path / "Grades-M1-Week 1-17.csv"
    worksheet.write_text(
        'Identifier,"Full name","Email address",Status,Grade,"Last modified (submission)"\n'
        'Participant 171,Ada Lovelace,ada@example.org,Submitted,,"Friday, 4 December 2026, 9:03 PM"\n'
        'Participant 172,Ben Bóol,ben@example.org,Submitted,,"Saturday, 5 December 2026, 9:03 AM"\n'
    )
    # one that a student hands in moves nobody's time
    forged = archive(
        tmp_path / "forged.zip",
        files | {"Ben Bóol_172_assignsubmission_file_/Grades.csv": worksheet.read_bytes()},
        day=10,
        minutes=0,
    )
    assert {each.when[:16] for each in collected(course, forged, dry_run=True).of(ACCEPTED)} == {
        "2026-12-04 23:59"
    }
    found = collected(course, zipped, times=worksheet)
    assert found.remarks == ()
    assert (when(course, "ada"), when(course, "ben")) == ("04 21:03", "05 09:03")


def endless(path: Path) -> bytes:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("one.ipynb", b"0" * (60 << 20))
    return path.read_bytes()


def many(path: Path) -> bytes:
    with zipfile.ZipFile(path, "w") as made:
        for number in range(65_537):
            made.writestr(zipfile.ZipInfo(f"{number}"), b"")
    return path.read_bytes()


def test_hostile_archives_hurt_nobody_else(course: Path, tmp_path: Path) -> None:
    link = zipfile.ZipInfo("ben/link.ipynb")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    locked, content = zipfile.ZipInfo("ben/locked.ipynb"), io.BytesIO()
    with zipfile.ZipFile(content, "w") as made:
        made.writestr("../../../submitted/ben/one/one.ipynb", sheet(course, "ben"))
        made.writestr("/etc/one.ipynb", b"{}")
        made.writestr(link, b"/etc/passwd")
        made.writestr(locked, sheet(course, "ben"))
        made.writestr("ben/bomb.zip", endless(tmp_path / "bomb.zip"))
        made.writestr("ben/many.zip", many(tmp_path / "many.zip"))
        made.writestr("ben/torn.zip", (tmp_path / "bomb.zip").read_bytes()[:300])
        made.writestr("ben/data.ipynb", b'{"cells": [')
        made.writestr("x\x1b[2J/\u202e.ipynb", b"{}")
        made.writestr("ada/one.ipynb", sheet(course, "ada"))
    raw = bytearray(content.getvalue())
    for at in (raw.index(b"ben/locked.ipynb") - 24, raw.rindex(b"ben/locked.ipynb") - 38):
        raw[at] |= 1  # the bit of encryption, in the header and in the directory at the end
    (tmp_path / "all.zip").write_bytes(raw)
    (tmp_path / "none.zip").write_bytes(b"PK\x05\x06 nothing")
    found = collected(course, tmp_path / "none.zip", tmp_path / "all.zip")
    assert set(taken(course)) == {"ada"}
    whys = {each.file.rpartition("/")[2]: each.why for each in found.arrivals if each.outcome != ACCEPTED}
    assert "not an archive that can be opened" in whys["none.zip"]
    assert "a name that leads out" in next(each.why for each in found.arrivals if each.file.startswith(".."))
    assert "is a link" in whys["link.ipynb"]
    assert "password" in whys["locked.ipynb"]
    assert "holds 65537 files" in whys["many.zip"]
    assert "not an archive that can be opened" in whys["torn.zip"]
    assert any("larger than 20 MB" in why for why in whys.values())
    assert not list(tmp_path.glob("submitted")) + list(course.parent.glob("submitted"))


def test_links_in_a_folder_are_not_followed(course: Path, tmp_path: Path) -> None:
    inbox = tmp_path / "inbox"
    (inbox / "ben").mkdir(parents=True)
    (inbox / "ben" / "one.ipynb").symlink_to(course.parent / "sheets" / "ben" / "one.ipynb")
    (inbox / "cyd").symlink_to(course.parent / "sheets" / "cyd")
    found = collected(course, inbox)
    assert taken(course) == {}
    assert all("link" in each.why for each in found.arrivals)
    assert {each.student for each in found.arrivals} == {"ben", "cyd"}


def test_a_students_place_that_is_a_link_is_not_written_through(course: Path, tmp_path: Path) -> None:
    (course / "submitted").mkdir()
    (course / "submitted" / "ada").symlink_to(tmp_path)
    found = collected(course, archive(tmp_path / "all.zip", {"ada.ipynb": sheet(course, "ada")}))
    assert "is a link, or lies in a linked folder" in found.of(UNUSABLE)[0].why
    assert not (tmp_path / "one").exists()


def test_whose_a_namesakes_file_is_says_the_worksheet(course: Path, tmp_path: Path) -> None:
    """Ben and Cyd have one name: who hands in a neighbour's notebook, or none, may be either, and both are told."""
    (course / ".corollary" / "roster.csv").write_text(
        ROSTER.replace("Ben,Bóol", "Finn,Berg").replace("Cyd,Charisse", "Finn,Berg")
    )
    neighbours, page = (
        f"Finn Berg_900233_assignsubmission_file_/{name}" for name in ("one.ipynb", "one.html")
    )
    own = "Finn Berg_900234_assignsubmission_file_/one.ipynb"
    files = {neighbours: sheet(course, "ada"), page: b"<html></html>", own: sheet(course, "cyd")}
    path = archive(tmp_path / "all.zip", files)
    found = collected(course, path)
    assert outcomes(found) == {neighbours: NOBODY, page: NOBODY, own: ACCEPTED}
    either = "Finn Berg can be ben or cyd; give Moodle's grading worksheet with --times, or rename the file to the id"
    assert {each.file: each.why for each in found.of(NOBODY)} == {
        neighbours: f"was made for ada; {either}",
        page: f"is not a notebook; ask for one.ipynb ({either})",
    }
    worksheet = tmp_path / "grades.csv"
    worksheet.write_text(
        "Identifier,Full name,Email address,Last modified (submission)\n"
        'Participant 900233,Finn Berg,ben@example.org,"Thursday, 3 December 2026, 9:00 AM"\n'
    )
    assert outcomes(collected(course, path, times=worksheet))[neighbours] == ACCEPTED
    assert set(taken(course)) == {"ben", "cyd"}


@pytest.mark.parametrize(
    "stranger", ["Stranger Person_9999_assignsubmission_file_/", "personstranger_9999_5009_"]
)
def test_whom_the_roster_does_not_have_hands_in_for_nobody(
    course: Path, tmp_path: Path, stranger: str
) -> None:
    own = "Ada Lovelace_4711_assignsubmission_file_/one.ipynb"
    theirs = f"{stranger}one.ipynb"
    files = {own: sheet(course, "ada"), theirs: sheet(course, "ada", note="stranger's")}
    found = collected(course, archive(tmp_path / "all.zip", files))
    assert outcomes(found) == {own: ACCEPTED, theirs: NOBODY}
    assert taken(course) == {"ada": sheet(course, "ada")}
    assert "who is not on the roster, and was made for ada" in found.of(NOBODY)[0].why
    # nor alone, or by a number that is remembered
    alone = archive(tmp_path / "later.zip", {theirs: sheet(course, "ada", note="later")}, day=4)
    assert outcomes(collected(course, alone)) == {theirs: NOBODY}
    record = course / ".corollary" / "collected" / "one.json"
    damaged = [each | {"student": "ada"} for each in json.loads(record.read_text())]
    record.write_text(json.dumps(damaged))
    assert outcomes(collected(course, alone)) == {theirs: NOBODY}
    assert taken(course) == {"ada": sheet(course, "ada")}


@pytest.mark.parametrize("name", ["Participant", "Group A-Ada Lovelace", "Ada King Lovelace"])
def test_a_name_that_may_be_the_students_leaves_it_to_the_notebook(
    course: Path, tmp_path: Path, name: str
) -> None:
    file = f"{name}_171_assignsubmission_file_/one.ipynb"
    found = collected(course, archive(tmp_path / "all.zip", {file: sheet(course, "ada")}))
    assert outcomes(found) == {file: ACCEPTED}


@pytest.mark.skipif(os.name == "nt", reason="names of files are Unicode there")
def test_a_name_that_is_not_utf_8_is_written_out(course: Path, tmp_path: Path) -> None:
    inbox = tmp_path / "inbox"
    inbox.mkdir()
    (inbox / os.fsdecode(b"b\xff.ipynb")).write_bytes(sheet(course, "ada"))
    (inbox / os.fsdecode(b"\xff.txt")).write_text("hello")
    found = collected(course, inbox)
    assert outcomes(found) == {r"b\udcff.ipynb": ACCEPTED, r"\udcff.txt": NOBODY}
    assert taken(course) == {"ada": sheet(course, "ada")}
    record = json.loads((course / ".corollary" / "collected" / "one.json").read_text("utf-8"))
    assert {each["file"] for each in record} == set(outcomes(found))


def moodle(course: Path, path: Path, day: int, note: str = "") -> Path:
    """All that Moodle has, of Ada and Ben; `note` makes Ada's another notebook."""
    files = {"Ada Lovelace_171_assignsubmission_file_/one.ipynb": sheet(course, "ada", note=note),
             "Ben Bóol_172_assignsubmission_file_/one.ipynb": sheet(course, "ben")}  # fmt: skip
    return archive(path, files, day, minutes=0)


def grades(path: Path, ada: str) -> Path:
    head = 'Identifier,"Full name","Email address",Status,Grade,"Last modified (submission)"'
    path.write_text(f'{head}\nParticipant 171,Ada Lovelace,ada@example.org,Submitted,,"{ada}"\n')
    return path


def test_a_worksheet_that_comes_later_moves_the_times_of_what_is_there(course: Path, tmp_path: Path) -> None:
    zipped = moodle(course, tmp_path / "all.zip", 10)
    collected(course, zipped)
    assert when(course, "ada") == "04 23:59"
    for moment, day in (("5 December 2026, 9:03 AM", "05 09:03"), ("4 December 2026, 8:00 AM", "04 08:00")):
        found = collected(course, zipped, times=grades(tmp_path / "grades.csv", moment))
        assert [each.student for each in found.of(UNCHANGED)] == ["ada", "ben"]
        assert (when(course, "ada"), when(course, "ben")) == (day, "04 23:59")
        said = f"times corrected by the worksheet, of files already in submitted/: ada (2026-12-{day} UTC)"
        assert said in found.remarks
    # a time that was written by hand stays
    (course / "submitted" / "ada" / "one" / "timestamp.txt").write_text("2026-12-02 10:00:00 UTC")
    collected(course, zipped, times=tmp_path / "grades.csv")
    assert when(course, "ada") == "02 10:00"


def test_of_two_files_handed_in_at_one_moment_it_is_said_by_what_one_is_taken(
    course: Path, tmp_path: Path
) -> None:
    times = grades(tmp_path / "grades.csv", "4 December 2026, 8:00 AM")
    folder = "Ada Lovelace_171_assignsubmission_file_"
    first, second = f"{folder}/one (1).ipynb", f"{folder}/one.ipynb"
    files = {first: sheet(course, "ada", note="a"), second: sheet(course, "ada", note="b")}
    found = collected(course, archive(tmp_path / "dates.zip", files, 2), times=times)
    assert taken(course)["ada"] == files[second]
    (left,) = found.of(OLDER)
    assert left.why == f"was handed in at the same moment as {second}, which has the later file date"
    assert found.conflicts == (f"ada: {first} {left.why}; that one is taken",)
    shutil.rmtree(course / "submitted/ada/one")
    found = collected(course, archive(tmp_path / "no_dates.zip", files, 2, minutes=0), times=times)
    assert taken(course)["ada"] == files[first]
    assert [each.why.rpartition(", ")[2] for each in found.of(OLDER)] == ["which comes last by name"]
    assert any("that one is taken" in each for each in found.conflicts)


def test_of_two_files_without_a_time_nothing_is_said_of_when(course: Path, tmp_path: Path) -> None:
    folder = "Ada Lovelace_171_assignsubmission_file_"
    first, second = f"{folder}/one (1).ipynb", f"{folder}/one.ipynb"
    files = {first: sheet(course, "ada", note="a"), second: sheet(course, "ada", note="b")}
    zipped = archive(tmp_path / "all.zip", files, 10, minutes=0)
    line = [COMMAND, "collect", "one", zipped, "--course", course, "--dry-run"]
    done = forked.run(list(map(str, line)), capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    why = f"has no time of handing in, nor has {first}, which comes last by name"
    assert f"ada: {second} {why}; that one is taken" in done.stderr
    assert done.stdout.count("not said") == 2
    assert "UTC" not in done.stdout


def test_a_guessed_time_makes_nothing_older(course: Path, tmp_path: Path) -> None:
    first, second = (moodle(course, tmp_path / f"{day}.zip", day, f"{day}") for day in (10, 11))
    collected(course, first, times=grades(tmp_path / "grades.csv", "5 December 2026, 9:03 AM"))
    found = collected(course, second)
    assert taken(course)["ada"] == sheet(course, "ada", note="11")
    assert "taken as newer" in found.of(ACCEPTED)[0].why
    assert when(course, "ada") == "05 09:03"  # what replaces a late one is late
    copies = hand_ins(open_course(course), "one", "ada").values()
    assert set(copies) == {sheet(course, "ada", note=day) for day in ("10", "11")}
    # what was taken before and replaced does not come back, nor does what was downloaded before the time that is known
    assert [each.student for each in collected(course, first).of(OLDER)] == ["ada"]
    assert [
        each.student for each in collected(course, moodle(course, tmp_path / "3.zip", 3, "3")).of(OLDER)
    ] == ["ada"]
    assert taken(course)["ada"] == sheet(course, "ada", note="11")
    # a real time before the guessed one
    third = moodle(course, tmp_path / "12.zip", 12, "12")
    collected(course, third, times=grades(tmp_path / "grades.csv", "4 December 2026, 8:00 AM"))
    assert (taken(course)["ada"], when(course, "ada")) == (sheet(course, "ada", note="12"), "04 08:00")


def test_a_worksheet_replaces_a_time_that_grading_guessed_though_the_deadline_is_another_since(
    course: Path, tmp_path: Path
) -> None:
    place = course / "submitted/ada/one/one.ipynb"
    place.parent.mkdir(parents=True)
    place.write_bytes(sheet(course, "ada", note=""))
    opened = open_course(course)
    problem_set = set_of(opened, str(course.parent / "one.md"))[1]
    saved = datetime(2026, 12, 10, tzinfo=UTC).timestamp()
    os.utime(place, (saved, saved))
    settle_time(opened, "one", "ada", read_deadlines(opened, problem_set).terms("ada", NOW))
    assert when(course, "ada") == "04 23:59"
    write_extension(opened, "one", "ada", Extension(until=datetime(2026, 12, 11, tzinfo=UTC)))
    times = grades(tmp_path / "grades.csv", "8 December 2026, 9:03 AM")
    collected(course, moodle(course, tmp_path / "all.zip", 12), times=times)
    assert when(course, "ada") == "08 09:03"


def test_a_real_time_counts_before_a_guess_in_one_run(course: Path, tmp_path: Path) -> None:
    """Moodle's archive is of after the deadline; what came by mail says when it was saved."""
    inbox = tmp_path / "inbox"
    inbox.mkdir()
    (inbox / "ada one.ipynb").write_bytes(sheet(course, "ada", note="by mail"))
    mailed = datetime(2026, 12, 3, 9, 0, tzinfo=UTC).timestamp()
    os.utime(inbox / "ada one.ipynb", (mailed, mailed))
    zipped = moodle(course, tmp_path / "all.zip", 10)
    found = collected(course, zipped, inbox)
    assert taken(course)["ada"] == sheet(course, "ada", note="by mail")
    assert when(course, "ada") == "03 09:00"
    (conflict,) = found.conflicts
    assert conflict.startswith(
        "ada: Ada Lovelace_171_assignsubmission_file_/one.ipynb has no time of handing in"
    )
    # with the worksheet both are known, and the later is taken
    shutil.rmtree(course / "submitted")
    times = grades(tmp_path / "grades.csv", "4 December 2026, 8:00 AM")
    assert collected(course, zipped, inbox, times=times).conflicts == ()
    assert (taken(course)["ada"], when(course, "ada")) == (sheet(course, "ada", note=""), "04 08:00")


def test_of_two_downloads_the_later_is_taken_though_the_first_said_late(course: Path, tmp_path: Path) -> None:
    """Canvas says LATE, and no time; before the deadline was moved, and not after."""
    first = archive(tmp_path / "1.zip", {"lovelaceada_LATE_2001_5001_one.ipynb": sheet(course, "ada")}, day=6)
    content = sheet(course, "ada", note="second")
    second = archive(tmp_path / "2.zip", {"lovelaceada_2001_5009_one-1.ipynb": content}, day=7)
    collected(course, first, second)
    assert (taken(course), when(course, "ada")) == ({"ada": content}, "04 23:59")


def test_a_download_of_a_large_class_takes_its_time_and_makes_nobody_late(
    course: Path, tmp_path: Path
) -> None:
    files = {f"{name}_{number}_assignsubmission_file_/one.ipynb": sheet(course, who) for name, number, who in
             (("Ada Lovelace", 171, "ada"), ("Ben Bóol", 172, "ben"), ("Cyd Charisse", 173, "cyd"))}  # fmt: skip
    collected(course, archive(tmp_path / "all.zip", files, day=10, minutes=4))
    assert {when(course, who) for who in ("ada", "ben", "cyd")} == {"04 23:59"}


def test_an_archive_that_was_unpacked_makes_nobody_late(course: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(moodle(course, tmp_path / "all.zip", 10)) as zipped:
        zipped.extractall(tmp_path / "all")
    unpacked = datetime(2026, 12, 10, 9, 0, tzinfo=UTC).timestamp()
    for path in (tmp_path / "all").rglob("*.ipynb"):
        os.utime(path, (unpacked, unpacked))
    found = collected(course, tmp_path / "all")
    assert {when(course, who) for who in ("ada", "ben")} == {"04 23:59"}
    assert "the folder does not say when anything was handed in" in found.remarks[0]


def test_a_deadline_in_the_hour_that_comes_twice_is_the_later_of_the_two(
    course: Path, tmp_path: Path
) -> None:
    (course / "corollary.toml").write_text('timezone = "Europe/Oslo"\n')
    (course.parent / "one.md").write_text(SET.replace("2026-12-04T23:59+00:00", "2026-10-25 02:30"))
    zipped = moodle(course, tmp_path / "all.zip", 10)
    assert {each.when[:16] for each in collected(course, zipped).of(ACCEPTED)} == {"2026-10-25 01:30"}
    opened = open_course(course)
    problem_set = set_of(opened, str(course.parent / "one.md"))[1]
    assert problem_set.due is not None
    assert problem_set.due.timestamp() == datetime(2026, 10, 25, 1, 30, tzinfo=UTC).timestamp()
    # what came again is known for the guess it was
    content = sheet(course, "ada", note="again")
    again = archive(
        tmp_path / "2.zip", {"Ada Lovelace_171_assignsubmission_file_/one.ipynb": content}, day=11
    )
    collected(course, again)
    assert (taken(course)["ada"], when(course, "ada")) == (content, "25 01:30")


ADAS, OTHERS = (
    "Ada Lovelace_17_assignsubmission_file_/one.ipynb",
    "Ada Lovelace_99_assignsubmission_file_/one.ipynb",
)


@pytest.mark.parametrize("says", ["ada", "ben"])
def test_two_numbers_under_one_name_replace_nobodys_hand_in(course: Path, tmp_path: Path, says: str) -> None:
    """A namesake, or somebody who took her display name: nothing tells them apart, so that a person has to."""
    both = {
        ADAS: sheet(course, "ada"),
        OTHERS: sheet(course, says, note="other"),
        "Ben Bóol_18_assignsubmission_file_/one.ipynb": sheet(course, "ben"),
    }
    found = collected(course, archive(tmp_path / "all.zip", both))
    assert outcomes(found) == {
        ADAS: NOBODY,
        OTHERS: NOBODY,
        "Ben Bóol_18_assignsubmission_file_/one.ipynb": ACCEPTED,
    }
    assert any("Ada Lovelace (ada) has 2 numbers in Moodle (17, 99)" in each for each in found.conflicts)
    assert all("rename the right file to ada.ipynb" in each.why for each in found.of(NOBODY))
    assert set(taken(course)) == {"ben"}


def test_a_second_number_does_not_replace_what_came_under_the_first(course: Path, tmp_path: Path) -> None:
    ben = "Ben Bóol_18_assignsubmission_file_/one.ipynb"
    collected(course, archive(tmp_path / "1.zip", {ADAS: sheet(course, "ada"), ben: sheet(course, "ben")}))
    later = {
        ADAS: sheet(course, "ada"),
        ben: sheet(course, "ben"),
        OTHERS: sheet(course, "ada", note="other"),
    }
    found = collected(course, archive(tmp_path / "2.zip", later, day=4))
    assert outcomes(found) == {ADAS: UNCHANGED, ben: UNCHANGED, OTHERS: NOBODY}
    assert "Ada Lovelace (ada) has the number 17" in found.of(NOBODY)[0].why
    alone = {OTHERS: sheet(course, "ada", note="other"), ben: sheet(course, "ben")}
    assert outcomes(collected(course, archive(tmp_path / "3.zip", alone, day=5)))[OTHERS] == NOBODY
    assert taken(course)["ada"] == sheet(course, "ada")
    lonely = {OTHERS: sheet(course, "ada", note="other")}
    found = collected(course, archive(tmp_path / "4.zip", lonely, day=5))
    assert outcomes(found) == {OTHERS: NOBODY}
    assert any(
        "none of their files is taken (the student's number is 17)" in each for each in found.conflicts
    )
    assert taken(course)["ada"] == sheet(course, "ada")
    # a second assignment of Moodle's, for those who are late, has other numbers for everybody
    anew = {
        "Ada Lovelace_501_assignsubmission_file_/one.ipynb": sheet(course, "ada", note="anew"),
        "Ben Bóol_502_assignsubmission_file_/one.ipynb": sheet(course, "ben", note="anew"),
    }
    assert outcomes(collected(course, archive(tmp_path / "5.zip", anew, day=6))) == dict.fromkeys(
        anew, ACCEPTED
    )


def test_a_file_that_is_renamed_to_its_student_keeps_the_time_of_its_hand_in(
    course: Path, tmp_path: Path
) -> None:
    theirs = sheet(course, "ada")
    both = {ADAS: theirs, OTHERS: sheet(course, "ada", note="other")}
    zipped = archive(tmp_path / "all.zip", both, day=3)
    assert set(outcomes(collected(course, zipped)).values()) == {NOBODY}
    (renamed := tmp_path / "ada.ipynb").write_bytes(theirs)
    late = datetime(2026, 12, 20, 9, 0, tzinfo=UTC).timestamp()
    os.utime(renamed, (late, late))
    worksheet = tmp_path / "grades.csv"
    worksheet.write_text(
        "Identifier,Full name,Last modified (submission)\n"
        'Participant 17,Ada Lovelace,"Thursday, 3 December 2026, 9:00 AM"\n'
    )
    collected(course, renamed, times=worksheet)
    assert (taken(course)["ada"], when(course, "ada")) == (theirs, "03 09:00")
    # from then on her number is known
    assert outcomes(collected(course, zipped)) == {ADAS: UNCHANGED, OTHERS: NOBODY}


def test_a_file_that_is_renamed_to_its_student_is_late_by_no_time_of_a_copy(
    course: Path, tmp_path: Path
) -> None:
    theirs = sheet(course, "ada")
    collected(
        course, archive(tmp_path / "all.zip", {ADAS: theirs, OTHERS: sheet(course, "ada", note="x")}, day=3)
    )
    (renamed := tmp_path / "ada.ipynb").write_bytes(theirs)
    late = datetime(2026, 12, 20, 9, 0, tzinfo=UTC).timestamp()
    os.utime(renamed, (late, late))
    found = collected(course, renamed)
    assert when(course, "ada") == "04 23:59"
    assert "does not say when anything was handed in" in found.remarks[0]


@pytest.mark.parametrize("with_worksheet", [True, False])
def test_a_file_that_was_saved_again_and_renamed_is_late_by_no_time_of_a_copy(
    course: Path, tmp_path: Path, with_worksheet: bool
) -> None:
    theirs = sheet(course, "ada")
    worksheet = tmp_path / "grades.csv"
    worksheet.write_text(
        "Identifier,Full name,Email address,Last modified (submission)\n"
        'Participant 17,Ada Lovelace,ada@example.org,"Thursday, 3 December 2026, 9:00 AM"\n'
    )
    collected(
        course, archive(tmp_path / "all.zip", {ADAS: theirs, OTHERS: sheet(course, "ada", note="x")}, day=3)
    )
    (renamed := tmp_path / "ada.ipynb").write_text(json.dumps(json.loads(theirs), indent=3))
    late = datetime(2026, 12, 20, 9, 0, tzinfo=UTC).timestamp()
    os.utime(renamed, (late, late))
    collected(course, renamed, times=worksheet if with_worksheet else None)
    assert when(course, "ada") == ("03 09:00" if with_worksheet else "04 23:59")


def test_a_request_under_the_number_of_a_stranger_is_nobodys(course: Path, tmp_path: Path) -> None:
    worksheet = tmp_path / "grades.csv"
    worksheet.write_text(
        "Identifier,Full name,Email address,Last modified (submission)\n"
        'Participant 17,Ada Lovelace,ada@example.org,"Thursday, 3 December 2026, 9:00 AM"\n'
    )
    both = {ADAS: sheet(course, "ada"), OTHERS: sheet(course, "ada", note="other")}
    found = collected(course, archive(tmp_path / "all.zip", both), times=worksheet)
    assert outcomes(found) == {ADAS: ACCEPTED, OTHERS: NOBODY}
    assert not any("--times" in each for each in (*found.conflicts, found.of(NOBODY)[0].why))
    form = b"## X12.5 (a)\n\nI went by p = 2mv.\n"
    asked = {name.replace("one.ipynb", "request_one.md"): form for name in both}
    found = collected(course, archive(tmp_path / "asked.zip", asked, day=5))
    assert [each.student for each in found.requests] == ["ada"]
    assert outcomes(found) == {OTHERS.replace("one.ipynb", "request_one.md"): NOBODY}


def test_the_worksheet_tells_by_address_whose_a_number_is(course: Path, tmp_path: Path) -> None:
    worksheet = tmp_path / "grades.csv"
    worksheet.write_text(
        "Identifier,Full name,Email address,Last modified (submission)\n"
        'Participant 17,Ada Lovelace,ada@example.org,"Thursday, 3 December 2026, 9:00 AM"\n'
        'Participant 99,Ada Lovelace,ben@example.org,"Thursday, 3 December 2026, 10:00 AM"\n'
    )
    path = archive(tmp_path / "all.zip", {ADAS: sheet(course, "ada"), OTHERS: sheet(course, "ben")})
    found = collected(course, path, times=worksheet)
    assert outcomes(found) == {ADAS: ACCEPTED, OTHERS: NOBODY}
    assert "the number is that of Ben Bóol (ben)" in found.of(NOBODY)[0].why
    assert any("only the file under 17 is taken" in each for each in found.conflicts)
