"""What was handed in and cannot be used is said by name; it is not marked, and gives no answers away."""

from __future__ import annotations

import json
import os
import shutil
import sys
from pathlib import Path

import pytest
from tests import forked

from .conftest import SET, grade

pytestmark = pytest.mark.whole


def ben(course: Path) -> Path:
    return course / "submitted" / "ben" / "one" / "one.ipynb"


def revealing(course: Path) -> Path:
    """The set, whose feedback shows the worked solutions."""
    file = course.parent / "one.md"
    file.write_text(SET.replace("problems:", "reveal: yes\nproblems:"))
    return file


def test_a_notebook_of_another_set_is_not_marked_and_reveals_nothing(handed_in: Path) -> None:
    notebook = json.loads(ben(handed_in).read_text())
    notebook["metadata"]["corollary"]["set"] = "two"
    ben(handed_in).write_text(json.dumps(notebook))
    done = grade(handed_in, name=revealing(handed_in))
    assert done.document["failed"] == ["ben"]
    record = done.document["students"]["ben"]
    assert "belongs to two, not to one" in record["trouble"]
    assert {part["verdict"] for part in record["parts"].values()} == {"unmarked"}
    pages = {who: (handed_in / f"feedback/{who}/one/one.html").read_text() for who in ("ada", "ben")}
    assert "Worked solution" in pages["ada"]
    assert "Worked solution" not in pages["ben"]
    assert "belongs to two, not to one" in pages["ben"]
    assert "belongs to two, not to one" in Path(done.document["report"]).read_text()


def test_what_cannot_be_opened_reveals_nothing_either(handed_in: Path) -> None:
    ben(handed_in).write_text('{"cells": [')
    grade(handed_in, name=revealing(handed_in))
    assert "Worked solution" not in (handed_in / "feedback/ben/one/one.html").read_text()


@pytest.mark.parametrize("name", ["one.html", "one.zip", "scan.pdf", "e\x1bvil.docx"])
def test_a_file_that_is_no_notebook_is_said_by_name(handed_in: Path, name: str) -> None:
    ben(handed_in).rename(ben(handed_in).with_name(name))
    ben(handed_in).with_name("timestamp.txt").write_text("2026-12-04 21:03:11 UTC")
    done = grade(handed_in)
    assert done.points == {"ada": 5.0, "cyd": 5.0}
    shown = name.replace("\x1b", "\\x1b")
    sentence = f"a file that is not a notebook ({shown}); ask for one.ipynb"
    assert f"ben handed in {sentence}" in done.errors
    assert sentence in Path(done.document["report"]).read_text()
    assert done.document["unclear"] == {"ben": [name]}


def test_a_neighbours_sheet_is_marked_with_ones_own_numbers_and_said(handed_in: Path) -> None:
    shutil.copy(handed_in / "submitted/ada/one/one.ipynb", ben(handed_in))
    done = grade(handed_in)
    assert done.points["ben"] < 5
    (note,) = done.document["students"]["ben"]["notes"]
    assert "made for ada. It was marked with the numbers of your own sheet (ben)" in note
    assert (
        "made for ada. It was marked with the numbers of your own sheet (ben)"
        in (handed_in / "feedback/ben/one/one.html").read_text()
    )


def test_nbgraders_autograde_follows_no_links_beside_the_notebook(handed_in: Path) -> None:
    pytest.importorskip("nbgrader")
    beside = ben(handed_in).parent
    (beside / "submission_secret.txt").symlink_to("../../../.corollary/key")
    (beside / "data").mkdir()
    (beside / "data" / "more.csv").symlink_to("/etc/passwd")
    (beside / "mine.csv").write_text("1,2")
    os.mkfifo(beside / "pipe")
    program = Path(sys.executable).with_name("nbgrader")
    done = forked.run(
        [program, "autograde", "one"], cwd=handed_in, capture_output=True, encoding="utf-8", timeout=120, check=False
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    copied = {path.name for path in (handed_in / "autograded/ben/one").rglob("*") if not path.is_dir()}
    assert {"one.ipynb", "mine.csv"} <= copied
    assert not {"submission_secret.txt", "more.csv", "pipe"} & copied
    assert "is a link or no file, and is not copied" in done.stderr
