"""What was handed in: whose notebooks lie in a course folder, since when, and what their marks depend on."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.messages import visible
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assigned import AssignedSheet
from corollary.records.deadlines import Terms
from corollary.records.files import BESIDE, Course
from corollary.records.hand_in_time import file_names, handed_in, handed_in_notebook, lateness, notebook_names
from corollary.sandbox.file import bytes_of

if TYPE_CHECKING:
    from corollary.grading.submission import Submission


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
    from corollary.records.retained import retained

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
        content if isinstance(content, bytes) else content.in_english.encode(),
        str(handed_in(course, set_name, student)).encode(),
        assigned.identity.encode(),
        repr((terms.due and terms.due.isoformat(), terms.excused, terms.reveal)).encode()
        + (b" rubric" if terms.rubric else b""),
        state.encode(),
    ):
        digest.update(len(each).to_bytes(8, "big") + each)
    return digest.hexdigest()
