"""Packed copies of notebooks: what was handed in comes back to the byte, whatever bytes it is, and takes a tenth of the room."""

from __future__ import annotations

import json
import os
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.cli.commands import app
from corollary.problem.roster import Student
from corollary.records.files import create_course
from corollary.records.notebook_archive import DamagedArchive, hand_ins, keep, read_hand_in

from .changing_bank import ChangingBank, Text

WORDS = st.lists(
    st.binary(max_size=200) | st.sampled_from([b"a" * 5_000, b"b" * 9_001, b'"', b"\n", b"\\"]), max_size=90
).map(b"".join)


@settings(max_examples=60)
@given(st.lists(WORDS, max_size=3))
def test_whatever_was_handed_in_comes_back_to_the_byte(
    tmp_path_factory: pytest.TempPathFactory, contents: list[bytes]
) -> None:
    course = create_course(tmp_path_factory.mktemp("course"), [Student("ada")])
    for content in contents:
        keep(course, "week", "ada", content)
    assert set(hand_ins(course, "week", "ada").values()) == set(contents)


def test_a_damaged_copy_is_refused_and_named(tmp_path: Path) -> None:
    course = create_course(tmp_path, [Student("ada")])
    keep(course, "week", "ada", b"x" * 100)
    (file,) = course.record("collected", "week/ada").iterdir()
    file.write_bytes(file.read_bytes()[:-3] + b"abc")
    with pytest.raises(DamagedArchive, match=str(file)):
        hand_ins(course, "week", "ada")


@pytest.mark.whole
def test_sheets_of_who_has_handed_in_are_packed_and_given_out_as_before(tmp_path: Path) -> None:
    balls = ChangingBank(tmp_path)
    balls.write(Text())
    made = balls.generate("ada", "ben")
    sheets = {student: path.read_bytes() for student, path in made.notebooks.items()}
    with zipfile.ZipFile(tmp_path / "in.zip", "w") as archive:
        archive.writestr("ada/week.ipynb", sheets["ada"])

    def run(*words: object) -> str:
        line = [*map(str, words), "--course", str(balls.course), "--bank", str(balls.bank.folder)]
        done = CliRunner().invoke(app, line, catch_exceptions=False)
        assert done.exit_code == 0, done.output
        return done.stdout

    def size() -> int:
        return sum(each.stat().st_size for each in (balls.course / ".corollary/collected/week").rglob("*.*"))

    run("collect", "week", tmp_path / "in.zip")
    assert size() < len(sheets["ada"]) / 8
    assert json.loads(run("collect", "week", "--pack", "--json"))["packed"] == ["ada"]
    assert [path.exists() for path in made.notebooks.values()] == [False, True]
    (tmp_path / "roster.csv").write_text("id\nada\nben\ncyd\n")
    run("generate", "week", "--roster", tmp_path / "roster.csv")
    run("release", "week", "--to", "folder", "-o", tmp_path / "out")
    for student, content in sheets.items():
        assert (tmp_path / "out" / student / "week.ipynb").read_bytes() == content
    run("collect", "week", "--copies", tmp_path / "copies")
    (copy,) = (tmp_path / "copies/ada").iterdir()
    assert copy.read_bytes() == sheets["ada"]
    assert os.listdir(tmp_path / "copies") == ["ada"]


@pytest.mark.whole
def test_a_large_course_has_one_copy_of_a_sheet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("corollary.course.collect.LARGE", 2)
    balls = ChangingBank(tmp_path)
    balls.write(Text())
    made = balls.generate("ada", "ben")
    for student in ("ada", "ben"):
        balls.hand_in(made, student, **({"X1_1_a": "1.0"} if student == "ben" else {}))
    answered = {student: made.course.notebook("submitted", student, "week") for student in ("ada", "ben")}
    handed_in = {student: path.read_bytes() for student, path in answered.items()}
    with zipfile.ZipFile(tmp_path / "in.zip", "w") as archive:
        for student, content in handed_in.items():
            archive.writestr(f"{student}/week.ipynb", content)
            answered[student].unlink()
    line = ["collect", "week", str(tmp_path / "in.zip"), "--course", str(balls.course), "--json"]

    def collected() -> dict[str, list[object]]:
        done = CliRunner().invoke(app, [*line, "--bank", str(balls.bank.folder)], catch_exceptions=False)
        return json.loads(done.stdout)

    assert len(collected()["accepted"]) == 2
    assert not any(path.exists() for path in made.notebooks.values())
    for student, content in handed_in.items():
        assert answered[student].stat().st_size < len(content) / 3
        assert json.loads(answered[student].read_bytes())["cells"][0] == json.loads(content)["cells"][0]
        assert read_hand_in(made.course, answered[student]) == content
    assert len(collected()["unchanged"]) == 2
    outcome = balls.grade(made.course)
    marks = {student: (record.points, record.notes) for student, record in outcome.records.items()}
    assert marks == {"ada": (3.0, ()), "ben": (2.0, ())}
    answered["ada"].write_bytes(handed_in["ada"])
    assert balls.grade(made.course).graded == ()


def test_references_that_a_student_writes_make_no_large_file(tmp_path: Path) -> None:
    course = create_course(tmp_path, [Student("ada")])
    keep(course, "week", "ada", b"a" * 9_000)
    (word,) = course.record("shared", "any").parent.iterdir()
    path = course.notebook("submitted", "ada", "week")
    path.parent.mkdir(parents=True)
    path.write_bytes(b"stored-in-corollary-shared-%s " % word.stem.encode() * 1_000)
    content = read_hand_in(course, path)
    assert isinstance(content, bytes)
    assert len(content) < path.stat().st_size + 9_000
