"""The whole way, end to end: each student of the demonstration gets what they deserve, and a second run changes nothing."""

from __future__ import annotations

import csv
import json
import os
import re
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from tests import forked

pytestmark = pytest.mark.whole
BIN = Path(sys.executable).parent


def corollary(*words: object) -> subprocess.CompletedProcess[str]:
    return forked.run([BIN / "corollary", *words], timeout=240)


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict]:
    folder = tmp_path_factory.mktemp("course") / "demo"
    done = corollary("demo", folder, "--json")
    assert done.returncode == 0, done.stdout + done.stderr
    return folder, json.loads(done.stdout)


def test_everybody_gets_what_they_deserve(played: tuple[Path, dict]) -> None:
    _, told = played
    assert len(told["students"]) >= 12
    assert {student: row["points"] for student, row in told["students"].items()} == {
        student: row["deserved"] for student, row in told["students"].items()
    }
    assert told["fair"]


def test_the_gradebook_holds_the_same_points(played: tuple[Path, dict]) -> None:
    folder, told = played
    with sqlite3.connect(folder / "gradebook.db") as book:
        rows = dict(book.execute(
            "select s.student_id, sum(g.auto_score) from submitted_assignment s join submitted_notebook n on n.assignment_id = s.id "
            "join grade g on g.notebook_id = n.id group by s.student_id"
        ))  # fmt: skip
    for student, row in told["students"].items():
        share = 0.8 if student == "omar" else 1.0
        assert (rows[student] or 0) * share == pytest.approx(row["points"]), student


def test_a_second_run_skips_everybody_and_changes_nothing(played: tuple[Path, dict]) -> None:
    folder, told = played
    before = {path: path.read_bytes() for path in (folder / "feedback").rglob("*.html")}
    done = corollary("grade", "momentum_1", "--course", folder, "--json")
    again = json.loads(done.stdout)
    assert (again["graded"], again["skipped"]) == (0, len(told["students"]))
    assert done.returncode == 0, done.stderr
    assert len(again["failed"]) == 2, "two submissions could not be run to their end, and that is listed"
    assert corollary("grade", "momentum_1", "--course", folder, "--strict").returncode == 1
    assert {path: path.read_bytes() for path in before} == before


def test_feedback_says_what_went_wrong_and_needs_nothing_from_outside(played: tuple[Path, dict]) -> None:
    folder, _ = played
    page = (folder / "feedback" / "finn" / "momentum_1" / "momentum_1.html").read_text(encoding="utf-8")
    assert "Momentum has a direction" in page
    assert "<math" in page
    assert 'src="http' not in page
    assert 'href="http' not in page


def test_without_nbgrader_no_gradebook_is_claimed(tmp_path: Path) -> None:
    program = (
        "import sys\nsys.modules['nbgrader'] = None\nsys.argv = ['corollary', 'demo', 'demo']\n"
        "from corollary.cli.main import main\nmain()"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "gradebook.db" not in done.stdout
    assert "ormgrader" not in done.stdout
    assert "nbgrader is not installed, so there is no gradebook" in done.stdout
    assert not (tmp_path / "demo" / "gradebook.db").exists()


def test_the_last_line_works_as_printed_where_nothing_is_on_the_path(tmp_path: Path) -> None:
    bare = {**os.environ, "PATH": "/usr/bin:/bin"}
    done = subprocess.run(
        [str(BIN / "corollary"), "demo", "demo"], cwd=tmp_path, env=bare, capture_output=True, text=True, check=False
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    printed = done.stdout.splitlines()[-1].partition("for formgrader: ")[2].partition(", then")[0]
    assert printed.endswith("cd demo && jupyter lab")
    opened = subprocess.run(
        ["bash", "-c", f"{printed} --version"], cwd=tmp_path, env=bare, capture_output=True, text=True, check=False
    )  # fmt: skip
    assert opened.returncode == 0, opened.stderr
    assert re.fullmatch(r"[\d.]+", opened.stdout.strip())


def test_no_truth_in_what_students_get(played: tuple[Path, dict]) -> None:
    folder, _ = played
    for path in (folder / "release").rglob("*.ipynb"):
        text = path.read_text(encoding="utf-8")
        assert "two speeds add" not in text, "a mistake's message comes from the solution"
        assert "def derive" not in text
        assert (folder / ".corollary" / "key").read_bytes().hex() not in text


def test_nbgraders_own_commands_work_on_it(played: tuple[Path, dict], tmp_path: Path) -> None:
    folder, _ = played
    course = tmp_path / "course"
    shutil.copytree(folder, course)
    for words in (["generate_feedback", "momentum_1", "--student", "ada"], ["export", "--to", "grades.csv"]):
        done = forked.run([BIN / "nbgrader", *words], cwd=course, timeout=200)
        assert done.returncode == 0, done.stderr
    assert (course / "feedback" / "ada" / "momentum_1" / "momentum_1.html").stat().st_size > 10_000
    rows = (course / "grades.csv").read_text(encoding="utf-8").splitlines()
    assert len(rows) == 16


def test_the_report_tells_the_same(played: tuple[Path, dict]) -> None:
    folder, _ = played
    done = corollary("report", "momentum_1", "--course", folder, "--json")
    told = json.loads(done.stdout)
    assert told["handed_in"] == 15
    assert done.returncode == 0


def test_the_exported_marks_are_those_of_the_demonstration(played: tuple[Path, dict], tmp_path: Path) -> None:
    folder, shown = played
    done = corollary("export", "momentum_1", "--to", "csv", "--course", folder, "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    with (tmp_path / "momentum_1.csv").open(encoding="utf-8", newline="") as file:
        rows = {row["id"]: row for row in csv.DictReader(file)}
    for student, marks in shown["students"].items():
        assert float(rows[student]["total"]) == pytest.approx(marks["points"], abs=0.005)
    waiting = [row["P12.14 k"] for row in rows.values() if row["id"] in {"ada", "finn", "omar"}]
    assert waiting == ["", "", ""], "what a person has to mark is blank and no zero"


def test_exported_sheets_carry_the_numbers_of_the_notebooks(
    played: tuple[Path, dict], tmp_path: Path
) -> None:
    folder, _ = played
    done = corollary("export", "momentum_1", "--to", "ipynb", "--course", folder, "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    for student in ("ada", "omar"):
        handed_out = (folder / "release" / student / "momentum_1" / "momentum_1.ipynb").read_bytes()
        assert (tmp_path / f"momentum_1-{student}.ipynb").read_bytes() == handed_out
