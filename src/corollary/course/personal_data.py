"""Personal data of one student in a course: found, exported, and taken out, with a log that names nobody."""

from __future__ import annotations

import hashlib
import io
import json
import os
import re
import shutil
import sqlite3
import zipfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath
from typing import Literal

from corollary.atomic import write_whole
from corollary.nbgrader.exchange_places import exchange_places
from corollary.nbgrader.gradebook import GradebookLocked
from corollary.problem.diagnostic import Malformed
from corollary.records.files import Course, NotACourse
from corollary.records.forgotten import note_forgotten
from corollary.records.gradebook_rows import is_database, remove_rows, rows_of
from corollary.records.manual_marks import read_manual
from corollary.records.marks import graded_sets, report_place
from corollary.records.notebook_archive import unfolded
from corollary.records.origin import set_of
from corollary.records.person import Person
from corollary.records.report_model import report_of
from corollary.records.separation import Separated, mentions, separate, texts_within
from corollary.records.settings import read_settings

Action = Literal["delete", "change", "write again"]
ROSTER, LOG, KEY = (
    (".corollary", "roster.csv"),
    (".corollary", "forgotten", "log.jsonl"),
    (".corollary", "key"),
)
PROBLEMS = (".corollary", "assigned", "problems")  # texts of problems, as they were handed out
DRAFT = re.compile(r"^\.(.+)\.[a-z0-9_]{8}$")  # what a command that was killed had not yet moved into place
JOURNALS = ("-journal", "-wal", "-shm")


@dataclass(frozen=True, slots=True)
class DataPlace:
    """One file that holds something of a student; `entries` counts the rows, records or members in it."""

    path: str
    action: Action
    entries: int = 1


@dataclass(slots=True)
class PersonalData:
    """What was found, or taken out. `left` are places that this program cannot change, with the reason and what to do."""

    places: list[DataPlace] = field(default_factory=list[DataPlace])
    left: dict[str, str] = field(default_factory=dict[str, str])

    def count(self, *actions: Action) -> int:
        return sum(each.action in actions for each in self.places)


def find_data(course: Course, person: Person) -> PersonalData:
    """Every place in a course that holds something of a student; nothing is changed."""
    found = PersonalData()
    for parts, path in _files(course):
        if (held := _held(course, parts, path, person, found)) is not None:
            found.places.append(held[0])
    for place in exchange_places(course, person.id, _digests(course, person)):
        found.places.append(DataPlace(str(place), "delete", 1))
    found.left |= _beyond_reach(course) | _by_name_alone(person)
    return found


def take_out(
    course: Course, person: Person, progress: Callable[[str], None] = lambda name: None
) -> PersonalData:
    """Takes a student out of every file of a course. Cut short anywhere, it can be run again: the roster comes last.

    Whoever calls it is the only writer in the course. Raises GradebookLocked, OSError.
    """
    done = PersonalData()
    note_forgotten(course, person.id, "begun", {})
    for place in exchange_places(course, person.id, _digests(course, person)):
        _remove_outside(place, done)
    todo = sorted(_files(course), key=lambda each: each[0] == ROSTER)
    for parts, path in todo:
        progress("/".join(parts))
        if (held := _held(course, parts, path, person, done)) is None:
            continue
        place, parted = held
        try:
            _change(course, path, parted, person, delete=place.action != "change")
        except OSError as error:
            done.left[place.path] = (
                f"cannot be changed ({error.strerror}); change its rights, then run this again"
            )
            continue
        done.places.append(place)
    _reports_again(course, done)
    done.left |= _beyond_reach(course) | _by_name_alone(person)
    for parts, path in _files(course):
        _mentioned(parts, path, person, done)
    counts = {"deleted": done.count("delete"), "changed": done.count("change", "write again")}
    note_forgotten(course, person.id, "done", counts | {"left": len(done.left)})
    return done


