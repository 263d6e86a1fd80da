"""`corollary generate`: rosters as they come, and students who are no longer on one."""

from __future__ import annotations

import json
import os
import pty
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from tests import forked

from corollary.cli.commands import app
from corollary.cli.main import main
from corollary.records.files import open_course, students

SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"
CANVAS = 'Student,ID,SIS User ID,SIS Login ID,Section\n    Points Possible,,,,\n"Żak, Łukasz",2001,S-17,łukasz,M\n"Bool, Ben",2002,S-18,ben,M\n'


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]):
    (tmp_path / "small.md").write_text(SET)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", open(os.devnull))  # noqa: SIM115

    def command(roster: str, *arguments: str) -> tuple[int, str, str]:
        (tmp_path / "roster.csv").write_text(roster, encoding="utf-8")
        line = ["generate", "small.md", "--roster", "roster.csv", "--course", "course", *arguments]
        monkeypatch.setattr("sys.argv", ["corollary", *line])
        with pytest.raises(SystemExit) as end:
            main()
        captured = capfd.readouterr()
        return int(end.value.code or 0), captured.out, captured.err

    return command


def on_roster() -> list[str]:
    return [each.id for each in students(open_course(Path("course")))]


def test_the_ids_an_lms_knows_a_student_by_are_recorded(run):
    status, out, err = run(CANVAS, "--json")
    assert status == 0
    assert "łukasz is lukasz-" in err
    lukasz, ben = students(open_course(Path("course")))
    assert list(json.loads(out)["students"]) == [lukasz.id, "ben"]
    assert Path(f"course/release/{lukasz.id}/small/small.ipynb").is_file()
    assert dict(lukasz.ids) == {"SIS Login ID": "łukasz", "SIS User ID": "S-17", "ID": "2001"}
    assert (lukasz.name, ben.name) == ("Łukasz Żak", "Ben Bool")


def test_newcomers_are_added_and_who_disappears_is_never_dropped_silently(run):
    assert run("id\nada\nben\n")[0] == 0
    sheet = Path("course/release/ada/small/small.ipynb").read_bytes()
    status, _, err = run("id\ncyd\n")
    assert (status, on_roster()) == (0, ["ada", "ben", "cyd"])
    assert "new on the roster: cyd" in err
    before = {path: path.read_bytes() for path in Path("course").rglob("*") if path.is_file()}
    status, out, err = run("id\nada\ndan\n")
    assert status == 1
    assert {path: path.read_bytes() for path in Path("course").rglob("*") if path.is_file()} == before
    assert "ben" in out
    assert "cyd" in out
    assert "Nothing is changed; --yes agrees" in err
    assert "a roster with the new students only" in err
    assert run("id\nada\ndan\n", "--yes")[0] == 0
    assert on_roster() == ["ada", "dan"]
    assert Path("course/release/ada/small/small.ipynb").read_bytes() == sheet
    assert run("id\nben\n")[0] == 0
    assert on_roster() == ["ada", "dan", "ben"]


@pytest.mark.parametrize(("answer", "left"), [("y", ["ada"]), ("n", ["ada", "ben"])])
def test_a_terminal_asks(run, answer, left):
    assert run("id\nada\nben\n")[0] == 0
    Path("roster.csv").write_text("id\nada\n")
    terminal, other = pty.openpty()
    line = [
        Path(sys.executable).with_name("corollary"),
        "generate",
        "small.md",
        "--roster",
        "roster.csv",
        "--course",
        "course",
    ]
    with subprocess.Popen(line, stdin=other, stdout=subprocess.DEVNULL, stderr=other) as command:
        os.close(other)
        os.write(terminal, f"{answer}\n".encode())
        read = b""
        while b"Remove this student from the roster?" not in read:
            read += os.read(terminal, 1000)
        command.wait(timeout=120)
    os.close(terminal)
    assert command.returncode == (0 if answer == "y" else 1)
    assert on_roster() == left


def test_two_ids_that_are_one_folder(run):
    assert run("id\nada\n")[0] == 0
    status, _, err = run("id\nAda\n")
    assert (status, on_roster()) == (2, ["ada"])
    assert "one folder on many disks" in err


@pytest.mark.whole
@pytest.mark.parametrize(
    ("name", "words"), [("momentum_1", ["--bank", "bank"]), ("bank/problems/sets/momentum_1.md", [])]
)
def test_a_set_that_was_generated_before_comes_from_the_bank_it_came_from(
    tmp_path: Path, name: str, words: list[str]
) -> None:
    """Its name may be one of the chapter's, too; a set's file that lies in a bank is of that bank."""
    command = [
        str(Path(sys.executable).with_name("corollary")),
        "generate",
        name,
        "--course",
        "course",
        "--json",
    ]
    bank = tmp_path / "bank"
    for kind, name in (("problems", "kicking_a_ball.md"), ("solutions", "kicking_a_ball.md")):
        (bank / kind / "impulse").mkdir(parents=True)
        shutil.copy(Path(__file__).parents[2] / kind / "impulse" / name, bank / kind / "impulse")
    (bank / "problems" / "sets").mkdir()
    (bank / "problems" / "sets" / "momentum_1.md").write_text(SET)
    for students_now, words_now in (("id\nada\n", words), ("id\nada\nben\n", [])):
        (tmp_path / "roster.csv").write_text(students_now)
        done = forked.run(
            [*command, "--roster", "roster.csv", *words_now],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        rows = json.loads(done.stdout)["students"]
        assert all(list(each["variants"]) == ["X12.5"] for each in rows.values()), (
            "one problem, not the chapter's five"
        )
    origin = json.loads((tmp_path / "course" / ".corollary" / "origin" / "momentum_1.json").read_text())
    assert origin["bank"] == ["../bank"]


def test_a_problem_that_is_not_translated_is_named_before_sheets_are_dealt(run, tmp_path):
    assert CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", "mine"]).exit_code == 0
    status, _, err = run("id\nada\n", "--language", "de")
    assert (status, "not translated" in err) == (0, False)
    (tmp_path / "small.md").write_text(SET.replace("X12.5", "Q1\n  - chapter/X12.5"))
    status, _, err = run("id\nada\n", "--language", "de", "--bank", "mine", "--course", "other")
    assert status == 0
    assert (
        "not translated into de, so that students read them in the original's language: Q1; corollary new --translate Q1 de"
        in err
    )
