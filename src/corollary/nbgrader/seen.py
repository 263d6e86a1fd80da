"""The state of a gradebook when it was last read; while it has not changed, nbgrader need not be imported."""

from __future__ import annotations

from contextlib import suppress
from typing import Final

import msgspec

from corollary.atomic import write_whole
from corollary.records.files import Course

SQLITE: Final = b"SQLite format 3\0"
ROLLBACK: Final = (
    b"\1\1"  # how it journals, at byte 18: with a write-ahead log the counter at byte 24 would stand still
)
# https://www.sqlite.org/fileformat.html#the_database_header


class Seen(msgspec.Struct, frozen=True):
    """The counter that SQLite raises with each transaction, the file's size, age and number, and how many entries our journal
    had: a gradebook that was written, restored or replaced differs in one of them."""

    counter: int
    size: int
    age: int
    number: int
    entries: int


def state(course: Course, entries: int) -> Seen | None:
    """The state of the gradebook with so many entries in the journal; None where it cannot be told from its file."""
    config = course.folder / "nbgrader_config.py"
    try:
        if "db_url" in config.read_text(encoding="utf-8", errors="replace"):
            return None
        about = course.gradebook.stat()
        with course.gradebook.open("rb") as file:
            head = file.read(100)
    except OSError:
        return None
    # A journal beside it is of a transaction that is being written, or was cut short and is to be taken back.
    cut_short = course.gradebook.with_name(f"{course.gradebook.name}-journal").exists()
    if head[:16] != SQLITE or head[18:20] != ROLLBACK or cut_short:
        return None
    counter = int.from_bytes(head[24:28], "big")
    return Seen(counter, about.st_size, about.st_mtime_ns, about.st_ino, entries)


def is_as_seen(course: Course, now: Seen | None) -> bool:
    """Whether nothing was written since it was last noted."""
    if now is None:
        return False
    try:
        return msgspec.json.decode(course.record("manual", "seen.json").read_bytes(), type=Seen) == now
    except (OSError, msgspec.DecodeError):
        return False


def note(course: Course, now: Seen) -> None:
    """Notes the state; where that cannot be, the gradebook is read again the next time."""
    with suppress(OSError):
        write_whole(course.record("manual", "seen.json"), msgspec.json.encode(now), mode=0o600)
