"""A course folder: its secret key, its students, where everything lies, and the lock of whoever writes in it."""

from __future__ import annotations

import csv
import io
import os
import re
import secrets
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from time import monotonic, sleep
from typing import Final

from corollary.atomic import make_folders, write_whole
from corollary.messages import did_you_mean, few
from corollary.problem.csv_table import read_table
from corollary.problem.diagnostic import Malformed
from corollary.problem.roster import COLUMNS, Student
from corollary.records.lms_names import Directory

KEY_BYTES = 32
SET_UP_BEFORE = {"corollary.toml", "nbgrader_config.py"}  # beside which nobody else's work lies in the folder
# What nbgrader puts beside a notebook that was handed in.
BESIDE = {"timestamp.txt", "submission_secret.txt"}
PARTITIONS = ("section", "group")  # columns of the roster's copy where the roster had such
GIVEN = "id as given"  # in the roster's copy: what stood in the column `id` before it became a folder's name
OUTSIDE = re.compile(r"^\.|[/\\\x00]")  # what would lead out of the course's folders


class NotACourse(LookupError):
    """The folder is no course; one sentence says what is missing."""


class UnknownStudent(LookupError):
    """Nobody on the roster is called so; one sentence says who is meant."""


class BeingGraded(Exception):
    """Another run is writing in this course; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Course:
    """`key` is what the numbers of every student follow from: whoever has it can work out every sheet."""

    folder: Path
    key: bytes = field(repr=False)

    @property
    def name(self) -> str:
        return self.folder.name

    @property
    def gradebook(self) -> Path:
        return self.folder / "gradebook.db"

    def place(self, step: str, student: str, set_name: str) -> Path:
        """The folder of a step ("source", "release", "submitted", "autograded", "feedback"); student `.`: nobody's own."""
        return self.folder / step / student / set_name

    def notebook(self, step: str, student: str, set_name: str) -> Path:
        return self.place(step, student, set_name) / f"{set_name}.ipynb"

    def record(self, kind: str, name: str) -> Path:
        """Where a record of ours lies, as `record("assigned", "week1.json")`."""
        return self.folder / ".corollary" / kind / name


def create_course(folder: Path, roster: Iterable[Student]) -> Course:
    """A course in this folder, with this roster. A course that is there already keeps its key and its assigned numbers; a new
    folder is its owner's alone.

    Raises NotACourse when the key of an existing one is damaged.
    """
    folder = folder.resolve()
    secret = folder / ".corollary"
    if not folder.exists():
        make_folders(folder.parent)
        folder.mkdir(mode=0o700)
    elif not secret.exists() and {each.name for each in folder.iterdir()} <= SET_UP_BEFORE:
        folder.chmod(0o700)
    secret.mkdir(mode=0o700, exist_ok=True)
    if not (secret / "key").exists():
        write_whole(secret / "key", secrets.token_bytes(KEY_BYTES), mode=0o600)
    write_whole(secret / "roster.csv", roster_table(roster))
    return open_course(folder)


def open_course(folder: Path) -> Course:
    """The course in a folder. Raises NotACourse."""
    folder = folder.resolve()
    try:
        key = (folder / ".corollary" / "key").read_bytes()
    except FileNotFoundError:
        raise NotACourse(
            f"{folder} is not a course of Corollary: it has no .corollary/key; make one with corollary generate"
        ) from None
    except OSError as error:
        raise NotACourse(f"the key of the course in {folder} cannot be read: {error.strerror}") from None
    if len(key) != KEY_BYTES:
        raise NotACourse(
            f"{folder}/.corollary/key is damaged: {len(key)} bytes, not {KEY_BYTES}; restore it from a backup"
        )
    return Course(folder, key)


def students(course: Course) -> tuple[Student, ...]:
    """Everybody on the course's own copy of the roster. Raises NotACourse."""
    path = course.folder / ".corollary" / "roster.csv"
    try:
        rows = read_table(path, COLUMNS).rows
    except Malformed as error:
        raise NotACourse(
            f"the roster of {course.folder} is damaged: {error}; generate again with --roster"
        ) from None
    headings = rows[0][1] if rows else ()
    if not set(COLUMNS) <= set(headings):
        raise NotACourse(
            f"the roster of {course.folder} is damaged: {path}:1: has no columns {', '.join(COLUMNS)}; "
            "generate again with --roster"
        )
    places = [headings.index(name) for name in COLUMNS]
    others = [(at, heading) for at, heading in enumerate(headings) if at not in places]
    found: list[Student] = []
    for line, row in rows[1:]:
        if len(row) != len(headings) or not row[places[0]] or OUTSIDE.search(row[places[0]]):
            raise NotACourse(
                f"the roster of {course.folder} is damaged: {path}:{line}: {', '.join(row)} is not a student; "
                "generate again with --roster"
            )
        name, first, last, email = (row[at] for at in places)
        ids = tuple(
            ("id" if heading == GIVEN else heading, row[at])
            for at, heading in others
            if row[at] and heading not in PARTITIONS
        )
        own = {heading: row[at] for at, heading in others if heading in PARTITIONS}
        found.append(Student(name, first, last, email, ids, **own))
    return tuple(found)


