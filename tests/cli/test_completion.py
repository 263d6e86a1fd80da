"""Shell completion, asked for as a shell asks: codes, sets, students, scenes and targets."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from tests import forked

from corollary.atomic import write_whole
from corollary.problem.roster import Student
from corollary.records.files import create_course

COMMAND = forked.COMMAND


def completed(line: str, folder: Path) -> list[str]:
    """What bash would offer for the last word of a line."""
    about = {
        "_COROLLARY_COMPLETE": "bash_complete",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(line.split(" ")) - 1),
    }
    environment = {**os.environ, **about}
    done = forked.run([COMMAND], env=environment, cwd=folder, capture_output=True, text=True, check=False)
    assert done.stderr == ""
    return [each.partition(",")[2] for each in done.stdout.splitlines() if each]


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = create_course(tmp_path_factory.mktemp("term") / "mech", map(Student, ("ada", "adele", "ben")))
    write_whole(made.record("origin", "week1.json"), "{}")
    return made.folder


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("corollary gr", ["grade"]),
        ("corollary key X12.1", ["X12.1", "X12.10", "X12.11", "X12.12", "X12.13"]),
        ("corollary key x12.12", ["X12.12"]),
        ("corollary show kicking", ["kicking_a_ball"]),
        ("corollary grade we", ["week1"]),
        ("corollary generate mom", ["momentum_1"]),
        ("corollary extend ad", ["ada", "adele"]),
        ("corollary extend ada week", ["week1"]),
        ("corollary show X12.5 --student b", ["ben"]),
        ("corollary scene cra", ["cradle"]),
        ("corollary export momentum_1 --to ht", ["html"]),
        ("corollary list --topic imp", ["impulse"]),
        ("corollary key X12.5 --ca", ["--cases"]),
        ("corollary key nothing_begins_so", []),
    ],
)
def test_words_are_completed(course: Path, line: str, expected: list[str]):
    assert completed(line, course) == expected


def test_what_is_wrong_with_a_course_is_not_said_in_the_middle_of_a_line(course: Path, tmp_path: Path):
    (tmp_path / "corollary.toml").write_text("nonsense")
    assert completed("corollary key X12.1", tmp_path) == []
    assert completed("corollary extend a", tmp_path) == []


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_every_shell_gets_its_script(shell: str):
    environment = {**os.environ, "_COROLLARY_COMPLETE": f"{shell}_source"}
    done = forked.run([COMMAND], env=environment, capture_output=True, text=True, check=False)
    assert "_COROLLARY_COMPLETE" in done.stdout