def person_archive(course: Course, person: Person) -> tuple[bytes, PersonalData]:
    """All that a course holds of one student, as an archive: files that are theirs, and their part of the others."""
    found, target = PersonalData(), io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for parts, path in _files(course):
            parted = _separated(course, parts, path, person, found)
            if parted is None or not parted.is_changed:
                _mentioned(parts, path, person, found)
                continue
            found.places.append(DataPlace("/".join(parts), _action(parted), parted.entries))
            where = PurePosixPath(*parts)
            for name, content in parted.theirs:
                archive.writestr(
                    str(where if parted.rest is None and name == parts[-1] else where / name), content
                )
        about = {
            "student": person.id,
            "name": person.student.name,
            "email": person.student.email,
            "course": course.name,
            "made": datetime.now(UTC).isoformat(timespec="seconds"),
            "places": [each.path for each in found.places],
            "not included": found.left | _beyond_reach(course) | _by_name_alone(person),
        }
        archive.writestr("about.json", json.dumps(about, indent=1, ensure_ascii=False))
    return target.getvalue(), found


def _files(course: Course) -> Iterator[tuple[tuple[str, ...], Path]]:
    """Every file and link below the course's folder, with its path in parts."""
    for folder, names, files in os.walk(course.folder):
        here = Path(folder)
        names[:] = sorted(name for name in names if name != ".git")
        links = [name for name in names if (here / name).is_symlink()]
        for name in sorted((*files, *links)):
            path = here / name
            yield path.relative_to(course.folder).parts, path


def _separated(
    course: Course, parts: tuple[str, ...], path: Path, person: Person, found: PersonalData
) -> Separated | None:
    """The file without the student's part; None for what has no part, or cannot be read."""
    if _is_nobodys(parts) or path.name.endswith(JOURNALS):
        return None
    below = _below(parts)
    if path.is_symlink() or not path.is_file():
        return Separated(None, (), 1) if person.owns_path(below) else None
    try:
        content = path.read_bytes()
        content = unfolded(course, content) if parts[0] == "submitted" else content
    except OSError as error:
        found.left["/".join(parts)] = (
            f"cannot be read ({error.strerror}); change its rights, then run this again"
        )
        return None
    if path == course.gradebook and is_database(content):
        rows = rows_of(path, person.id)
        theirs = (("rows.json", json.dumps(rows, indent=1, default=str).encode()),) if rows else ()
        return Separated(content, theirs, sum(map(len, rows.values())))
    if draft := DRAFT.match(parts[-1]):
        done = separate((*below[:-1], draft[1]), content, person)
        return Separated(None, (), done.entries) if done.is_changed else None
    return separate(below, content, person)


def _is_nobodys(parts: tuple[str, ...]) -> bool:
    """True for what holds no student's data, and may hold the letters of a name by chance."""
    return parts in (LOG, KEY) or parts[:3] == PROBLEMS


def _below(parts: tuple[str, ...]) -> tuple[str, ...]:
    """The part of a path that may name a student: not the course's own folders, sets and kinds of record."""
    if parts[0] == ".corollary":
        return parts[3:] or parts[-1:]
    return parts[1:] or parts


def _held(
    course: Course, parts: tuple[str, ...], path: Path, person: Person, found: PersonalData
) -> tuple[DataPlace, Separated] | None:
    """What a file holds of the student and what becomes of it, with the file without that; None where it holds nothing."""
    parted = _separated(course, parts, path, person, found)
    if parted is None:
        return None
    report = _report_action(course, parts, path, person)
    if not (parted.is_changed or report):
        return None
    return DataPlace("/".join(parts), report or _action(parted), max(1, parted.entries)), parted


def _action(parted: Separated) -> Action:
    return "delete" if parted.rest is None else "change"


def _report_action(course: Course, parts: tuple[str, ...], path: Path, person: Person) -> Action | None:
    """What becomes of a page in `reports/`: that of a set is written again; another that names the student is deleted."""
    if parts[0] != "reports" or not parts[-1].endswith(".html"):
        return None
    if len(parts) == 2 and path.stem in graded_sets(course):
        return "write again"
    return "delete" if mentions(path.read_bytes(), person) else None