def students_in(course: Course, section: str = "", group: str = "") -> tuple[Student, ...]:
    """Those of a section and a group; everybody where neither is named. Raises UnknownStudent where there is nobody."""
    everybody = students(course)
    found = tuple(each for each in everybody if each.is_in(section, group))
    if found or not (section or group):
        return found
    wanted = " and ".join(f"{what} {name}" for what, name in (("section", section), ("group", group)) if name)
    have = sorted({each.section for each in everybody if each.section})
    groups = sorted({each.group for each in everybody if each.group})
    known = [f"{what}s {few(names, 10)}" for what, names in (("section", have), ("group", groups)) if names]
    raise UnknownStudent(
        f"nobody on the roster of {course.folder} is in {wanted}; it has {' and '.join(known) or 'no sections and no groups'}"
        + (
            ""
            if known
            else ": give the roster a column section or group, and run corollary generate with it again"
        )
    )


def ids_in(course: Course, section: str | None, group: str | None) -> frozenset[str] | None:
    """The ids of those of a section and a group; None where neither is named. Raises UnknownStudent where there is nobody."""
    if not section and not group:
        return None
    return frozenset(each.id for each in students_in(course, section or "", group or ""))


def find_student(course: Course, name: str) -> Student:
    """Who on the roster has this id, this address, or this id elsewhere. Raises UnknownStudent and NotACourse."""
    everybody = students(course)
    for each in everybody:
        if name in (each.id, each.email, *(other for _, other in each.ids)) and name:
            return each
    if meant := ids_of(name, everybody):
        raise UnknownStudent(
            f"{name} is not an id on the roster of {course.folder}; did you mean {' or '.join(meant)}?"
        )
    hint = did_you_mean(name, (each.id for each in everybody))
    raise UnknownStudent(
        f"{name} is not on the roster of {course.folder}{hint}; run corollary generate with a roster that includes them"
    )


def ids_of(name: str, roster: Sequence[Student]) -> list[str]:
    """The ids of those who have this whole name, or this id but for the zeros in front of it."""
    directory = Directory(roster)
    named = directory.by_name(name)
    number = name.strip().lstrip("0")
    padded = [each.id for each in roster if number and each.id.lstrip("0") == number]
    return [named] if named else directory.namesakes(name) or padded


def roster_table(roster: Iterable[Student]) -> str:
    """The text of a roster's CSV file: nbgrader's columns, then whatever else the students' ids are called by elsewhere."""
    roster = tuple(roster)
    given = {each.id: dict(each.ids).get("id", "") for each in roster}
    headings = (GIVEN,) if any(value not in ("", own) for own, value in given.items()) else ()
    headings += tuple(
        dict.fromkeys(heading for each in roster for heading, _ in each.ids if heading not in COLUMNS)
    )
    partitions = tuple(name for name in PARTITIONS if any(getattr(each, name) for each in roster))
    table = io.StringIO()
    rows = csv.writer(table, lineterminator="\n")
    rows.writerow([*COLUMNS, *headings, *partitions])
    for each in roster:
        about = [
            given[each.id] if heading == GIVEN else dict(each.ids).get(heading, "") for heading in headings
        ]
        own = [getattr(each, name) for name in partitions]
        rows.writerow([each.id, each.first_name, each.last_name, each.email, *about, *own])
    return table.getvalue()


PATIENCE_S: Final = 2.0


@contextmanager
def one_writer(course: Course) -> Generator[None]:
    """Held while something is written that two must not write at once. Raises BeingGraded, when another has it for longer than
    saving a mark takes.

    A lock which the system releases when its holder ends, however it ends: no stale lock file is left.
    """
    until = monotonic() + PATIENCE_S
    while (descriptor := _locked(course.folder / ".corollary")) is None and monotonic() < until:
        sleep(0.05)
    if descriptor is None:
        raise BeingGraded(
            f"another corollary command is running in {course.folder}; wait until it has ended, then run this again"
        )
    try:
        yield
    finally:
        os.close(descriptor)


def at_work(course: Course) -> bool:
    """Whether another run is writing in the course; nothing is changed by asking."""
    folder = course.folder / ".corollary"
    if os.name == "nt" and not (folder / "lock").exists():
        return False
    descriptor = _locked(folder)
    if descriptor is not None:
        os.close(descriptor)
    return descriptor is None


def _locked(folder: Path) -> int | None:
    """An open file that holds the lock; None when another has it. The folder itself is locked, and on Windows a file in it."""
    try:
        import fcntl
    except ModuleNotFoundError:
        import msvcrt

        descriptor = os.open(folder / "lock", os.O_RDWR | os.O_CREAT)
        take: Callable[[], None] = partial(msvcrt.locking, descriptor, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
    else:
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        take = partial(fcntl.flock, descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    try:
        take()
    except OSError:  # BlockingIOError, or PermissionError on Windows
        os.close(descriptor)
        return None
    return descriptor
