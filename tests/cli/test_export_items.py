"""`corollary export --to moodle`: a set or a problem as questions, and what became of each part."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest

from corollary.cli.main import main
from corollary.problem.bank import chapter_bank
from corollary.problem.roster import Student
from corollary.records.files import create_course
from corollary.records.origin import write_origin

SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    (tmp_path / "small.md").write_text(SET)
    monkeypatch.chdir(tmp_path)

    def command(*arguments: str) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.argv", ["corollary", "export", *arguments])
        with pytest.raises(SystemExit) as end:
            main()
        said = capsys.readouterr()
        return int(end.value.code or 0), said.out, said.err

    return command


def test_a_set_and_a_problem_by_its_code_are_pools(run, tmp_path: Path) -> None:
    status, out, _ = run("small.md", "--to", "moodle", "--variants", "2", "--json")
    told = json.loads(out)
    assert (status, told["files"]) == (0, ["export/small-moodle.xml", "export/small-answers.json"])
    assert told["variants"] == {"X12.5": 2}
    assert [(each["part"], bool(each["how"])) for each in told["parts"]] == [(part, True) for part in "abcd"]
    assert len(told["lost"]) >= 3
    kinds = [each.get("type") for each in Xml.parse(tmp_path / "export/small-moodle.xml").getroot()]
    assert kinds == ["category", "multianswer", "multianswer"]
    rows = json.loads((tmp_path / "export/small-answers.json").read_text())
    assert {(row["code"], row["variant"]) for row in rows} == {("X12.5", 1), ("X12.5", 2)}
    first = (tmp_path / "export/small-moodle.xml").read_bytes()
    assert run("small.md", "--to", "moodle", "--variants", "2")[0] == 0
    assert (tmp_path / "export/small-moodle.xml").read_bytes() == first
    assert run("X12.5", "--to", "qti", "-o", "q")[0] == 0
    assert (tmp_path / "q/kicking_a_ball-qti.zip").exists()


@pytest.mark.whole
def test_in_a_course_its_own_sets_are_known(run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their file lies outside of the bank."""
    week = tmp_path / "week1.md"
    week.write_text("---\ntitle: Week 1\nproblems:\n  - {code: X12.8, parts: [a, b]}\n---\n")
    course = create_course(tmp_path / "mechanics", [Student("ada")])
    write_origin(course, "week1", chapter_bank(), week)
    assert run("week1", "--to", "moodle")[0] == 2
    for to in ("moodle", "qti", "canvas", "numbas"):
        status, out, errors = run("week1", "--to", to, "--course", "mechanics", "--json")
        assert (status, errors) == (0, "")
        assert [each["part"] for each in json.loads(out)["parts"]] == ["a", "b"]
    monkeypatch.chdir(course.folder)
    for numbers in ((), ("--variants", "2")):
        status, out, _ = run("week1", "--to", "moodle", "--json", *numbers)
        assert (status, json.loads(out)["set"]) == (0, "week1")
    assert run("momentum_1", "--to", "moodle")[0] == 0  # never generated here
    assert run("X12.5", "--to", "moodle")[0] == 0
    questions = (course.folder / "export/week1-moodle.xml").read_text()
    assert "after the catch" not in questions


def test_the_table_says_how_each_part_is_carried(run) -> None:
    status, out, _ = run("X12.5", "--to", "moodle")
    assert status == 0
    assert "X12.5 (a)" in out
    assert "4 parts carried, 0 refused" in out


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("small.md", "--to", "moodle", "--roster", "r.csv"), "moodle is a pool for everybody"),
        (("small.md", "--to", "moodle", "--round", "1"), "--round is for marks"),
        (("small.md", "--to", "md", "--apart"), "--apart is for questions of an LMS"),
        (("X99.9", "--to", "qti"), "X99.9"),
    ],
)
def test_what_cannot_be_is_a_sentence(run, arguments, sentence) -> None:
    status, _, said = run(*arguments)
    assert status == 2
    assert sentence in said
