"""Marks already given move only with consent; what a student hands in anew is marked without asking."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from tests import forked

from .conftest import COMMAND, grade

pytestmark = pytest.mark.whole


@pytest.fixture
def corrected(graded: Path, tmp_path: Path) -> Path:
    """A graded course in which ada's notebook was late and lateness came to cost half."""
    (graded / "submitted/ada/one/timestamp.txt").write_text("2099-03-03 12:00:00 UTC")
    own = tmp_path / "one.md"
    own.write_text(
        "---\ntitle: One exercise\ndue: 2099-03-02T12:00+00:00\ncredit: {late: 1}\nproblems:\n  - X12.5\n---\nOne.\n"
    )
    first = grade(graded, name=own)
    assert (first.status, first.document["written"]) == (0, True), first.errors
    own.write_text(own.read_text().replace("late: 1", "late: 0.5"))
    return own


def test_without_anybody_to_ask_nothing_moves(corrected: Path, graded: Path) -> None:
    done = grade(graded, name=corrected)
    assert (done.status, done.document["written"]) == (1, False)
    assert "--yes agrees" in done.errors
    assert done.points["ada"] == 5.0
    (changed,) = done.document["changed"]
    assert (changed["student"], changed["before"], changed["after"]) == ("ada", 5.0, 2.5)
    assert changed["why"] == "changed: what late work keeps"
    record = json.loads((graded / ".corollary/graded/one/ada.json").read_text())
    assert record["points"] == 5.0
    assert grade(graded, "--yes", name=corrected).points["ada"] == 2.5


@pytest.mark.whole
def test_what_is_handed_in_anew_is_marked_while_others_wait_for_consent(
    corrected: Path, graded: Path
) -> None:
    notebook = graded / "submitted/ben/one/one.ipynb"
    nb = json.loads(notebook.read_text())
    for cell in nb["cells"]:
        if cell["id"] == "X12_5_a_answer":
            cell["source"] = "X12_5_a = 1e9"
    notebook.write_text(json.dumps(nb))
    done = grade(graded, name=corrected)
    assert done.status == 1
    assert done.points["ben"] < 5.0
    assert done.points["ada"] == 5.0
    assert [each["student"] for each in done.document["changed"]] == ["ada"]


def lines(course: Path) -> int:
    return len((course / ".corollary/history/one.jsonl").read_text().splitlines())


@pytest.mark.whole
def test_a_regrade_that_nobody_agrees_to_writes_nothing_of_anybody(corrected: Path, graded: Path) -> None:
    before = lines(graded)
    done = grade(graded, "--regrade", name=corrected)
    assert (done.status, done.document["graded"], set(done.document["held"])) == (1, 0, {"ada", "ben", "cyd"})
    assert lines(graded) == before
    assert grade(graded, "--regrade", "--yes", name=corrected).document["graded"] == 3
    assert lines(graded) == before + 3


def test_what_happened_is_said_and_nothing_else(corrected: Path, graded: Path) -> None:
    def said(*words: str) -> str:
        line = [COMMAND, "grade", corrected, "--course", graded, "--jobs", "1", *words]
        return forked.run(list(map(str, line)), capture_output=True, encoding="utf-8", check=False).stdout

    assert "would grade 3, unchanged 0" in said("--dry-run")
    assert "graded 2, held back 1 (not confirmed), unchanged 0" in said()
    assert "graded 0, held back 1 (not confirmed), unchanged 2" in said()
    dry = grade(graded, "--dry-run", name=corrected).document
    assert (dry["graded"], dry["held"], dry["written"]) == (0, ["ada"], False)


@pytest.mark.whole
def test_more_time_is_agreed_to_by_whoever_gave_it(graded: Path, tmp_path: Path) -> None:
    """`extend` is consent: `grade` moves that student's marks up without asking, and asks when the time is taken back."""
    (graded / "submitted/ada/one/timestamp.txt").write_text("2099-03-03 12:00:00 UTC")
    own = tmp_path / "one.md"
    own.write_text(
        "---\ntitle: One exercise\ndue: 2099-03-02T12:00+00:00\ncredit: {late: 0.5}\nproblems:\n  - X12.5\n---\nOne.\n"
    )
    assert grade(graded, "--yes", name=own).points["ada"] == 2.5

    def extend(*words: str) -> None:
        line = [COMMAND, "extend", "ada", own, *words, "--course", graded]
        forked.run(list(map(str, line)), check=True, capture_output=True)

    extend("2099-03-05")
    done = grade(graded, name=own)
    assert (done.status, done.points["ada"]) == (0, 5.0), done.errors
    assert "ada has 5 points instead of 2.5" in done.errors
    extend("--remove")
    done = grade(graded, name=own)
    assert (done.status, done.points["ada"]) == (1, 5.0), done.errors


@pytest.mark.whole
def test_a_broken_file_is_listed_and_costs_the_status_only_when_it_is_asked_to(graded: Path) -> None:
    (graded / "submitted/cyd/one/one.ipynb").write_text("{")
    done = grade(graded)
    assert (done.status, done.document["failed"]) == (0, ["cyd"])
    assert grade(graded, "--strict").status == 1
