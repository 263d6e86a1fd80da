"""The gradebook of a course, opened through nbgrader's own code; what can go wrong on the way is said in a sentence."""

from __future__ import annotations

import os
import sqlite3
import sys
from collections.abc import Generator
from contextlib import closing, contextmanager
from errno import EACCES, ENOSPC
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.atomic import rights_in
from corollary.extras import installing
from corollary.nbgrader.config import broken
from corollary.records.files import Course
from corollary.records.manual_marks import read_manual

if TYPE_CHECKING:
    from nbgrader.api import Gradebook
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config


class NoNbgrader(Exception):
    """nbgrader is not installed."""


class GradebookLocked(Exception):
    """Another program is writing in the gradebook."""


class GradebookUnusable(Exception):
    """The gradebook's file is none, or is damaged; one sentence says which, and what to do."""


class NotRegistered(LookupError):
    """The gradebook does not know the set, or not as it is now."""


def need_nbgrader() -> None:
    """Raises NoNbgrader, which says how to get it."""
    try:
        import nbgrader.api  # noqa: F401  # pyright: ignore[reportUnusedImport]
    except ImportError:
        raise NoNbgrader(f"a gradebook needs nbgrader; install it with: {installing('nbgrader')}") from None


def has_nbgrader() -> bool:
    """Whether nbgrader is installed; without importing it, which takes its time."""
    return find_spec("nbgrader") is not None


def has_gradebook(course: Course) -> bool:
    """Whether the course has a gradebook that can be read here; one elsewhere is named in the course's settings."""
    config = course.folder / "nbgrader_config.py"
    if not has_nbgrader() or not config.exists():
        return False
    return course.gradebook.exists() or "db_url" in config.read_text(encoding="utf-8", errors="replace")


def settings(course: Course) -> Config:
    """What the course's nbgrader_config.py sets. Raises NotRegistered when there is none, BrokenConfig when it cannot be run."""
    from traitlets.config.loader import ConfigFileNotFound, PyFileConfigLoader

    try:
        found = PyFileConfigLoader("nbgrader_config.py", path=str(course.folder)).load_config()
    except ConfigFileNotFound:
        raise NotRegistered(
            f"{course.folder} has no nbgrader_config.py; make it with corollary generate"
        ) from None
    except (Exception, SystemExit) as error:  # it is a program of its owner's, and may raise anything
        raise broken(course, error) from None
    found.CourseDirectory.root = str(course.folder)
    return found


def directory(course: Course) -> CourseDirectory:
    """nbgrader's own picture of the folder."""
    from nbgrader.coursedir import CourseDirectory
    from traitlets import TraitError

    try:
        return CourseDirectory(config=settings(course))
    except TraitError as error:
        raise broken(course, error) from None


@contextmanager
def gradebook(course: Course) -> Generator[Gradebook]:
    """The open gradebook, made when there is none.

    Raises NoNbgrader, NotRegistered and BrokenConfig, and GradebookLocked and GradebookUnusable from whatever is done within.
    """
    need_nbgrader()
    from nbgrader.api import Gradebook
    from sqlalchemy.exc import ArgumentError, DatabaseError

    place = directory(course)
    try:
        if not course.gradebook.exists() and str(course.gradebook) in place.db_url:
            _new(course, place)
        try:
            with programs_on_path():
                book = Gradebook(place.db_url, place.course_id)
        except (
            ArgumentError,
            ImportError,
        ) as error:  # no URL, or of a database that nothing here can speak to
            raise broken(course, error) from None
        with book:
            yield book
    except DatabaseError as error:
        if "disk is full" in str(error.orig):
            raise OSError(ENOSPC, os.strerror(ENOSPC), str(course.gradebook)) from None
        if "readonly" in str(error.orig):
            with course.gradebook.open("r+b"):  # it raises why: the file's rights, or those of the whole disk
                raise PermissionError(EACCES, os.strerror(EACCES), str(course.gradebook.parent)) from None
        if "locked" not in str(error.orig):
            raise GradebookUnusable(
                f"{course.gradebook} cannot be used ({error.orig}); restore it from a backup, or move it away and grade again: "
                "all marks are written into a new one, those given by hand too"
            ) from None
        raise GradebookLocked(
            f"{course.gradebook} is locked by another program; close formgrader or the other grading run, and grade again"
        ) from None


def concerns_everybody() -> tuple[type[Exception], ...]:
    """What writing into the gradebook raises that is about no one student: it is locked, damaged, or does not know the set."""
    if not has_nbgrader():
        return (NotRegistered,)
    from sqlalchemy.exc import DatabaseError

    return NotRegistered, DatabaseError


def _new(course: Course, place: CourseDirectory) -> None:
    """A gradebook made beside its place and then moved there, so that one half made is never met."""
    from nbgrader.api import Gradebook

    draft = course.gradebook.with_name(".gradebook.draft")
    draft.unlink(missing_ok=True)
    _stamp(draft)
    with Gradebook(f"sqlite:///{draft}", place.course_id) as book:
        has_seen(
            book, read_manual(course).count
        )  # its rows are filled with what persons gave as they are made
        book.db.commit()
    os.chmod(draft, rights_in(course.folder, 0o644))  # SQLite gives its journal the same
    os.replace(draft, course.gradebook)


def _stamp(draft: Path) -> None:
    """Writes which of its revisions nbgrader makes tables of, by which its `db upgrade` goes. In an empty file nbgrader does so
    itself, but starts the program `alembic` for it, which takes longer than all the rest."""
    from alembic.script import ScriptDirectory

    import nbgrader

    head = ScriptDirectory(str(Path(nbgrader.__file__).parent / "alembic")).get_current_head()
    with closing(sqlite3.connect(draft)) as base, base:
        base.execute("CREATE TABLE alembic_version (version_num VARCHAR(32) NOT NULL)")
        base.execute("INSERT INTO alembic_version VALUES (?)", (head,))


def seen(book: Gradebook) -> int | None:
    """How many entries of the journal of manual marks a gradebook has seen, by SQLite's `user_version`, a number that is an
    application's to use. None where the gradebook is on a database server, which has backups of its own, and is believed."""
    from sqlalchemy import text

    if book.engine.dialect.name != "sqlite":
        return None
    return int(book.db.execute(text("PRAGMA user_version")).scalar() or 0)


def has_seen(book: Gradebook, count: int) -> None:
    """Notes in the gradebook that it has seen so many."""
    from sqlalchemy import text

    before = seen(book)
    if before is not None and before < count:
        book.db.execute(text(f"PRAGMA user_version = {count:d}"))


@contextmanager
def programs_on_path() -> Generator[None]:
    """nbgrader starts the program `alembic` by name: it must be found although no environment was activated."""
    before = os.environ.get("PATH", os.defpath)
    os.environ["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{before}"
    try:
        yield
    finally:
        os.environ["PATH"] = before
