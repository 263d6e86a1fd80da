"""The same notebook found at another time: nobody becomes late, or in time, without being asked about."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nbgrader")

from .conftest import grade

pytestmark = pytest.mark.whole

EARLY, LATE = "2099-03-01 12:00:00 UTC", "2099-03-03 12:00:00 UTC"
# Seconds since 1970 on the day after the deadline.
AFTER_DUE = 4076222400


@pytest.fixture
def own(graded: Path, tmp_path: Path) -> Path:
    """A set with a deadline, of which ada was marked as handed in before, and ben after it."""
    file = tmp_path / "one.md"
    file.write_text(
        "---\ntitle: One exercise\ndue: 2099-03-02T12:00+00:00\ncredit: {late: 0.5}\nproblems:\n  - X12.5\n---\nOne.\n"
    )
    stamp(graded, "ada").write_text(EARLY)
    stamp(graded, "ben").write_text(LATE)
    done = grade(graded, "--yes", name=file)
    assert (done.points["ada"], done.points["ben"]) == (5.0, 2.5), done.errors
    return file


def stamp(course: Path, student: str) -> Path:
    return course / f"submitted/{student}/one/timestamp.txt"


def recorded(course: Path, student: str) -> dict[str, Any]:
    return json.loads((course / f".corollary/graded/one/{student}.json").read_bytes())


def rewritten(course: Path) -> None:
    stamp(course, "ada").write_text(LATE)


def lost(course: Path) -> None:
    stamp(course, "ben").unlink()


def unreadable(course: Path) -> None:
    stamp(course, "ben").write_text("the day before yesterday")


@pytest.mark.parametrize(
    ("happens", "student", "before", "after"),
    [(rewritten, "ada", 5.0, 2.5), (lost, "ben", 2.5, 5.0), (unreadable, "ben", 2.5, 5.0)],
)
def test_it_is_listed_and_asked_about(
    own: Path, graded: Path, happens: Callable[[Path], None], student: str, before: float, after: float
) -> None:
    os.utime(graded / f"submitted/{student}/one/one.ipynb", (AFTER_DUE, AFTER_DUE))
    kept = recorded(graded, student)
    happens(graded)
    for _ in range(2):  # what the first run wrote for nbgrader must not be taken for evidence by the second
        done = grade(graded, name=own)
        assert (done.status, done.document["written"]) == (1, False), done.errors
        assert "--yes agrees" in done.errors
        (changed,) = done.document["changed"]
        assert (changed["student"], changed["before"], changed["after"]) == (student, before, after)
        time = EARLY if student == "ada" else LATE
        assert changed["why"].startswith("changed: when it was handed in")
        assert time.removesuffix(":00 UTC") in changed["why"]
        assert recorded(graded, student) == kept
    assert grade(graded, "--yes", name=own).points[student] == after


def test_who_hands_in_something_else_is_late_by_its_own_time(own: Path, graded: Path) -> None:
    notebook = graded / "submitted/ada/one/one.ipynb"
    notebook.write_text(notebook.read_text() + "\n")
    stamp(graded, "ada").write_text(LATE)
    done = grade(graded, name=own)
    assert (done.status, done.points["ada"]) == (0, 2.5), done.errors


def test_another_time_that_moves_no_marks_needs_no_consent(own: Path, graded: Path) -> None:
    stamp(graded, "ada").write_text("2099-03-01 13:00:00 UTC")
    done = grade(graded, name=own)
    assert (done.status, done.document["changed"], done.points["ada"]) == (0, [], 5.0), done.errors
    assert recorded(graded, "ada")["depends"]["when it was handed in"] == "2099-03-01 13:00:00+00:00"
