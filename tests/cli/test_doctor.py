"""`corollary doctor`: what works and what does not, tried on courses and machines that are broken in one place."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import sqlite3
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.problem.bank import chapter_bank
from corollary.problem.roster import Student
from corollary.records.files import create_course, one_writer, open_course

Doctor = Callable[..., tuple[int, dict[str, dict[str, str]]]]


def doctor(*words: object) -> tuple[int, dict[str, dict[str, str]]]:
    """The exit status, and the findings by name."""
    done = CliRunner().invoke(app, ["doctor", "--json", *map(str, words)], catch_exceptions=False)
    document = json.loads(done.stdout)
    assert document["ok"] is (done.exit_code == 0)
    return done.exit_code, {each["name"]: each for each in document["findings"]}


@pytest.fixture
def course(tmp_path: Path, monkeypatch) -> Path:
    """A course in which nothing is broken, around the working folder."""
    folder = create_course(tmp_path / "mech", [Student("ada")]).folder
    (folder / "corollary.toml").write_text('timezone = "Europe/Oslo"\nisolation = 0\n')
    monkeypatch.chdir(folder)
    for name in ("COROLLARY_BANK", "COROLLARY_COURSE"):
        monkeypatch.delenv(name, raising=False)
    return folder


def test_what_is_looked_at(course: Path):
    status, found = doctor()
    assert status == 0, [each for each in found.values() if each["state"] == "broken"]
    assert {
        "corollary", "Python", "sympy", "python-flint", "Jupyter", "settings", "course", "isolation", "nbgrader", "alembic",
        "gradebook", "exchange", "disk", "time zone", "encoding", "cores", "cache", "chapter's bank",
    } <= found.keys()  # fmt: skip
    assert found["course"]["sentence"] == f"{course}, 1 on the roster"
    assert found["time zone"]["sentence"].startswith("Europe/Oslo")
    assert found["isolation"]["sentence"].startswith("level ")
    assert all(each["remedy"] for each in found.values() if each["state"] != "good")


def test_another_package_with_files_in_our_module_is_named(course: Path, tmp_path: Path, monkeypatch):
    """pip installs both side by side and says nothing; the module is then a mixture of the two."""
    about = tmp_path / "elsewhere" / "corollary-0.1.0a4.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: corollary\nVersion: 0.1.0a4\n")
    (about / "RECORD").write_text("corollary/__init__.py,,\n")
    (about.parent / "corollary").mkdir()  # some readers of RECORD leave out missing files
    (about.parent / "corollary" / "__init__.py").touch()
    monkeypatch.syspath_prepend(str(about.parent))
    status, found = doctor()
    assert status == 1
    assert "0.1.0a4" in found["namesake"]["sentence"]
    assert found["namesake"]["remedy"].startswith("pip uninstall corollary,")
    (about / "RECORD").write_text("something_else/__init__.py,,\n")
    assert "namesake" not in doctor()[1]


def test_for_people_each_finding_is_a_line_and_the_end_says_how_many_are_broken(course: Path):
    done = CliRunner().invoke(app, ["doctor"], catch_exceptions=False)
    assert done.exit_code == 0
    assert done.stdout.splitlines()[0].startswith("ok      corollary")
    assert done.stdout.rstrip().endswith("are fine")
    assert max(map(len, done.stdout.splitlines())) <= 100 + len(str(course))


def test_a_folder_that_is_no_course(tmp_path: Path, course: Path):
    status, found = doctor("--course", tmp_path)
    assert (status, found["course"]["state"]) == (1, "broken")
    assert "is not a course of Corollary" in found["course"]["sentence"]


def roster_is_a_folder(course: Path) -> None:
    (course / ".corollary" / "roster.csv").unlink()
    (course / ".corollary" / "roster.csv").mkdir()


def key_is_damaged(course: Path) -> None:
    (course / ".corollary" / "key").write_bytes(b"short")


def rows(*lines: str) -> Callable[[Path], None]:
    def write(course: Path) -> None:
        text = "\n".join(["id,first_name,last_name,email", *lines, ""])
        (course / ".corollary" / "roster.csv").write_text(text)

    return write


@pytest.mark.parametrize(
    ("harm", "sentence", "remedy"),
    [
        (roster_is_a_folder, "is a folder", "roster.csv away, then corollary generate SET --roster FILE"),
        (key_is_damaged, "is damaged: 5 bytes", "restore .corollary from a backup"),
        (rows("ada,Ada"), "roster.csv:2: ada, Ada is not a student", "corollary generate SET --roster FILE"),
        (rows("../ada,Ada,L,"), "roster.csv:2: ../ada", "corollary generate SET --roster FILE"),
        (rows(), "nobody on the roster", "corollary generate SET --roster FILE"),
    ],
)
def test_a_course_whose_record_is_damaged(
    course: Path, harm: Callable[[Path], None], sentence: str, remedy: str
):
    harm(course)
    status, found = doctor()
    assert (status, found["course"]["state"]) == (1, "broken")
    assert sentence in found["course"]["sentence"]
    assert remedy in found["course"]["remedy"]


@pytest.mark.skipif(os.name == "nt", reason="Windows has other rights")
def test_what_others_can_read_is_named_and_the_advice_closes_it(course: Path):
    assert doctor()[1]["rights"]["state"] == "good"
    reports = course / "reports"
    reports.mkdir()
    (reports / "week1.html").touch()
    closed = [each for each in course.parents if not each.stat().st_mode & 0o001]
    course.chmod(0o755)
    if closed:  # pytest's own folders: nobody comes that far
        assert doctor()[1]["rights"]["state"] == "good"
    with opened_up(closed):
        status, found = doctor()
        assert (status, found["rights"]["state"]) == (1, "broken")
        assert "reports" in found["rights"]["sentence"]
        assert ".corollary" not in found["rights"]["sentence"]
        subprocess.run(found["rights"]["remedy"], shell=True, check=True)
        assert doctor()[1]["rights"]["state"] == "good"
    assert {path.stat().st_mode & 0o077 for path in course.rglob("*")} == {0}


@contextmanager
def opened_up(folders: list[Path]) -> Iterator[None]:
    before = {each: each.stat().st_mode & 0o777 for each in folders}
    for each in folders:
        each.chmod(0o711)
    yield
    for each, mode in before.items():
        each.chmod(mode)


def test_a_folder_that_cannot_be_written_in(course: Path, monkeypatch):
    (course / "submitted").mkdir()
    may = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path).name != "submitted" and may(path, mode))
    status, found = doctor()
    assert (status, found["rights"]["state"]) == (1, "broken")
    assert f"chmod u+rwx {course / 'submitted'}" in found["rights"]["remedy"]


def test_a_lock_is_that_of_a_run_at_work_and_goes_with_it(course: Path):
    (course / ".corollary" / "lock").touch()  # left over: it says nothing
    assert "lock" not in doctor()[1]
    with one_writer(open_course(course)):
        status, found = doctor()
        assert (status, found["lock"]["state"]) == (0, "weak")
    assert "lock" not in doctor()[1]


@pytest.mark.parametrize(
    ("name", "setting", "words"),
    [
        ("settings", "timezone = 'Berlin'", "did you mean Europe/Berlin"),
        ("settings", "jobs = ", "is not TOML"),
        ("course's bank", "bank = '../nowhere'", "is not a bank"),
    ],
)
def test_settings_that_will_not_do(course: Path, name: str, setting: str, words: str):
    (course / "corollary.toml").write_text(f"isolation = 0\n{setting}\n")
    status, found = doctor()
    assert (status, found[name]["state"]) == (1, "broken")
    assert words in found[name]["sentence"]


def test_a_level_that_is_asked_for_and_does_not_hold(course: Path, monkeypatch):
    from corollary.sandbox import runner
    from corollary.sandbox.isolation import isolation_of

    found = isolation_of({"seccomp": True, "network": True}, {"Landlock": "the kernel has none"})
    monkeypatch.setattr(runner, "probe_isolation", lambda: found)
    assert doctor()[1]["isolation"]["state"] == "weak"
    (course / "corollary.toml").write_text("isolation = 1\n")
    status, by_name = doctor()
    assert (status, by_name["isolation"]["state"]) == (1, "broken")
    assert "Landlock: the kernel has none" in by_name["isolation"]["sentence"]


def test_a_gradebook_that_is_damaged_or_none(course: Path):
    book = course / "gradebook.db"
    assert doctor()[1]["gradebook"]["state"] == "weak"  # there is none yet
    book.write_bytes(b"garbage, and a good deal of it" * 100)
    status, found = doctor()
    assert (status, found["gradebook"]["state"]) == (1, "broken")
    assert "restore it from a backup" in found["gradebook"]["remedy"]
    book.unlink()
    with sqlite3.connect(book) as empty:
        empty.execute("CREATE TABLE other (id)")
    assert doctor()[1]["gradebook"]["state"] == "broken"


def test_a_gradebook_that_another_program_holds(course: Path):
    with sqlite3.connect(course / "gradebook.db") as book:
        book.executescript("CREATE TABLE assignment (id); CREATE TABLE grade (id);")
        book.commit()
        book.execute("BEGIN EXCLUSIVE")
        found = doctor()[1]["gradebook"]
        book.rollback()
    assert (found["state"], "locked by another program" in found["sentence"]) == ("weak", True)
    assert doctor()[1]["gradebook"]["sentence"].endswith("0 assignments")


def test_a_config_that_cannot_be_run(course: Path):
    (course / "nbgrader_config.py").write_text("# Written by corollary.\nc = get_config(\n")
    status, found = doctor()
    assert (status, found["nbgrader_config.py"]["state"]) == (1, "broken")
    assert "line 2" in found["nbgrader_config.py"]["sentence"]


@pytest.mark.parametrize(("mode", "state"), [(0o777, "good"), (0o755, "weak"), (None, "weak")])
def test_the_exchange_is_open_to_everybody_or_students_cannot_hand_in(
    course: Path, tmp_path: Path, mode: int | None, state: str
):
    place = tmp_path / "exchange"
    (course / "nbgrader_config.py").write_text(
        f"# Written by corollary.\nc = get_config()\nc.Exchange.root = {str(place)!r}\n"
    )
    if mode is not None:
        place.mkdir()
        place.chmod(mode)
    found = doctor()[1]["exchange"]
    assert (found["state"], str(place) in found["sentence"]) == (state, True)


def test_alembic_is_looked_for_where_nbgrader_looks(course: Path, monkeypatch):
    monkeypatch.setenv("PATH", "/usr/bin")
    found = doctor()[1]["alembic"]
    assert (found["state"], "not on the PATH" in found["sentence"]) == ("weak", True)


def test_a_full_disk(course: Path, monkeypatch):
    import shutil

    usage = shutil.disk_usage(course)
    monkeypatch.setattr(shutil, "disk_usage", lambda place: usage._replace(free=50 << 20))
    status, found = doctor()
    assert (status, found["disk"]["state"], found["disk"]["remedy"]) == (1, "broken", "make room")


def test_a_set_whose_bank_has_moved(course: Path):
    origin = course / ".corollary" / "origin"
    origin.mkdir()
    (origin / "week1.json").write_text(json.dumps({"bank": str(course / "gone"), "set": None}))
    status, found = doctor()
    assert (status, found["set week1"]["state"]) == (1, "broken")
    assert "--bank DIR" in found["set week1"]["remedy"]


def test_the_advice_for_a_bank_that_has_moved_works_as_it_stands(course: Path, tmp_path: Path):
    bank = tmp_path / "bank"
    for step in ("problems", "solutions"):
        shutil.copytree(chapter_bank().folder / step / "impulse", bank / step / "impulse")
    set_file = tmp_path / "one.md"
    set_file.write_text("---\ntitle: One\nproblems: [X12.5]\n---\nOne.\n")
    words = ["generate", str(set_file), "--bank", str(bank), "--course", str(course)]
    assert CliRunner().invoke(app, words).exit_code == 0
    bank.rename(tmp_path / "moved")
    remedy = doctor()[1]["set one"]["remedy"]
    done = CliRunner().invoke(app, shlex.split(remedy)[1:])
    assert done.exit_code == 0, done.stderr
    assert doctor()[1]["set one"]["state"] == "good"

    (away := tmp_path / "away").mkdir()
    set_file.rename(away / "one.md")
    remedy = doctor()[1]["set one"]["remedy"]
    command = remedy.partition(",")[0].replace("PATH", str(away))
    assert CliRunner().invoke(app, shlex.split(command)[1:]).exit_code == 0
    assert doctor()[1]["set one"]["state"] == "good"


def test_a_plug_in_that_cannot_be_loaded(course: Path, installed):
    installed("theirs", {"corollary.exports": ["braille = nowhere_at_all:TARGET"]}, {})
    status, found = doctor()
    assert (status, found["corollary.exports: braille"]["state"]) == (1, "broken")
    assert "nowhere_at_all" in found["corollary.exports: braille"]["sentence"]


def test_nothing_is_changed_by_looking(course: Path):
    before = {path: path.stat().st_mtime_ns for path in course.rglob("*")}
    doctor()
    assert {path: path.stat().st_mtime_ns for path in course.rglob("*")} == before
    assert os.getcwd() == str(course)
