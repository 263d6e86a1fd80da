"""`corollary collect`: what is printed, and the statuses."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from corollary.cli.main import main
from corollary.records.files import open_course


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    (tmp_path / "one.md").write_text("---\ntitle: One\nproblems:\n  - X12.5\n---\nOne.\n")
    (tmp_path / "roster.csv").write_text("id,first_name,last_name\nada,Ada,Lovelace\nben,Ben,Bool\n")
    monkeypatch.chdir(tmp_path)

    def command(*arguments: str) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.argv", ["corollary", *arguments])
        with pytest.raises(SystemExit) as end:
            main()
        captured = capsys.readouterr()
        return int(end.value.code or 0), captured.out, captured.err

    assert command("generate", "one.md", "--roster", "roster.csv", "--course", "course")[0] == 0
    with zipfile.ZipFile("all.zip", "w") as made:
        made.write("course/release/ada/one/one.ipynb", "Ada Lovelace_17_assignsubmission_file_/one.ipynb")
        made.writestr("Ben Bool_18_assignsubmission_file_/one.pdf", b"%PDF")
    return command


def test_collected_and_said(run) -> None:
    status, out, _ = run("collect", "one", "all.zip", "--course", "course", "--dry-run", "--json")
    document = json.loads(out)
    assert (status, document["dry_run"], document["missing"]) == (0, True, ["ben"])
    assert [each["student"] for each in document["accepted"]] == ["ada"]
    assert not Path("course/submitted").exists()
    status, out, _ = run("collect", "one", "all.zip", "--course", "course")
    assert status == 0
    assert "one: 1 taken, 0 already there, 0 older, 1 not usable" in out
    assert "not handed in by 1 student: Ben Bool (ben)" in out
    assert Path("course/submitted/ada/one/one.ipynb").is_file()
    assert (open_course(Path("course")).record("collected", "one.json").stat().st_mode & 0o077) == 0


def test_a_text_beside_a_notebook_is_counted_and_not_listed(run) -> None:
    """Moodle's archive has an online text of everybody; only one of somebody without a notebook is to be looked at."""
    with zipfile.ZipFile("all.zip", "a") as made:
        for name, number in (("Ada Lovelace", 17), ("Ben Bool", 18)):
            made.writestr(f"{name}_{number}_assignsubmission_onlinetext_/onlinetext.html", b"<p>Hi</p>")
    _, out, _ = run("collect", "one", "all.zip", "--course", "course")
    assert (
        "one: 1 taken, 0 already there, 0 older, 2 not usable, 1 texts or other files beside a notebook"
        in out
    )
    assert "Ada Lovelace_17_assignsubmission_onlinetext_" not in out
    assert "Ben Bool_18_assignsubmission_onlinetext_" in out


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["one", "nowhere.zip"], "nowhere.zip does not exist"),
        (["one", "all.zip", "--times", "roster.csv"], 'roster.csv:1: has no columns "Identifier"'),
    ],
)
def test_what_cannot_be_collected_is_answered_in_a_sentence(run, arguments: list[str], sentence: str) -> None:
    status, out, err = run("collect", *arguments, "--course", "course")
    assert (status, out) == (2, "")
    assert sentence in err


def test_nothing_at_all(run) -> None:
    Path("empty").mkdir()
    assert run("collect", "one", "empty", "--course", "course")[0] == 1
