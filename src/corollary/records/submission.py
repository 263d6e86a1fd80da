"""What was handed in: whose notebooks lie in a course folder, since when, and what their marks depend on."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from corollary.grading.submission import Submission
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.files import Course
from corollary.sandbox.file import bytes_of, content_of


def submissions(course: Course, set_name: str) -> dict[str, Path]:
    """The notebook each student handed in, by student."""
    places = sorted((course.folder / "submitted").glob("*/"))
    return {
        place.name: path
        for place in places
        if (path := _handed_in_notebook(place / set_name, set_name)) is not None
    }


def unclear(course: Course, set_name: str) -> dict[str, tuple[str, ...]]:
    """Who handed in several notebooks, none of the set's name, and what they are called: nobody can guess which counts."""
    found: dict[str, tuple[str, ...]] = {}
    for place in sorted((course.folder / "submitted").glob(f"*/{set_name}/")):
        names = tuple(sorted(path.name for path in place.glob("*.ipynb") if path.is_file()))
        if len(names) > 1 and f"{set_name}.ipynb" not in names:
            found[place.parent.name] = names
    return found


def read_submission(
    course: Course,
    problem_set: ProblemSet,
    student: Student,
    path: Path,
    assigned: Mapping[str, int],
    fingerprint: str,
) -> Submission:
    """The submission in a file, read as a stranger's file is; never raises for what is in it."""
    late = lateness(course, problem_set, student.id)
    content = bytes_of(path, within=course.folder / "submitted")
    return Submission(student, content, assigned, late, fingerprint)


def fingerprint(
    course: Course, set_name: str, student: str, path: Path, assigned: Mapping[str, int], state: str
) -> str:
    """What the marks depend on: the file, its moment, the numbers, and the `state` of everything else."""
    digest = hashlib.sha256()
    for content in (
        content_of(path),
        str(handed_in(course, set_name, student)).encode(),
        json.dumps(dict(assigned), sort_keys=True).encode(),
        state.encode(),
    ):
        digest.update(len(content).to_bytes(8, "big") + content)
    return digest.hexdigest()


def lateness(course: Course, problem_set: ProblemSet, student: str) -> float:
    """Seconds after the date on which it was due; 0 in time."""
    when = handed_in(course, problem_set.name, student)
    if when is None or problem_set.due is None:
        return 0.0
    return max(0.0, (when - problem_set.due).total_seconds())


def handed_in(course: Course, set_name: str, student: str) -> datetime | None:
    """When a student handed in: what timestamp.txt says (as nbgrader writes it: 2026-12-04 21:03:11.5 UTC), else the age of
    the file, to the second; None when there is nothing."""
    place = course.place("submitted", student, set_name)
    try:
        # A stranger's file like the notebook beside it: it may be a pipe, a link to a device, or forty gigabytes.
        content = bytes_of(place / "timestamp.txt", 1 << 10)
        return moment(content.decode("utf-8", "replace") if isinstance(content, bytes) else "")
    except (OSError, ValueError, OverflowError, ZoneInfoNotFoundError):
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


def _handed_in_notebook(place: Path, set_name: str) -> Path | None:
    """The notebook of the set's name; when it was renamed on its way, the only one in the folder."""
    expected = place / f"{set_name}.ipynb"
    if expected.is_file():
        return expected
    others = [path for path in place.glob("*.ipynb") if path.is_file()]
    return others[0] if len(others) == 1 else None
