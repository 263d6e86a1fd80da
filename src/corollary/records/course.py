"""A course folder: its secret key, its students, which numbers each of them was dealt, and where everything lies."""

from __future__ import annotations

import csv
import io
import json
import os
import secrets
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from corollary.problem.diagnostic import Malformed
from corollary.problem.roster import Student, read_roster

KEY_BYTES = 32
Dealt = Mapping[str, Mapping[str, int]]  # student -> code of the problem -> index of the variant in its grid


class NotACourse(LookupError):
    """The folder is no course; one sentence says what is missing."""


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


def create_course(folder: Path, roster: Iterable[Student]) -> Course:
    """A course in this folder, with this roster. A course that is there already keeps its key, and what it has dealt.

    Raises NotACourse when the key of an existing one is damaged.
    """
    folder = folder.resolve()
    secret = folder / ".corollary"
    secret.mkdir(mode=0o700, parents=True, exist_ok=True)
    if not (secret / "key").exists():
        write_atomically(secret / "key", secrets.token_bytes(KEY_BYTES), mode=0o600)
    table = io.StringIO()
    rows = csv.writer(table, lineterminator="\n")
    rows.writerow(["id", "first_name", "last_name", "email"])
    rows.writerows([student.id, student.first_name, student.last_name, student.email] for student in roster)
    write_atomically(secret / "roster.csv", table.getvalue())
    return open_course(folder)


def open_course(folder: Path) -> Course:
    """The course in a folder. Raises NotACourse."""
    folder = folder.resolve()
    try:
        key = (folder / ".corollary" / "key").read_bytes()
    except FileNotFoundError:
        raise NotACourse(
            f"{folder} is no course of ours: it has no .corollary/key; make one with corollary generate"
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
    try:
        return read_roster(course.folder / ".corollary" / "roster.csv")
    except Malformed as error:
        raise NotACourse(
            f"the roster of {course.folder} is damaged: {error}; generate again with --roster"
        ) from None


def write_dealt(course: Course, set_name: str, dealt: Dealt) -> None:
    """Records who got which numbers, so that they never change, whatever becomes of the problems."""
    text = json.dumps(
        {student: dict(dealt[student]) for student in sorted(dealt)}, indent=1, ensure_ascii=False
    )
    write_atomically(course.folder / ".corollary" / "dealt" / f"{set_name}.json", text + "\n")


def read_dealt(course: Course, set_name: str) -> dict[str, dict[str, int]]:
    """Who got which numbers; empty when the set was never dealt. Raises NotACourse when the record is damaged."""
    path = course.folder / ".corollary" / "dealt" / f"{set_name}.json"
    if not path.exists():
        return {}
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        return {
            str(student): {str(code): int(index) for code, index in row.items()}
            for student, row in record.items()
        }
    except (OSError, ValueError, TypeError, AttributeError) as error:
        raise NotACourse(f"{path} is damaged ({error}); restore it from a backup") from None


def dealt_anywhere(course: Course, student: str) -> dict[str, int]:
    """The numbers a student was dealt, by code of the problem, whatever set they came in. Raises NotACourse."""
    sets = sorted((course.folder / ".corollary" / "dealt").glob("*.json"))
    return {
        code: index for path in sets for code, index in read_dealt(course, path.stem).get(student, {}).items()
    }


def submissions(course: Course, set_name: str) -> dict[str, Path]:
    """The notebook each student handed in, by student."""
    places = sorted((course.folder / "submitted").glob("*/"))
    return {
        place.name: path
        for place in places
        if (path := _handed_in_notebook(place / set_name, set_name)) is not None
    }


def _handed_in_notebook(place: Path, set_name: str) -> Path | None:
    """The notebook of the set's name; when it was renamed on its way, the only one in the folder."""
    expected = place / f"{set_name}.ipynb"
    if expected.is_file():
        return expected
    others = [path for path in place.glob("*.ipynb") if path.is_file()]
    return others[0] if len(others) == 1 else None


def unclear(course: Course, set_name: str) -> dict[str, tuple[str, ...]]:
    """Who handed in several notebooks, none of the set's name, and what they are called: nobody can guess which counts."""
    found = {}
    for place in sorted((course.folder / "submitted").glob(f"*/{set_name}/")):
        names = tuple(sorted(path.name for path in place.glob("*.ipynb") if path.is_file()))
        if len(names) > 1 and f"{set_name}.ipynb" not in names:
            found[place.parent.name] = names
    return found


def handed_in(course: Course, set_name: str, student: str) -> datetime | None:
    """When a student handed in: what timestamp.txt says (as nbgrader writes it: 2026-12-04 21:03:11.5 UTC), else the age of
    the file, to the second; None when there is nothing."""
    place = course.place("submitted", student, set_name)
    try:
        return moment((place / "timestamp.txt").read_text(encoding="utf-8", errors="replace"))
    except (OSError, ValueError, ZoneInfoNotFoundError):
        path = _handed_in_notebook(place, set_name) or place
        return datetime.fromtimestamp(int(path.stat().st_mtime), UTC) if path.exists() else None


def moment(text: str) -> datetime:
    """The moment a timestamp.txt stands for; without a zone, UTC. Raises ValueError or ZoneInfoNotFoundError."""
    words = text[:80].split()
    if len(words) == 3 and words[2][:1].isalpha():
        zone = UTC if words[2] in {"UTC", "Z", "GMT"} else ZoneInfo(words[2])
        return datetime.fromisoformat(" ".join(words[:2])).replace(tzinfo=zone).astimezone(UTC)
    found = datetime.fromisoformat(" ".join(words[:2]) + "".join(words[2:]))
    return found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)


def write_atomically(path: Path, content: str | bytes, *, mode: int = 0o644) -> None:
    """The whole file or none of it, whenever the power goes; folders are made as needed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, draft = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:40]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(draft, mode)
        os.replace(draft, path)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise
