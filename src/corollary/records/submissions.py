"""Submissions: files collected, times of handing in, whose notebooks lie in a course, and marks of parts asked no longer."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

import msgspec
from msgspec import UNSET

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.atomic import write_whole
from corollary.grading.part_grades import Grade, PartGrade
from corollary.messages import few, visible
from corollary.problem.late_penalty import IN_TIME, Delay
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assignments import AssignedSheet
from corollary.records.deadlines import Terms
from corollary.records.files import BESIDE, Course
from corollary.records.marks import PartRecord, read_record
from corollary.records.notebook_archive import read_hand_in
from corollary.sandbox.file import Unreadable, bytes_of

if TYPE_CHECKING:
    from corollary.grading.submission import Submission

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


def numbers_of(arrivals: Sequence[Arrival]) -> dict[str, str]:
    """The numbers by which an LMS knows the students, as "moodle 17", with the id of each."""
    return {each.number: each.student for each in arrivals if each.number and each.student}


def stamp(when: datetime) -> str:
    """A moment as nbgrader writes it into timestamp.txt."""
    return f"{when.astimezone(UTC):%Y-%m-%d %H:%M:%S.%f} UTC"


STAMP = "timestamp.txt"


class GuessedTime(msgspec.Struct, frozen=True, omit_defaults=True):
    """A moment that nobody said. `found` is what stood in timestamp.txt (empty: nothing that could be read), `aside` the file below
    `.corollary/times` that has it now (empty: there was none); `after_due`: the notebook itself is from after the deadline."""

    moment: datetime
    found: str = ""
    aside: str = ""
    after_due: bool = False


def lateness(course: Course, problem_set: ProblemSet, student: str, terms: Terms) -> Delay:
    """The delay after the student's own deadline by timestamp.txt; none for who is excused, and where the time is a guess."""
    when = stated(course, problem_set.name, student)
    if when is None or terms.due is None or terms.excused or guessed_time(course, problem_set.name, student):
        return IN_TIME
    return problem_set.delay(terms.due, when)


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


def own_folder(course: Course, set_name: str, student: str) -> Path | None:
    """Where a student's hand-in lies; None where that is a link, or lies behind one, and leads into another student's."""
    place = course.place("submitted", student, set_name)
    return place if place.resolve() == (course.folder / "submitted").resolve() / student / set_name else None


def settle_time(course: Course, set_name: str, student: str, terms: Terms) -> None:
    """Where timestamp.txt says no time: records a guess, sets what stood there aside, and writes the guess for nbgrader.

    Nothing is overwritten that could not be set aside. Whoever calls it is the only writer in the course. Raises OSError when
    the record cannot be written.
    """
    place, age = own_folder(course, set_name, student), handed_in(course, set_name, student)
    if age is None or place is None or stated(course, set_name, student) is not None:
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
            f"held no time but {guess.found[:60]!r}"
            if guess.found
            else "was empty, too large, a link, or no file"
        )
        where = f" (kept as .corollary/times/{set_name}/{guess.aside})" if guess.aside else ""
        return f"{STAMP} {what}{where}: counted as in time; {remedy}"
    if guess.after_due:
        return (
            f"no time of handing in, and the file's date is after the deadline: counted as in time; {remedy}"
        )
    return ""


def all_guessed(set_name: str, guesses: Mapping[str, GuessedTime]) -> Iterator[str]:
    """A line on each guess that matters, with whose it is; one for all of whom there is the same to say."""
    alike: dict[str, list[str]] = {}
    for student, guess in guesses.items():
        alike.setdefault(why_guessed(set_name, "STUDENT", guess), []).append(student)
    for sentence, who in alike.items():
        if sentence:
            one = sentence if len(who) > 1 else why_guessed(set_name, who[0], guesses[who[0]])
            yield f"{few(who, 10)}: {one}"


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


def _age(path: Path) -> datetime | None:
    """When it was last written, to the second; of a link itself, and not of what it leads to."""
    try:
        return datetime.fromtimestamp(int(path.lstat().st_mtime), UTC)
    except (OSError, ValueError, OverflowError):
        return None


def _record(course: Course, set_name: str, student: str) -> Path:
    return course.record("times", f"{set_name}/{student}.json")


def submissions(course: Course, set_name: str) -> dict[str, Path]:
    """The notebook each student handed in, by student."""
    return {
        place.name: path
        for place in _places(course)
        if (path := handed_in_notebook(place / set_name, set_name)) is not None
    }


def unclear(course: Course, set_name: str) -> dict[str, tuple[str, ...]]:
    """Who handed in several notebooks, none of the set's name, or files of which none is a notebook, and what these are called:
    nobody can guess which counts, or mark a picture of one."""
    found: dict[str, tuple[str, ...]] = {}
    for place in _places(course):
        names = tuple(notebook_names(place / set_name))
        if not names:
            names = tuple(name for name in file_names(place / set_name) if name not in BESIDE)
        one_notebook = len(names) == 1 and Path(names[0]).suffix == ".ipynb"
        if names and f"{set_name}.ipynb" not in names and not one_notebook:
            found[place.name] = names
    return found


