"""nbgrader is imported to read the gradebook only when somebody has written in it."""

from __future__ import annotations

import os
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from nbgrader.api import Gradebook

from corollary.nbgrader.written_marks import is_as_seen, state
from corollary.records.files import Course

from .conftest import grade

LOADED = (
    "import sys\nfrom corollary.cli.main import main\n"
    "try:\n    main()\nfinally:\n    print(*(name for name in ('nbgrader', 'sqlalchemy', 'nbformat') if name in sys.modules), file=sys.stderr)"
)


def loaded(course: Course, *words: str) -> tuple[str, str]:
    """What a command prints, and which of the slow packages it loads."""
    done = subprocess.run(
        [sys.executable, "-c", LOADED, *words],
        cwd=course.folder,
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    return done.stdout, done.stderr.splitlines()[-1]


def give(course: Course, score: float) -> None:
    """As formgrader does."""
    with Gradebook(f"sqlite:///{course.gradebook}") as book:
        mark = book.find_grade("X12_11_c", "words", "words", "ada")
        mark.manual_score, mark.needs_manual_grade = score, False
        book.db.commit()


@pytest.mark.whole
def test_who_reads_a_report_does_not_wait_for_nbgrader(marked_course: Course) -> None:
    assert grade(marked_course, "--regrade").status == 0  # as a run of grade leaves it
    assert loaded(marked_course, "report", "words")[1] == ""
    assert loaded(marked_course, "export", "words", "--to", "csv")[1].split()[:1] != ["nbgrader"]
    give(marked_course, 1.5)
    report, packages = loaded(marked_course, "report", "words", "--json")
    assert '"points": 1.5' in report, "what a person gave is there at once"
    assert "nbgrader" in packages
    assert loaded(marked_course, "report", "words", "--json")[0] == report
    assert loaded(marked_course, "report", "words")[1] == ""


@pytest.fixture
def noted(marked_course: Course) -> Course:
    assert grade(marked_course, "--regrade").status == 0
    assert is_as_seen(marked_course, state(marked_course, 0))
    return marked_course


def other_entry(course: Course) -> None:
    give(course, 1.0)


def restored(course: Course) -> None:
    """From a backup of the same moment: another file all the same."""
    shutil.copy(course.gradebook, course.folder / "backup")
    os.replace(course.folder / "backup", course.gradebook)


def cut_short(course: Course) -> None:
    Path(f"{course.gradebook}-journal").write_bytes(b"a transaction that was cut short")


def write_ahead(course: Course) -> None:
    with sqlite3.connect(course.gradebook) as book:
        book.execute("pragma journal_mode = wal")


def garbage(course: Course) -> None:
    course.gradebook.write_bytes(b"\7garbage" * 4000)


def elsewhere(course: Course) -> None:
    with (course.folder / "nbgrader_config.py").open("a") as file:
        file.write("\nc.CourseDirectory.db_url = 'sqlite:////elsewhere.db'\n")


@pytest.mark.whole
@pytest.mark.parametrize("happens", [other_entry, restored, cut_short, write_ahead, garbage, elsewhere])
def test_whatever_may_have_changed_is_read_again(noted: Course, happens: Callable[[Course], None]) -> None:
    happens(noted)
    assert not is_as_seen(noted, state(noted, 0))


def test_a_journal_that_has_grown_is_given_to_the_gradebook(noted: Course) -> None:
    assert not is_as_seen(noted, state(noted, 1))
