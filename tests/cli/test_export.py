"""`corollary export`: files where they were asked for, and a sentence where nothing can be exported."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.cli.main import main

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


def test_files_lie_where_they_were_asked_for_and_json_lists_them(run, tmp_path: Path) -> None:
    assert run("small.md", "--to", "md") == (0, "One exercise: 1 file in export/\n", "")
    assert "0.43\N{NO-BREAK SPACE}kg" in (tmp_path / "export/small.md").read_text()
    status, out, _ = run("small.md", "--to", "text", "--variants", "2", "-o", "two", "--json")
    assert (status, json.loads(out)) == (
        0,
        {"set": "small", "to": "text", "files": ["two/small-1.txt", "two/small-2.txt"]},
    )
    assert (tmp_path / "two/small-1.txt").read_text() != (tmp_path / "two/small-2.txt").read_text()


def test_parts_that_the_set_leaves_out_are_not_in_its_solution_either(run, tmp_path: Path) -> None:
    (tmp_path / "some.md").write_text("---\ntitle: Some\nproblems:\n  - {code: X12.8, parts: [a, b]}\n---\n")
    assert run("some.md", "--to", "md", "--solution")[0] == 0
    whole = (tmp_path / "export/some.md").read_text()
    assert "(b) Your velocity" in whole
    assert "far slower than the ball" in whole
    for left_out in ("(b2)", "(c)", "(c2)", "u_{1}", "after the catch"):
        assert left_out not in whole


def test_a_roster_gets_the_numbers_that_show_would_give(run, tmp_path: Path, monkeypatch, capsys) -> None:
    (tmp_path / "roster.csv").write_text("id,first_name\nada,Ada\nben,Ben\n")
    assert run("small.md", "--to", "md", "--roster", "roster.csv")[0] == 0
    monkeypatch.setattr("sys.argv", ["corollary", "show", "X12.5", "--student", "ada", "--format", "md"])
    with pytest.raises(SystemExit):
        main()
    shown = capsys.readouterr().out.splitlines()[2]
    assert shown in (tmp_path / "export/small-ada.md").read_text()
    assert shown not in (tmp_path / "export/small-ben.md").read_text()


def test_forms_on_paper_and_their_keys_in_a_folder_of_their_own(run, tmp_path: Path) -> None:
    status, out, _ = run("small.md", "--to", "pdf", "--forms", "2", "--formula-sheet", "--json")
    assert status == 0
    names = ["small-A.pdf", "keys/small-A-key.pdf", "small-B.pdf", "keys/small-B-key.pdf", "small.pdf"]
    assert json.loads(out)["files"] == [f"export/{name}" for name in names]
    files = [(tmp_path / "export" / name).read_bytes() for name in names]
    assert all(each.startswith(b"%PDF-") for each in files)
    assert len(set(files)) == len(files)
    assert run("small.md", "--to", "pdf", "--forms", "2", "--formula-sheet", "-o", "again")[0] == 0
    assert [(tmp_path / "again" / name).read_bytes() for name in names] == files


def test_without_the_extra_one_sentence_says_what_to_install(run, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    assert run("small.md", "--to", "pdf") == (
        2,
        "",
        'corollary: PDF needs the Python package typst; install it with: pip install "corollary-physics[pdf]"\n',
    )


REFUSED = [
    (
        ["--to", "docx"],
        "docx is not known; choose one of text, md, html, ipynb, pdf, csv, moodle-grades, canvas-grades, feedback-zip",
    ),
    (["--to", "csv"], "csv holds marks; say of which course with --course"),
    (["--to", "md", "--variants", "2", "--roster", "r.csv"], "each choose the numbers; give one of them"),
    (["--to", "md", "--course", "nowhere"], "is not a course of Corollary"),
    (["--to", "pdf", "--forms", "2", "--variants", "2"], "each choose the numbers; give one of them"),
    (["--to", "md", "--forms", "2"], "--forms is for paper; leave it out, or export --to pdf"),
    (["--to", "moodle", "--formula-sheet"], "--formula-sheet is for paper"),
    (["--to", "qti", "--solution"], "qti always has the worked solutions; leave it out"),
    (["--to", "csv", "--solution"], "--solution is for sheets; leave it out for csv"),
    (["--to", "site", "place", "--apart"], "--apart is for questions of an LMS"),
    (["--to", "site", "place", "--columns", "parts"], "--columns is for marks"),
    (["--to", "html", "--large-print"], "--large-print is for paper"),
    (["--to", "md", "--variants", "0"], "`corollary export --help` says how"),
]


@pytest.mark.parametrize(("arguments", "sentence"), REFUSED)
def test_what_cannot_be_exported_is_answered_in_a_sentence(run, arguments: list[str], sentence: str) -> None:
    status, out, err = run("small.md", *arguments)
    assert (status, out) == (2, "")
    assert sentence in err
    assert len(err.splitlines()) == 1


def test_one_problem_is_no_set(run) -> None:
    status, _out, err = run("X12.5", "--to", "pdf")
    assert status == 2
    assert "corollary show X12.5 --format FORMAT writes a single problem" in err


def test_help_lists_what_is_registered(installed):
    def listed() -> str:
        return " ".join(CliRunner().invoke(app, ["export", "--help"]).stdout.split())

    assert "one of: text, md, html, ipynb, pdf, csv" in listed()
    installed("rollcall", {"corollary.exports": ["roll = rollcall:ROLL"]}, {"rollcall.py": "ROLL = 7"})
    assert ", roll." in listed()
    installed("bakery", {"corollary.exports": ["roll = bakery:ROLL"]}, {"bakery.py": "ROLL = 8"})
    assert "bakery" in listed()
    assert "both bring roll" in listed()
