"""A set stays known to its course, however it was named, from whichever folder, and whatever comes after."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from corollary.cli.main import main
from corollary.problem.bank import chapter_bank

SET = "---\ntitle: {title}\ndue: 2029-12-01\nproblems:\n  - X12.5\n---\nOne exercise.\n"
Run = Callable[..., int]
AFTERWARDS = (
    ["grade", "week1"],
    ["report", "week1"],
    ["release", "week1", "--to", "zip"],
    ["extend", "ada", "week1", "2030-01-01"],
    ["export", "week1", "--to", "pdf"],
)
OF_ITS_OWN, OF_A_BANK = "own/week1.md", "bank/problems/sets/week1.md"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Run:
    """A command in a folder of a semester: `own` holds a set alone, `bank` a bank that has one of this name."""
    monkeypatch.delenv("COROLLARY_BANK", raising=False)
    for step in ("problems", "solutions"):
        shutil.copytree(chapter_bank().folder / step / "impulse", tmp_path / "bank" / step / "impulse")
    for file, title in ((OF_ITS_OWN, "Its own"), (OF_A_BANK, "Of a bank")):
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(SET.format(title=title))
    (tmp_path / "ada.csv").write_text("id\nada\n")
    (tmp_path / "both.csv").write_text("id\nada\nben\n")
    (tmp_path / "elsewhere").mkdir()

    def command(folder: str, *words: str) -> int:
        monkeypatch.chdir(tmp_path / folder)
        monkeypatch.setattr("sys.argv", ["corollary", *words, "--course", str(tmp_path / "course")])
        with pytest.raises(SystemExit) as end:
            main()
        captured = capfd.readouterr()
        assert not end.value.code, captured.err
        return 0

    return command


def generate(run: Run, tmp_path: Path, folder: str, roster: str, *words: str) -> None:
    run(folder, "generate", *words, "--roster", str(tmp_path / roster), "--yes")


@pytest.mark.parametrize(
    ("first", "again", "title"),
    [
        (("own", "week1.md"), ("own", "week1"), "Its own"),
        ((".", OF_A_BANK), ("elsewhere", "week1"), "Of a bank"),
        *(
            pytest.param(*ways, marks=pytest.mark.whole)
            for ways in (
                ((".", OF_ITS_OWN), ("elsewhere", "week1"), "Its own"),
                ((".", "week1", "--bank", "bank"), ("own", "week1.md"), "Its own"),
                (("elsewhere", f"../{OF_ITS_OWN}"), ("elsewhere", "week1", "--bank", "../bank"), "Its own"),
                ((".", OF_ITS_OWN, "--bank", "bank"), ("own", "week1"), "Its own"),
                ((".", "week1", "--bank", "bank"), ("elsewhere", "week1"), "Of a bank"),
                (("bank", "problems/sets/week1.md"), (".", OF_A_BANK), "Of a bank"),
            )
        ),
    ],
)
def test_generated_again_by_name_or_path_and_worked_with(
    run: Run, tmp_path: Path, first: Sequence[str], again: Sequence[str], title: str
) -> None:
    generate(run, tmp_path, first[0], "ada.csv", *first[1:])
    sheet = (tmp_path / "course" / "release" / "ada" / "week1" / "week1.ipynb").read_bytes()
    generate(run, tmp_path, again[0], "both.csv", *again[1:])
    generate(run, tmp_path, "elsewhere", "both.csv", "week1")
    assert (tmp_path / "course" / "release" / "ada" / "week1" / "week1.ipynb").read_bytes() == sheet
    recorded = json.loads((tmp_path / "course" / ".corollary" / "origin" / "week1.json").read_text())
    assert recorded["set"] == (f"../{OF_ITS_OWN}" if title == "Its own" else None)
    for words in AFTERWARDS[:1] if "--bank" in first else AFTERWARDS:
        run("elsewhere", *words)
    shutil.copytree(
        tmp_path / "course" / "release" / "ben" / "week1", tmp_path / "course" / "submitted" / "ben" / "week1"
    )
    run("elsewhere", "grade", "week1")


def test_the_chapters_set_is_known_by_its_name(run: Run, tmp_path: Path) -> None:
    generate(run, tmp_path, ".", "ada.csv", "momentum_1")
    generate(run, tmp_path, "elsewhere", "ada.csv", "momentum_1")
    run("own", "grade", "momentum_1")
    run("elsewhere", "report", "momentum_1")
