"""One student's data in a course after a set: exported, taken out of every file, archived; held by searching all bytes."""

from __future__ import annotations

import gzip
import io
import json
import shutil
import sqlite3
import tarfile
import zipfile
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from click.testing import CliRunner
from tests import forked

from corollary.cli.commands import app

SET = "---\ntitle: One\nproblems: [X12.5, S12.0]\n---\nTwo exercises.\n"
ROSTER = "id,first_name,last_name,email\nadal7,Ada,Quillfeather,ada.q@uni.example\nbenb8,Ben,Okafor,ben.o@uni.example\ncydc9,Cyd,Marsh,cyd.m@uni.example\n"
WORDS = "Zweifelsohne unpredictable galaxies"  # of Ada's answer in words
COMMENT = "A remark for nobody else: Quagmire"
NUMBER = "31.4159265358"
TRACES = ("adal7", "Quillfeather", "ada.q@uni.example", "770017", "Zweifelsohne", "Quagmire", NUMBER)
MARKS = {"benb8": 5.0, "cydc9": 4.0}


def run(*words: object, status: int = 0) -> str:
    done = CliRunner().invoke(app, [str(word) for word in words], catch_exceptions=False)
    assert done.exit_code == status, done.output
    return done.stdout


def command(*words: object) -> str:
    done = forked.run([forked.COMMAND, *words], capture_output=True, encoding="utf-8", timeout=200)
    assert done.returncode == 0, done.stderr
    return done.stdout


def answered(sheet: Path, answers: dict[str, str]) -> str:
    """The notebook with these right sides, by the answer's name."""
    notebook = json.loads(sheet.read_text("utf-8"))
    for cell in notebook["cells"]:
        for name, text in answers.items():
            if cell["metadata"].get("nbgrader", {}).get("grade_id") in (
                f"{name}_answer",
                f"{name}" if cell["cell_type"] == "markdown" else "",
            ):
                cell["source"] = f"{name} = {text}" if cell["cell_type"] == "code" else text
    return json.dumps(notebook)


pytestmark = pytest.mark.whole  # the course alone takes 15 s


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A course of three with everything that a term leaves behind: an LMS's archive, marks by hand, copies of the gradebook."""
    folder = tmp_path_factory.mktemp("term")
    course = folder / "mech"
    (folder / "one.md").write_text(SET)
    (folder / "roster.csv").write_text(ROSTER)
    run("generate", folder / "one.md", "--roster", folder / "roster.csv", "--course", course)
    sheets = {each: course / "release" / each / "one" / "one.ipynb" for each in ("adal7", "benb8", "cydc9")}
    with zipfile.ZipFile(course / "downloads.zip", "w") as archive:
        for person, number, name in (("Ada Quillfeather", 770017, "adal7"), ("Ben Okafor", 770018, "benb8")):
            answers = (
                {"X12_5_a": f"'{NUMBER} kg m/s'", "S12_0_a": WORDS}
                if name == "adal7"
                else {"S12_0_a": "Theirs"}
            )
            archive.writestr(
                f"{person}_{number}_assignsubmission_file_/one.ipynb", answered(sheets[name], answers)
            )
    run("collect", "one", course / "downloads.zip", "--course", course)
    place = course / "submitted" / "cydc9" / "one"
    place.mkdir(parents=True)
    (place / "one.ipynb").write_text(answered(sheets["cydc9"], {"S12_0_a": "Cyd's own words"}))
    command("grade", "one", "--course", course, "--jobs", 1)
    marks = folder / "marks.csv"
    marks.write_text(f"student,part,points,comment\nadal7,S12.0a,2,{COMMENT}\nbenb8,S12.0a,3,Good\n")
    run("mark", "one", "--from", marks, "--course", course)
    run("release", "one", "--to", "mail", "--course", course, "-o", course / "given_out")
    shutil.copy(course / "gradebook.db", course / "gradebook.db.before")
    with tarfile.open(course / "old.tar.gz", "w:gz") as archive:
        archive.add(course / "submitted", "backup/submitted")
        archive.add(course / "gradebook.db", "backup/gradebook.db")
    return course


@pytest.fixture
def course(term: Path, tmp_path: Path) -> Path:
    shutil.copy(term.parent / "one.md", tmp_path / "one.md")
    return Path(shutil.copytree(term, tmp_path / "mech"))


