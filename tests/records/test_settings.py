"""The file corollary.toml of a course: found from below, read strictly, written once."""

from __future__ import annotations

import tomllib
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.records.settings import FILE, Settings, read_settings, write_settings


def says(folder: Path, text: str) -> Settings:
    (folder / FILE).write_text(text, encoding="utf-8")
    return read_settings(folder)


def test_what_a_course_says(tmp_path: Path):
    (tmp_path / "bank").mkdir()
    found = says(
        tmp_path,
        'timezone = "Asia/Tokyo"\nbank = "bank"\nreveal = "yes"\nisolation = 2\njobs = 4\n'
        'executor = "tcp://here:8786"\nformgrader = "https://hub/formgrader"\nlanguage = "en"\n',
    )
    assert found == Settings(
        "Asia/Tokyo", str(tmp_path / "bank"), "yes", 2, 4, "tcp://here:8786", "https://hub/formgrader", "en"
    )
    assert (found.usual.zone, found.usual.reveal) == (ZoneInfo("Asia/Tokyo"), "after due")


def test_an_older_course_has_no_file_and_is_as_it_was(tmp_path: Path, monkeypatch):
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    assert read_settings(tmp_path) == Settings()
    assert (Settings().usual.zone, Settings().usual.reveal) == (ZoneInfo("Asia/Tokyo"), "no")


def test_the_file_is_written_once_with_the_machines_zone_and_all_else_as_comments(
    tmp_path: Path, monkeypatch
):
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    write_settings(tmp_path)
    text = (tmp_path / FILE).read_text()
    assert read_settings(tmp_path) == Settings("Asia/Tokyo")
    monkeypatch.setenv("TZ", "Europe/Oslo")
    write_settings(tmp_path)
    assert (tmp_path / FILE).read_text() == text
    # What stands behind # is a setting too, and every setting stands there.
    lines = [line.removeprefix("# ") for line in text.splitlines() if " = " in line]
    (tmp_path / FILE).write_text("\n".join(lines))
    assert read_settings(tmp_path).isolation == 1
    assert set(tomllib.loads("\n".join(lines))) == set(Settings.__slots__)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("timezon = 'UTC'", "`timezon` is not known (did you mean timezone?); known are timezone, bank"),
        ("timezone = 'Berlin'", "did you mean Europe/Berlin?"),
        ("timezone = 'Europe/Berln'", "did you mean Europe/Berlin"),
        ("timezone = 1", "is no time zone"),
        ("bank = ''", "bank: give the name of a folder"),
        ("reveal = true", "reveal: True: say one of no, yes, after due"),
        ("reveal = 'maybe'", "reveal: maybe"),
        ("isolation = 4", "say a level from 0 to 3"),
        ("isolation = true", "say a level from 0 to 3"),
        ("jobs = 0", "1 or more"),
        ("executor = 'here'", "tcp://HOST:8786"),
        ("formgrader = 'hub'", "http://localhost:8888/formgrader"),
        ("language = 'xx'", "the texts are there in en"),
        ("jobs 4", "is not TOML"),
        ("jobs = 4\njobs = 5", "is not TOML"),
        ("[jobs]\nmany = 4", "say how many"),
    ],
)
def test_what_will_not_do_is_named_with_its_line(tmp_path: Path, line: str, words: str):
    with pytest.raises(Malformed) as raised:
        says(tmp_path, f"# a comment\n\n{line}\n")
    (complaint,) = raised.value.complaints
    assert str(complaint).startswith("corollary.toml:")
    assert complaint.line in ((3, 4) if "\n" in line else (3,))
    assert words in complaint.sentence


def test_a_file_that_is_not_utf_8(tmp_path: Path):
    (tmp_path / FILE).write_bytes(b"timezone = '\xff'\n")
    with pytest.raises(Malformed, match="cannot be read"):
        read_settings(tmp_path)
