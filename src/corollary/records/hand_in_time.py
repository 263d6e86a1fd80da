"""When something was handed in: what timestamp.txt says, or a guess where it says nothing, which makes nobody late.

A guess, and what was found in its place, is recorded below `.corollary/times`: neither is lost when a timestamp.txt is written
for nbgrader, which wants one.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

import msgspec

from corollary.atomic import write_whole
from corollary.problem.problem_set import ProblemSet
from corollary.records.collected import stamp
from corollary.records.deadlines import Terms
from corollary.records.files import Course
from corollary.sandbox.file import Unreadable, bytes_of

STAMP = "timestamp.txt"


class GuessedTime(msgspec.Struct, frozen=True, omit_defaults=True):
    """A moment that nobody said. `found` is what stood in timestamp.txt (empty: nothing that could be read), `aside` the file below
    `.corollary/times` that has it now (empty: there was none); `after_due`: the notebook itself is from after the deadline."""

    moment: datetime
    found: str = ""
    aside: str = ""
    after_due: bool = False


def lateness(course: Course, problem_set: ProblemSet, student: str, terms: Terms) -> float:
    """Seconds after the student's own deadline; 0 in time, for who is excused, and where the time is a guess."""
    when = handed_in(course, problem_set.name, student)
    if when is None or terms.due is None or terms.excused or _is_guess(course, problem_set.name, student):
        return 0.0
    return max(0.0, (when - terms.due.astimezone(UTC)).total_seconds())


def handed_in(course: Course, set_name: str, student: str) -> datetime | None:
    """When a student handed in: what timestamp.txt says (as nbgrader writes it: 2026-12-04 21:03:11.5 UTC), else the age of
    the file, to the second; None when there is nothing."""
    if (by_file := stated(course, set_name, student)) is not None:
        return by_file
    place = course.place("submitted", student, set_name)
    return _age(handed_in_notebook(place, set_name) or place)


def stated(course: Course, set_name: str, student: str) -> datetime | None:
    """What timestamp.txt says; None when it says no time, or there is none."""
    try:
        return moment(beside(course, set_name, student, STAMP).decode("utf-8", "replace"))
    except (OSError, ValueError, OverflowError, ZoneInfoNotFoundError):
        return None


def settle_time(course: Course, set_name: str, student: str, terms: Terms) -> None:
    """Where timestamp.txt says no time: records a guess, sets what stood there aside, and writes the guess for nbgrader.

    Nothing is overwritten that could not be set aside. Whoever calls it is the only writer in the course. Raises OSError when
    the record cannot be written.
    """
    place, age = course.place("submitted", student, set_name), handed_in(course, set_name, student)
    own = (course.folder / "submitted").resolve() / student / set_name
    # A folder that is a link leads into another student's, one that is closed takes no file: both are reported as unreadable.
    if age is None or place.resolve() != own or stated(course, set_name, student) is not None:
        return
    content = bytes_of(place / STAMP, 1 << 10, course.folder / "submitted")
    if isinstance(content, Unreadable) and content.machine_failed:
        return
    late = terms.due is not None and age > terms.due
    moment = terms.due.astimezone(UTC) if terms.due is not None and late else age
    before = guessed_time(course, set_name, student)
    found, aside = (before.found, before.aside) if before is not None else ("", "")
    if os.path.lexists(place / STAMP):
        found = content.decode("utf-8", "backslashreplace") if isinstance(content, bytes) else ""
        count = len(list(_record(course, set_name, student).parent.glob(f"{student}.*.txt")))
        aside = f"{student}.{count + 1}.txt"
    record = GuessedTime(moment, found.strip(), aside, late)
    write_whole(_record(course, set_name, student), msgspec.json.encode(record), mode=0o600)
    with suppress(
        OSError
    ):  # on another disk, or not ours to move: it stays, and the time is a guess all the same
        if os.path.lexists(place / STAMP):
            os.replace(place / STAMP, _record(course, set_name, student).with_name(aside))
        write_whole(place / STAMP, stamp(moment))


