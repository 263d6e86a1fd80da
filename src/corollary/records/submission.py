"""What was handed in: whose notebooks lie in a course folder, since when, and what their marks depend on."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from corollary.grading.submission import Submission
from corollary.messages import visible
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assigned import AssignedSheet
from corollary.records.deadlines import Terms
from corollary.records.files import Course
from corollary.records.retained import retained
from corollary.sandbox.file import bytes_of

# What nbgrader puts beside a notebook that was handed in.
BESIDE = {"timestamp.txt", "submission_secret.txt"}


def submissions(course: Course, set_name: str) -> dict[str, Path]:
    """The notebook each student handed in, by student."""
    return {
        place.name: path
        for place in _places(course)
        if (path := _handed_in_notebook(place / set_name, set_name)) is not None
    }


def unclear(course: Course, set_name: str) -> dict[str, tuple[str, ...]]:
    """Who handed in several notebooks, none of the set's name, or files of which none is a notebook, and what these are called:
    nobody can guess which counts, or mark a picture of one."""
    found: dict[str, tuple[str, ...]] = {}
    for place in _places(course):
        names = tuple(_notebooks(place / set_name))
        if not names:
            names = tuple(name for name in _files(place / set_name) if name not in BESIDE)
        one_notebook = len(names) == 1 and Path(names[0]).suffix == ".ipynb"
        if names and f"{set_name}.ipynb" not in names and not one_notebook:
            found[place.name] = names
    return found


def why_unclear(set_name: str, names: Sequence[str]) -> str:
    """A sentence on what `unclear` found of one student, and what to do."""
    listed = visible(", ".join(names))
    if names[0].endswith(".ipynb"):
        return f"{len(names)} notebooks, none of them called {set_name}.ipynb ({listed}); rename the one that counts"
    what = (
        "no notebook but a file that cannot be marked" if len(names) == 1 else "no notebook among the files"
    )
    return f"{what} ({listed}); ask for {set_name}.ipynb"


def _places(course: Course) -> list[Path]:
    """The students' folders, and whatever stands in the place of one: a link, or a folder that is closed."""
    try:
        return sorted(
            place for place in (course.folder / "submitted").iterdir() if place.is_symlink() or place.is_dir()
        )
    except FileNotFoundError:
        return []


def _notebooks(place: Path) -> list[str]:
    """The names of the notebooks in a folder; of none that is closed, or no folder."""
    return [name for name in _files(place) if Path(name).match("*.ipynb")]


def _files(place: Path) -> list[str]:
    try:
        return sorted(name for name in os.listdir(place) if not name.startswith("."))
    except OSError:
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
    late = lateness(course, problem_set, student.id, terms)
    content = bytes_of(path, within=course.folder / "submitted")
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
    content = bytes_of(path, within=course.folder / "submitted")
    for each in (
        content if isinstance(content, bytes) else content.why.encode(),
        str(handed_in(course, set_name, student)).encode(),
        assigned.identity.encode(),
        repr((terms.due and terms.due.isoformat(), terms.excused, terms.reveal)).encode()
        + (b" rubric" if terms.rubric else b""),
        state.encode(),
    ):
        digest.update(len(each).to_bytes(8, "big") + each)
    return digest.hexdigest()


def lateness(course: Course, problem_set: ProblemSet, student: str, terms: Terms) -> float:
    """Seconds after the student's own deadline; 0 in time, and for who is excused."""
    when = handed_in(course, problem_set.name, student)
    if when is None or terms.due is None or terms.excused:
        return 0.0
    return max(0.0, (when - terms.due.astimezone(UTC)).total_seconds())


def handed_in(course: Course, set_name: str, student: str) -> datetime | None:
    """When a student handed in: what timestamp.txt says (as nbgrader writes it: 2026-12-04 21:03:11.5 UTC), else the age of
    the file, to the second; None when there is nothing."""
    place = course.place("submitted", student, set_name)
    try:
        return moment(beside(course, set_name, student, "timestamp.txt").decode("utf-8", "replace"))
    except (OSError, ValueError, OverflowError, ZoneInfoNotFoundError):
        return _age(_handed_in_notebook(place, set_name) or place)


def beside(course: Course, set_name: str, student: str, file: str) -> bytes:
    """What is in a small file beside the notebook; nothing when there is none that can be read.

    It is a stranger's like the notebook: it may be a pipe, forty gigabytes, or a link to a device or to the course's key.
    """
    content = bytes_of(
        course.place("submitted", student, set_name) / file, 1 << 10, course.folder / "submitted"
    )
    return content if isinstance(content, bytes) else b""


def _age(path: Path) -> datetime | None:
    """When it was last written, to the second; of a link itself, and not of what it leads to."""
    try:
        return datetime.fromtimestamp(int(path.lstat().st_mtime), UTC)
    except (OSError, ValueError, OverflowError):
        return None


def moment(text: str) -> datetime:
    """The moment a timestamp.txt stands for; without a zone, UTC. Raises ValueError or ZoneInfoNotFoundError."""
    words = text[:80].split()
    if len(words) == 3 and words[2][:1].isalpha():
        zone = UTC if words[2] in {"UTC", "Z", "GMT"} else ZoneInfo(words[2])
        return datetime.fromisoformat(" ".join(words[:2])).replace(tzinfo=zone).astimezone(UTC)
    found = datetime.fromisoformat(" ".join(words[:2]) + "".join(words[2:]))
    return found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)


def _handed_in_notebook(place: Path, set_name: str) -> Path | None:
    """The notebook of the set's name; when it was renamed on its way, the only one in the folder.

    Whatever else stands in its place (a link that leads nowhere, a pipe, a folder) was handed in too, and so was what lies in
    a folder that cannot be looked into: reading it says what is wrong.
    """
    expected = place / f"{set_name}.ipynb"
    try:
        expected.lstat()
        return expected
    except (FileNotFoundError, NotADirectoryError):
        others = _notebooks(place)
        return place / others[0] if len(others) == 1 else None
    except OSError:
        return expected