def why_unclear(set_name: str, names: Sequence[str]) -> str:
    """A sentence on what `unclear` found of one student, and what to do."""
    listed = visible(", ".join(names))
    if names[0].endswith(".ipynb"):
        return f"{len(names)} notebooks, none called {set_name}.ipynb ({listed}); rename the one that counts"
    what = "a file that is not a notebook" if len(names) == 1 else "no notebook among the files"
    return f"{what} ({listed}); ask for {set_name}.ipynb"


def _places(course: Course) -> list[Path]:
    """The students' folders, and whatever stands in the place of one: a link, or a folder that is closed."""
    try:
        return sorted(
            place for place in (course.folder / "submitted").iterdir() if place.is_symlink() or place.is_dir()
        )
    except FileNotFoundError:
        return []


def read_submission(
    course: Course,
    problem_set: ProblemSet,
    student: Student,
    path: Path,
    assigned: AssignedSheet,
    fingerprint: str,
    terms: Terms,
) -> Submission:
    """The submission in a file, read as a stranger's file is; never raises for what is in it."""
    from corollary.grading.submission import (
        Submission,  # with all that marks: who reads a report needs none of it
    )

    late = lateness(course, problem_set, student.id, terms)
    content = read_hand_in(course, path)
    return Submission(
        student,
        content,
        assigned.variants,
        late,
        fingerprint,
        terms.reveal,
        terms.due,
        retained(course, problem_set, student.id, assigned),
        rubric=terms.rubric,
    )


def fingerprint(
    course: Course,
    set_name: str,
    student: str,
    path: Path,
    assigned: AssignedSheet,
    state: str,
    terms: Terms,
) -> str:
    """What the marks and the page depend on: the file, its moment, the numbers, the terms, and the `state` of everything else."""
    digest = hashlib.sha256()
    content = read_hand_in(course, path)
    for each in (
        content if isinstance(content, bytes) else content.in_english.encode(),
        str(handed_in(course, set_name, student)).encode(),
        assigned.identity.encode(),
        repr((terms.due and terms.due.isoformat(), terms.excused, terms.reveal)).encode()
        + (b" rubric" if terms.rubric else b""),
        state.encode(),
    ):
        digest.update(len(each).to_bytes(8, "big") + each)
    return digest.hexdigest()


def retained(
    course: Course, problem_set: ProblemSet, student: str, sheet: AssignedSheet
) -> tuple[Grade, ...]:
    """What the newest record has of the parts that are gone, by problem; nothing for parts that were never marked."""
    record = read_record(course, problem_set, student) if sheet.removed else None
    if record is None:
        return ()
    reasons = {(row.problem, row.part): row.why for row in record.rows}
    found: list[Grade] = []
    for variant in sheet.removed:
        problem = variant.problem
        parts = tuple(
            PartGrade(
                part,
                verdict_of(marked, reasons.get((problem.code, part.id), "")),
                marked.points,
                marked.out_of,
                marked.answer,
                marked.feedback,
                () if marked.basis is UNSET else marked.basis,
            )
            for part in problem.parts
            if (marked := record.parts.get(problem.answer_name(part))) is not None
        )
        if parts:
            found.append(Grade(variant, parts))
    return tuple(found)


def verdict_of(part: PartRecord, why: str) -> Verdict:
    """The verdict as it was recorded."""
    match part.verdict:
        case "right":
            return Right(why)
        case "follows":
            return Follows(tuple(why.removeprefix("from ").split(", ")))
        case "mistaken":
            earlier = tuple(why.removeprefix("from ").split(", ")) if why else ()
            return Mistaken("" if part.mistake is UNSET else part.mistake, earlier)
        case "slip":
            return Slip("" if part.slip is UNSET else part.slip)
        case "wrong":
            return Wrong(why)
        case "unread":
            return Unread(why)
        case _:
            return Unmarked(why, () if part.rubric is UNSET else part.rubric)


def read_failures(course: Course, set_name: str) -> dict[str, str]:
    """What failed, in a few words, by student; nothing where nothing did."""
    try:
        found = course.record("failures", f"{set_name}.json").read_bytes()
        return msgspec.json.decode(found, type=dict[str, str])
    except (OSError, msgspec.DecodeError):  # none, or damaged: found again when it is marked again
        return {}


def write_failures(course: Course, set_name: str, found: Mapping[str, str], stay: Collection[str]) -> None:
    """Records what failed now; of what failed before, that of who was not marked again stays."""
    before = read_failures(course, set_name)
    now = {student: what for student, what in before.items() if student in stay} | dict(found)
    if now != before:
        text = msgspec.json.encode(
            {student: what.encode("utf-8", "replace").decode() for student, what in now.items()}
        )
        write_whole(course.record("failures", f"{set_name}.json"), text)
