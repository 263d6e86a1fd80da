"""A course that a teaching team shares: a term with the accounts of teacher, assistants and students, and nbgrader's exchange."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nbgrader")

pytestmark = [
    pytest.mark.whole,
    pytest.mark.timeout(1800),  # thirty commands one after the other, each with its start
    pytest.mark.usefixtures("open_to_everybody"),
    pytest.mark.skipif(
        sys.platform != "linux" or os.geteuid() != 0, reason="only root can act as several users"
    ),
]


@pytest.fixture(scope="module")
def term() -> dict[str, Any]:
    folder = Path(tempfile.mkdtemp())  # pytest's own folders are for one user
    folder.chmod(0o755)
    script = Path(__file__).with_name("team_term.py")
    done = subprocess.run(
        [sys.executable, script, folder / "term"], capture_output=True, text=True, check=False, timeout=1800
    )
    shutil.rmtree(folder, ignore_errors=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_every_step_of_the_term_is_done_by_the_account_that_does_it(term: dict[str, Any]) -> None:
    assert [each for each in term["steps"] if each["status"]] == []
    assert {each["who"] for each in term["steps"]} == {"teacher", "ta1", "ta2", "stu1", "stu2", "stu3"}
    assert {name for name, count in term["owners"].items() if count} == {"teacher", "ta1", "ta2"}
    assert term["feedback"] == {"stu1": 1, "stu2": 1, "stu3": 1}


def test_a_course_is_its_owners_alone_then_the_teams_and_never_anybody_elses(term: dict[str, Any]) -> None:
    report, with_students = term["refused"]
    assert report["status"] == 2
    assert with_students["status"] == 2
    assert "the group all has students of this course: stu1, stu2, stu3" in with_students["last"]
    for when, words in {
        "alone": "only teacher can",
        "shared": "only the group teach (ta1, ta2, teacher)",
    }.items():
        (found,) = term["rights"][when]
        assert (found["state"], words in found["sentence"]) == ("good", True)
    assert [each["state"] for each in term["rights"]["after"]] == ["good"]
    assert term["students barred"] == {"stu1": True, "stu2": True, "stu3": True}


def test_no_command_line_holds_the_secret_of_a_page(term: dict[str, Any]) -> None:
    assert term["secret"] == {
        "served": True,
        "browser was opened": True,
        "token on a command line": False,
        "file leads to the page": True,
        "a student reads the file": False,
    }