def guessed_time(course: Course, set_name: str, student: str) -> GuessedTime | None:
    """The guess that stands for a student's time; None where timestamp.txt says another by now, or always did."""
    try:
        guess = msgspec.json.decode(_record(course, set_name, student).read_bytes(), type=GuessedTime)
    except (OSError, msgspec.DecodeError):
        return None
    return guess if stated(course, set_name, student) in {None, guess.moment} else None


def why_guessed(set_name: str, student: str, guess: GuessedTime) -> str:
    """A sentence on a guess that matters, and what to do; nothing for a notebook that is from before the deadline anyway."""
    remedy = f"write the time into submitted/{student}/{set_name}/{STAMP} if you know it"
    if guess.found or guess.aside:
        what = (
            f"said no time but {guess.found[:60]!r}"
            if guess.found
            else "was blank, too large, a link, or no file"
        )
        where = f" (it lies in .corollary/times/{set_name}/{guess.aside})" if guess.aside else ""
        return f"{STAMP} {what}{where}: taken as in time; {remedy}"
    if guess.after_due:
        return f"nothing said when it was handed in, and the file is from after the deadline: taken as in time; {remedy}"
    return ""


def all_guessed(set_name: str, guesses: Mapping[str, GuessedTime]) -> Iterator[str]:
    """A line on each guess that matters, with whose it is; one for all of whom there is the same to say."""
    alike: dict[str, list[str]] = {}
    for student, guess in guesses.items():
        alike.setdefault(why_guessed(set_name, "STUDENT", guess), []).append(student)
    for sentence, who in alike.items():
        if sentence:
            one = sentence if len(who) > 1 else why_guessed(set_name, who[0], guesses[who[0]])
            yield f"{', '.join(who)}: {one}"


def beside(course: Course, set_name: str, student: str, file: str) -> bytes:
    """What is in a small file beside the notebook; nothing when there is none that can be read.

    It is a stranger's like the notebook: it may be a pipe, forty gigabytes, or a link to a device or to the course's key.
    """
    content = bytes_of(
        course.place("submitted", student, set_name) / file, 1 << 10, course.folder / "submitted"
    )
    return content if isinstance(content, bytes) else b""


def moment(text: str) -> datetime:
    """The moment a timestamp.txt stands for; without a zone, UTC. Raises ValueError or ZoneInfoNotFoundError."""
    words = text[:80].split()
    if len(words) == 3 and words[2][:1].isalpha():
        zone = UTC if words[2] in {"UTC", "Z", "GMT"} else ZoneInfo(words[2])
        return datetime.fromisoformat(" ".join(words[:2])).replace(tzinfo=zone).astimezone(UTC)
    found = datetime.fromisoformat(" ".join(words[:2]) + "".join(words[2:]))
    return found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)


def handed_in_notebook(place: Path, set_name: str) -> Path | None:
    """The notebook of the set's name; when it was renamed on its way, the only one in the folder.

    Whatever else stands in its place (a link that leads nowhere, a pipe, a folder) was handed in too, and so was what lies in
    a folder that cannot be looked into: reading it says what is wrong.
    """
    expected = place / f"{set_name}.ipynb"
    try:
        expected.lstat()
        return expected
    except (FileNotFoundError, NotADirectoryError):
        others = notebook_names(place)
        return place / others[0] if len(others) == 1 else None
    except OSError:
        return expected


def notebook_names(place: Path) -> list[str]:
    """The names of the notebooks in a folder; of none that is closed, or no folder."""
    return [name for name in file_names(place) if Path(name).match("*.ipynb")]


def file_names(place: Path) -> list[str]:
    try:
        return sorted(name for name in os.listdir(place) if not name.startswith("."))
    except OSError:
        return []


def _is_guess(course: Course, set_name: str, student: str) -> bool:
    return stated(course, set_name, student) is None or guessed_time(course, set_name, student) is not None


def _age(path: Path) -> datetime | None:
    """When it was last written, to the second; of a link itself, and not of what it leads to."""
    try:
        return datetime.fromtimestamp(int(path.lstat().st_mtime), UTC)
    except (OSError, ValueError, OverflowError):
        return None


def _record(course: Course, set_name: str, student: str) -> Path:
    return course.record("times", f"{set_name}/{student}.json")
