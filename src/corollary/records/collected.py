"""What was collected: every file that came, what became of it, and a copy of each notebook, those that were not taken too."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime

import msgspec

from corollary.atomic import write_whole
from corollary.records.files import Course

ACCEPTED, UNCHANGED, OLDER, UNUSABLE, NOBODY = "accepted", "unchanged", "older", "unusable", "nobody's"
WORKSHEET, GUESSED = "worksheet", "guessed"  # where a time is from; "" for what the file or its archive says


class Arrival(msgspec.Struct, frozen=True):
    """One file: whose ("" when nobody knows), where it lay, when it was handed in (UTC, or "" when that is unknown), what became
    of it, why, and the digest of its content ("" when it was not read). `number` is what an LMS knows the student by; `time` is where
    `when` is from: Moodle's WORKSHEET, or GUESSED."""

    student: str
    file: str
    when: str
    outcome: str
    why: str = ""
    digest: str = ""
    number: str = ""
    time: str = ""

    def __post_init__(self) -> None:
        for field in ("student", "file", "why", "number"):
            msgspec.structs.force_setattr(self, field, writable(getattr(self, field)))


def writable(text: str) -> str:
    """The text with what is no Unicode written out (`\\udcff`): names of files are bytes, and may be in any encoding."""
    return text.encode("utf-8", "backslashreplace").decode()


def digest_of(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def read_arrivals(course: Course, set_name: str) -> tuple[Arrival, ...]:
    """All that was ever collected of a set, oldest first; none when there was none, or the record is damaged."""
    try:
        content = course.record("collected", f"{set_name}.json").read_bytes()
        return msgspec.json.decode(content, type=tuple[Arrival, ...])
    except (OSError, msgspec.DecodeError):
        return ()


def remember(course: Course, set_name: str, arrivals: Iterable[Arrival]) -> None:
    """Adds what came; what came before with the same content and outcome is not written twice, unless its time is another."""
    known = read_arrivals(course, set_name)
    seen = {_identity(each) for each in known}
    new = [
        each for each in arrivals
        if (each.outcome != UNCHANGED or each.time == WORKSHEET) and _identity(each) not in seen
    ]  # fmt: skip
    if new:
        write_whole(
            course.record("collected", f"{set_name}.json"), msgspec.json.encode([*known, *new]), mode=0o600
        )


def without_owner(arrivals: Sequence[Arrival]) -> tuple[Arrival, ...]:
    """Those of which nobody knows whose they are, and which nobody's came after: by the same name, or with the same content."""
    found = dict[str, Arrival]()
    for each in arrivals:
        if each.outcome == NOBODY:
            found[each.file] = each
        elif each.student:
            found.pop(each.file, None)
            found = {file: one for file, one in found.items() if not one.digest or one.digest != each.digest}
    return tuple(found.values())


def _identity(each: Arrival) -> tuple[str, ...]:
    outcome = ACCEPTED if each.outcome == UNCHANGED else each.outcome
    when = each.when if each.time and outcome == ACCEPTED else ""
    return each.student, each.file, each.digest, outcome, when


def keep(course: Course, set_name: str, student: str, content: bytes) -> None:
    """A copy of a notebook by its digest: whatever is taken later, it can be looked at."""
    place = course.record("collected", f"{set_name}/{student}/{digest_of(content)[:16]}.ipynb")
    if not place.exists():
        write_whole(place, content, mode=0o600)


def numbers_of(arrivals: Sequence[Arrival]) -> dict[str, str]:
    """The numbers by which an LMS knows the students, as "moodle 17", with the id of each."""
    return {each.number: each.student for each in arrivals if each.number and each.student}


def stamp(when: datetime) -> str:
    """A moment as nbgrader writes it into timestamp.txt."""
    return f"{when.astimezone(UTC):%Y-%m-%d %H:%M:%S.%f} UTC"
