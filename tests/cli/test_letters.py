"""Output where letters are lacking: no traceback and no line lost, whatever a terminal or a pipe can take."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from corollary.cli.commands import app
from corollary.cli.terminal import nearest

COMMAND = Path(sys.executable).with_name("corollary")
NARROW = [
    {"PYTHONIOENCODING": "ascii"},
    {"PYTHONIOENCODING": "cp1252"},
    {"LC_ALL": "C"},
    {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},  # nothing but ASCII, in arguments too
]
# Every command that answers without a course; those that take seconds each time are tried with the whole.
COMMANDS = [
    ["list"],
    ["show", "P12.14", "--format", "md"],
    ["key", "X12.7"],
    ["read", "8,6 Ns", "--unit", "kg m/s"],
    ["read", "1,234 N", "--unit", "N"],
    ["read", "3 µm", "--unit", "m"],
    ["--help"],
    ["show", "ΔE=½mv²"],  # not known, and named in the sentence
    ["schema"],
]
SLOW_COMMANDS = [
    ["show", "X12.7", "--solution"],
    ["scene", "cradle"],
    ["verify", "X12.5"],
    ["grade", "größe.md", "--course", "/nowhere/Übung"],
    ["doctor"],
    ["audit", str(Path(__file__).with_name("one_record.yaml"))],
    ["certify", "X12.7"],
]
ALL_COMMANDS = [
    *(pytest.param(words, NARROW, id=" ".join(words)) for words in COMMANDS[:2]),
    *(pytest.param(words, NARROW[1::2], id=" ".join(words)) for words in COMMANDS[2:]),
    *(
        pytest.param(words, NARROW[1::2], id=" ".join(words), marks=pytest.mark.whole)
        for words in SLOW_COMMANDS
    ),
]


def run(words: list[str], folder: Path, **settings: str) -> tuple[int, bytes, bytes]:
    environment = {**os.environ, "COLUMNS": "200", **settings}
    done = subprocess.run([COMMAND, *words], env=environment, cwd=folder, capture_output=True, check=False)
    return done.returncode, done.stdout, done.stderr


@pytest.mark.whole
@pytest.mark.parametrize(("words", "encodings"), ALL_COMMANDS)
def test_every_command_in_every_encoding(words: list[str], encodings: list[dict[str, str]], tmp_path: Path):
    usual = run(words, tmp_path, PYTHONIOENCODING="utf-8")
    for settings in encodings:
        status, out, err = run(words, tmp_path, **settings)
        assert b"Traceback" not in err
        assert b"should not have happened" not in err
        understood = all(map(str.isascii, words)) or "PYTHONUTF8" not in settings
        if understood and words != ["doctor"]:  # which says what the encoding is, and how full the disk
            assert status == usual[0], err
            assert out.count(b"\n") == usual[1].count(b"\n")
            assert err.count(b"\n") == usual[2].count(b"\n")


@pytest.mark.whole
@pytest.mark.parametrize(
    "words", [["list", "--json"], ["show", "X12.7", "--json"], ["key", "X12.7", "--json"]], ids=" ".join
)
def test_json_says_the_same_in_every_encoding(words: list[str], tmp_path: Path):
    expected = json.loads(run(words, tmp_path, PYTHONIOENCODING="utf-8")[1])
    for settings in NARROW:
        _, out, _ = run(words, tmp_path, **settings)
        assert json.loads(out.decode("cp1252" if "cp1252" in settings.values() else "utf-8")) == expected


@pytest.mark.whole
def test_a_course_in_every_encoding(tmp_path: Path):
    """Names, titles and texts with letters that are lacking: made, graded, reported and exported all the same."""
    (tmp_path / "one.md").write_text(
        "---\ntitle: Größe – “Übung” ≈ 日\nproblems: [X12.5]\n---\nΔp.\n", encoding="utf-8"
    )
    (tmp_path / "roster.csv").write_text("id,first_name\njon,Jón\nli,李\n", encoding="utf-8")
    in_a_course = [
        ["grade", "one", "--require-isolation", "0"],
        ["extend", "jon", "one", "--excuse"],
        ["report", "one"],
        ["export", "one", "--to", "csv"],
        ["show", "X12.5", "--student", "jon"],
    ]
    lines: list[list[tuple[int, int, int]]] = []
    for number, settings in enumerate([{"PYTHONIOENCODING": "utf-8"}, NARROW[0], NARROW[-1]]):
        course = tmp_path / f"mech{number}"
        words = ["generate", "one.md", "--roster", "roster.csv", "--course", course.name]
        seen = [run(words, tmp_path, **settings)]
        sheet = course / "release" / "jon" / "one" / "one.ipynb"
        for student in ("jon", "li"):
            (course / "submitted" / student / "one").mkdir(parents=True)
        (course / "submitted" / "jon" / "one" / "one.ipynb").write_bytes(sheet.read_bytes())
        (course / "submitted" / "li" / "one" / "one.ipynb").write_text("no notebook, 李")
        seen += [run(each, course, **settings) for each in in_a_course]
        assert not [err for _, _, err in seen if b"Traceback" in err or b"should not have happened" in err]
        lines.append([(status, out.count(b"\n"), err.count(b"\n")) for status, out, err in seen])
        assert "Größe – “Übung” ≈ 日" in (course / "reports" / "one.html").read_text(encoding="utf-8")
        assert "Jón" in sheet.read_text(encoding="utf-8")
        assert "李" in (course / "export" / "one.csv").read_text(encoding="utf-8-sig")
    assert [status for status, _, _ in lines[0]] == [0] * 6
    assert all(each == lines[0] for each in lines)


def test_the_nearest_letters():
    def written(text: str, encoding: str) -> str:
        try:
            return text.encode(encoding).decode(encoding)
        except UnicodeEncodeError as error:
            letters, end = nearest(error)
            return text[: error.start] + letters + written(text[end:], encoding)

    assert written("≈ 2·10³ – é", "ascii") == "~ 2*103 - e"
    assert written("≈ 2·10³ – é", "cp1252") == "~ 2·10³ – é"
    assert written("日本", "ascii") == "??"
    assert written("\ud800", "utf-8") == "?"


def test_every_command_is_tried_here_or_needs_a_course():
    elsewhere = {
        "judge",
        "trade",
        "generate",
        "report",
        "extend",
        "export",
        "demo",
        "release",
        "collect",
        "mark",
        "new",
        "preview",
        "practise",
        "share",
        "term",
        "forget",
    }
    assert {words[0] for words in [*COMMANDS, *SLOW_COMMANDS]} | elsewhere >= app.commands.keys()