def unpacked(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    """A file, and whatever lies in it."""
    yield name, name.encode() + b"\n" + content
    if zipfile.is_zipfile(io.BytesIO(content)):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            for each in archive.namelist():
                yield from unpacked(f"{name}/{each}", archive.read(each))
    elif content[:2] == b"\x1f\x8b":
        with tarfile.open(fileobj=io.BytesIO(gzip.decompress(content))) as archive:
            for each in archive:
                file = archive.extractfile(each)
                yield from unpacked(f"{name}/{each.name}", file.read() if file else b"")


def found(folder: Path) -> dict[str, set[str]]:
    """The traces of Ada in every byte below a folder, by place: names of files, texts, archives, pages of databases."""
    places: dict[str, set[str]] = {}
    for path in folder.rglob("*"):
        if path.is_file():
            for name, content in unpacked(str(path.relative_to(folder)), path.read_bytes()):
                if met := {trace for trace in TRACES if trace.encode() in content}:
                    places[name] = met
    return places


def rows(gradebook: Path) -> list[tuple[object, ...]]:
    with closing(sqlite3.connect(gradebook)) as database:
        return database.execute(
            "SELECT s.student_id, g.auto_score, g.manual_score, g.needs_manual_grade FROM grade g JOIN submitted_notebook n "
            "ON g.notebook_id = n.id JOIN submitted_assignment s ON n.assignment_id = s.id WHERE s.student_id != 'adal7' ORDER BY g.id"
        ).fetchall()


def of_others(course: Path) -> dict[str, bytes]:
    """Every file of the others: hand-ins, marks, feedback."""
    return {
        str(path.relative_to(course)): path.read_bytes()
        for path in course.rglob("*")
        if path.is_file() and {"benb8", "cydc9", "benb8.json", "cydc9.json"} & set(path.parts)
    }


def test_nothing_of_a_student_is_left_and_the_others_marks_stay(course: Path) -> None:
    before, others, marks = found(course), of_others(course), rows(course / "gradebook.db")
    assert set().union(*before.values()) == set(TRACES)
    assert marks
    done = json.loads(run("forget", "adal7", "--course", course, "--yes", "--json"))
    assert (done["done"], done["left"]) == (True, {})
    assert found(course) == {}
    assert of_others(course) == others
    assert rows(course / "gradebook.db") == rows(course / "gradebook.db.before") == marks
    with zipfile.ZipFile(course / "downloads.zip") as archive:
        assert archive.namelist() == ["Ben Okafor_770018_assignsubmission_file_/one.ipynb"]
    report = json.loads(run("report", "one", "--course", course, "--json"))
    assert set(report["students"]) == {"benb8", "cydc9"}
    assert "graded 0, unchanged 2" in command("grade", "one", "--course", course, "--jobs", 1)


def test_without_an_answer_nothing_is_changed(course: Path) -> None:
    before = {path: path.read_bytes() for path in course.rglob("*") if path.is_file()}
    run("forget", "adal7", "--course", course, status=1)
    shown = json.loads(run("forget", "ada.q@uni.example", "--course", course, "--dry-run", "--json"))
    assert {path: path.read_bytes() for path in course.rglob("*") if path.is_file()} == before
    assert shown["student"] == "adal7"
    places = {each["path"] for each in shown["places"]}
    assert {"gradebook.db", ".corollary/roster.csv", "downloads.zip", "reports/one.html"} <= places
    run("forget", "nobody", "--course", course, status=2)


def test_a_run_that_was_cut_short_is_run_again(course: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from corollary.course import personal_data

    change, count = personal_data._change, 0

    def until_the_fifth(*words: object, **options: object) -> None:
        nonlocal count
        count += 1
        if count == 5:
            raise KeyboardInterrupt
        change(*words, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(personal_data, "_change", until_the_fifth)
    run("forget", "adal7", "--course", course, "--yes", status=130)
    assert found(course)
    monkeypatch.setattr(personal_data, "_change", change)
    run("forget", "adal7", "--course", course, "--yes")
    assert found(course) == {}
    run("forget", "adal7", "--course", course, "--yes")  # the log knows them, though no file does
    assert "adal7" not in (course / ".corollary" / "forgotten" / "log.jsonl").read_text()
    (course.parent / "roster.csv").write_text(ROSTER)
    place = ("--roster", course.parent / "roster.csv", "--course", course)
    done = CliRunner().invoke(app, list(map(str, ("generate", course.parent / "one.md", *place, "--yes"))))
    assert "removed with corollary forget, and on the roster: adal7;" in done.stderr


def test_what_somebody_else_wrote_is_named_and_not_changed(course: Path) -> None:
    (course / "notes.md").write_text("Asked by adal7: more time?\n")
    sheet = course / "submitted" / "benb8" / "one" / "one.ipynb"
    sheet.write_text(sheet.read_text("utf-8").replace("Theirs", "With Ada Quillfeather"))
    before = sheet.read_bytes()
    done = json.loads(run("forget", "adal7", "--course", course, "--yes", "--json", status=1))
    assert set(done["left"]) == {"notes.md", "submitted/benb8/one/one.ipynb"}
    assert sheet.read_bytes() == before


def test_what_lies_in_the_exchange_goes_too(course: Path, tmp_path: Path) -> None:
    """Feedback lies there under a name that says nothing: it is known by being the student's page."""
    exchange = tmp_path / "exchange" / "mech"
    with (course / "nbgrader_config.py").open("a") as config:
        config.write(f"c.Exchange.root = {str(exchange.parent)!r}\n")
    for student in ("adal7", "benb8"):
        for place in (f"inbound/{student}+one+2026-12-01 10:00:00 UTC", f"outbound/one/{student}"):
            (exchange / place).mkdir(parents=True)
            (exchange / place / "one.ipynb").write_text("{}")
        page = exchange / "feedback" / "one" / f"{'0123' if student == 'adal7' else '4567'}.html"
        page.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(course / "feedback" / student / "one" / "one.html", page)
    run("forget", "adal7", "--course", course, "--yes")
    left = {path.relative_to(exchange).as_posix() for path in exchange.rglob("*") if path.is_file()}
    assert left == {
        "inbound/benb8+one+2026-12-01 10:00:00 UTC/one.ipynb",
        "outbound/one/benb8/one.ipynb",
        "feedback/one/4567.html",
    }


def test_a_students_data_as_an_archive(course: Path, tmp_path: Path) -> None:
    run("export", "--person", "adal7", "--course", course, "-o", tmp_path / "ada.zip")
    with zipfile.ZipFile(tmp_path / "ada.zip") as archive:
        contents = {name: archive.read(name) for name in archive.namelist()}
    assert (
        contents["submitted/adal7/one/one.ipynb"] == (course / "submitted/adal7/one/one.ipynb").read_bytes()
    )
    assert COMMENT.encode() in contents["gradebook.db/rows.json"]
    assert COMMENT.encode() in contents[".corollary/manual/marks.jsonl/records.json"]
    joined = b"".join(contents.values())
    assert not [each for each in (b"benb8", b"Okafor", b"cyd.m@uni.example") if each in joined]
    assert set(json.loads(contents["about.json"])["places"]) >= {"gradebook.db", "downloads.zip"}


def test_an_archive_of_a_term_says_until_when(
    course: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "term.zip"
    run("export", "--archive", "--keep-until", "2999-09-30", "--course", course, "-o", place)
    with zipfile.ZipFile(place) as archive:
        names = archive.namelist()
        assert json.loads(archive.read("corollary-archive.json"))["keep_until"] == "2999-09-30"
        archive.extractall(tmp_path / "opened")
    assert not [name for name in names if name.startswith(("mech/autograded/", "mech/release/"))]
    report = json.loads(run("report", "one", "--course", tmp_path / "opened" / "mech", "--json"))
    assert set(report["students"]) == {"adal7", "benb8", "cydc9"}
    run("export", "--archive", "--keep-until", "1999-09-30", "--course", course, "-o", place, status=2)
    with zipfile.ZipFile(tmp_path / "past.zip", "w") as archive:
        archive.writestr("corollary-archive.json", '{"keep_until": "2001-01-01"}')
    monkeypatch.chdir(tmp_path)
    from corollary.course.term_archive import archive_findings

    assert {each.sentence.rpartition("/")[2]: each.state for each in archive_findings(None)} == {
        "past.zip was to be stored until 2001-01-01": "weak",
        "term.zip, to be stored until 2999-09-30": "good",
    }