def _change(course: Course, path: Path, parted: Separated, person: Person, *, delete: bool) -> None:
    if path == course.gradebook and parted.rest is not None:
        try:
            remove_rows(path, person.id)
        except sqlite3.Error as error:
            raise GradebookLocked(
                f"{path} cannot be changed ({error}); stop formgrader or the other program that has it open, then run this again"
            ) from None
    elif parted.rest is None or delete:
        path.unlink()
        folder = path.parent
        while folder != course.folder and folder.parent != course.folder and not any(folder.iterdir()):
            folder.rmdir()
            folder = folder.parent
    else:
        before = path.stat()
        write_whole(path, parted.rest, mode=before.st_mode & 0o7777)
        if os.name != "nt":
            with suppress(
                PermissionError
            ):  # of a colleague's: the file is ours from now on, with the same rights
                os.chown(path, before.st_uid, before.st_gid)
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))  # pages are held against the age of marks


def _remove_outside(place: Path, done: PersonalData) -> None:
    try:
        shutil.rmtree(place) if place.is_dir() and not place.is_symlink() else place.unlink()
        done.places.append(DataPlace(str(place), "delete", 1))
    except OSError as error:
        done.left[str(place)] = (
            f"cannot be deleted by this account ({error.strerror}); its owner, or root, has to"
        )


def _digests(course: Course, person: Person) -> frozenset[str]:
    """Digests of the student's own feedback pages, by which copies under another name are found."""
    pages = (course.folder / "feedback" / person.id).glob("*/*.html")
    return frozenset(hashlib.sha256(page.read_bytes()).hexdigest() for page in pages)


def _reports_again(course: Course, done: PersonalData) -> None:
    from corollary.render.report_page import report_page  # brings matplotlib

    formgrader = read_settings(course.folder).formgrader
    for name in graded_sets(course):
        page = report_place(course, name)
        if page.exists():
            continue
        try:
            _, problem_set = set_of(course, name)
            report = report_of(course, problem_set, read_manual(course))
            write_whole(page, report_page(report, problem_set, formgrader=formgrader))
        except (Malformed, NotACourse, LookupError) as error:
            done.left[f"reports/{name}.html"] = (
                f"is deleted, and could not be written again ({error}); run corollary report {name}"
            )


def _beyond_reach(course: Course) -> dict[str, str]:
    """Places that may hold the student's data and that no program can change for sure."""
    found: dict[str, str] = {}
    for folder in (course.folder, *course.folder.parents):
        if (folder / ".git").exists():
            found[str(folder / ".git")] = (
                "the history of the repository has every file as it was; rewrite it, or delete the repository"
            )
            break
    config = course.folder / "nbgrader_config.py"
    if config.exists() and re.search(
        r"^\s*c\.\w+\.db_url", config.read_text(encoding="utf-8", errors="replace"), re.MULTILINE
    ):
        found["db_url in nbgrader_config.py"] = (
            "the gradebook lies elsewhere; remove the student there with nbgrader db student remove"
        )
    return found


def _by_name_alone(person: Person) -> dict[str, str]:
    """What cannot be told apart where two on the roster have one name."""
    if not person.namesakes:
        return {}
    others = ", ".join(person.namesakes)
    return {
        person.student.name: f"is the name of {others}, too: what has this name and no id or address is not counted as theirs; look for it"
    }


def _mentioned(parts: tuple[str, ...], path: Path, person: Person, done: PersonalData) -> None:
    """Notes a file of others in which the student is still named."""
    if _is_nobodys(parts):
        return
    where = "/".join(parts)
    if mentions("/".join(_below(parts)).encode(), person):
        done.left[where] = "its name names the student; rename or delete it"
        return
    if path.is_symlink() or not path.is_file():
        return
    try:
        content = path.read_bytes()
    except OSError:
        return
    for inner, text in texts_within((where,), content):
        if count := mentions(text, person):
            times = f" {count} times" if count > 1 else ""
            done.left[inner] = f"names the student{times}, and is not theirs; look at it, and decide"
