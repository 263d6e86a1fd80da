"""Checks of nbgrader: its version, the program it starts by name, the gradebook of a course, and the exchange."""

from __future__ import annotations

import os
import shutil
import sqlite3
import sys
from collections.abc import Iterator
from contextlib import closing
from importlib.metadata import version
from pathlib import Path

from corollary.extras import installing
from corollary.nbgrader.config import BrokenConfig
from corollary.nbgrader.gradebook import NoNbgrader, NotRegistered, need_nbgrader, settings
from corollary.problem.diagnostic import Finding
from corollary.records.files import Course

WITHOUT = "marks are in the report and the feedback pages only"


def nbgrader_findings(course: Course | None) -> Iterator[Finding]:
    """What was found, without changing anything."""
    try:
        need_nbgrader()
    except NoNbgrader:
        yield Finding("nbgrader", "weak", f"not installed: {WITHOUT}", installing("nbgrader"))
        return
    yield Finding("nbgrader", "good", version("nbgrader"))
    yield _alembic()
    if course is not None:
        yield _config(course)
        yield _gradebook(course)
    yield _exchange(course)


def _alembic() -> Finding:
    """nbgrader starts it by name. Our commands look beside Python, too; nbgrader's own do not."""
    if found := shutil.which("alembic"):
        return Finding("alembic", "good", found)
    beside = Path(sys.executable).parent
    if shutil.which("alembic", path=str(beside)):
        return Finding(
            "alembic",
            "weak",
            f"in {beside}, which is not on the PATH: nbgrader's own commands cannot make a gradebook",
            f'activate the environment, or export PATH="{beside}:$PATH"',
        )
    return Finding(
        "alembic", "broken", "missing; nbgrader needs it to make a gradebook", "pip install alembic"
    )


def _config(course: Course) -> Finding:
    path = course.folder / "nbgrader_config.py"
    try:
        settings(course)
    except NotRegistered:
        return Finding(
            "nbgrader_config.py", "weak", "none in the course yet", "corollary generate SET writes it"
        )
    except BrokenConfig as error:
        return Finding("nbgrader_config.py", "broken", str(error), "correct the file")
    return Finding("nbgrader_config.py", "good", str(path))


def _gradebook(course: Course) -> Finding:
    path, name = course.gradebook, "gradebook"
    if not path.exists():
        return Finding(name, "weak", "not made yet", "corollary generate SET, or grade, makes it")
    remedy = "restore it from a backup, or move it away and grade again: all marks are written into a new one"
    try:
        with closing(sqlite3.connect(f"{path.as_uri()}?mode=ro", uri=True, timeout=1)) as book:
            answer = str(book.execute("PRAGMA quick_check(1)").fetchone()[0])
            count = int(book.execute("SELECT count(*) FROM assignment").fetchone()[0])
            book.execute("SELECT count(*) FROM grade").fetchone()
    except sqlite3.OperationalError as error:
        if "locked" in str(error):
            return Finding(name, "weak", f"{path} is locked by another program", "close it before you grade")
        return Finding(name, "broken", f"{path}: {error}", remedy)
    except sqlite3.DatabaseError as error:
        return Finding(name, "broken", f"{path}: {error}", remedy)
    if answer != "ok":
        return Finding(name, "broken", f"{path}: {answer}", remedy)
    if not os.access(path, os.W_OK):
        return Finding(name, "broken", f"{path} cannot be written", f"chmod u+w {path}")
    return Finding(name, "good", f"{path}, {count} {'assignment' if count == 1 else 'assignments'}")


def _exchange(course: Course | None) -> Finding:
    """nbgrader's folder between instructors and students: everybody must be able to write in it."""
    from nbgrader.exchange import ExchangeFactory
    from traitlets import TraitError
    from traitlets.config import Config

    try:
        found = settings(course) if course is not None else Config()
        factory = ExchangeFactory(config=found)
        root = getattr(factory.exchange(config=found), "root", "")
    except (NotRegistered, BrokenConfig, TraitError, ImportError) as error:
        return Finding("exchange", "weak", f"cannot be determined: {error}", "correct nbgrader_config.py")
    if not root:
        return Finding("exchange", "good", f"{factory.exchange.__name__}, which has no folder")
    place, remedy = (
        Path(root),
        f"mkdir -p {root} && chmod a+rwx {root}; needed only to hand out work through it",
    )
    if not place.is_dir():
        return Finding("exchange", "weak", f"{root} is not there", remedy)
    if not os.access(place, os.W_OK | os.X_OK):
        return Finding("exchange", "weak", f"{root} cannot be written to by you", remedy)
    if place.stat().st_mode & 0o007 != 0o007:
        return Finding(
            "exchange", "weak", f"{root} is not open to everybody, so students cannot hand in", remedy
        )
    return Finding("exchange", "good", root)
