"""A student's marks written wherever they stand: gradebook, record, history, feedback page."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Final

import msgspec
from msgspec.structs import replace

from corollary.atomic import write_each_whole, write_whole
from corollary.nbgrader.gradebook import gradebook, has_gradebook
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.records.manual_marks import (
    ManualMark,
    ManualMarks,
    OfStudent,
    Place,
    read_manual,
    write_manual,
)
from corollary.records.marks import (
    NewMarks,
    changed_by_points,
    feedback_place,
    page_facts_place,
    stored_record,
    with_manual,
    write_marks,
)

if TYPE_CHECKING:
    from nbgrader.api import Gradebook

    from corollary.nbgrader.graded import GradedSubmission
    from corollary.render.feedback_page import PageFacts

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


def current_manual(course: Course) -> ManualMarks:
    """What persons gave up to this moment, by the gradebook where there is one. Writes nothing."""
    journal = read_manual(course)
    if not has_gradebook(course) or is_as_seen(course, state(course, journal.count)):
        return journal
    from corollary.nbgrader.manual_grades import manual_marks

    with gradebook(course) as book:
        return manual_marks(course, book)


def synchronized(course: Course) -> ManualMarks:
    """The same, recorded; whoever calls it is the only writer in the course."""
    manual = read_manual(course)
    if not has_gradebook(course) or is_as_seen(course, state(course, manual.count)):
        return manual
    from corollary.nbgrader.manual_grades import synchronize

    for _ in range(2):  # what is written the first time is seen the second
        before = state(course, manual.count)
        with gradebook(course) as book:
            manual = synchronize(course, book)
        if before is not None and before == state(course, manual.count):
            note(course, before)
            break
    return manual


def write_graded(
    course: Course,
    problem_set: ProblemSet,
    several: Sequence[GradedSubmission],
    manual: Mapping[str, OfStudent],
    book: Gradebook | None,
    *,
    anew: bool = False,
) -> None:
    """Submissions into the gradebook (None: there is none), in one transaction, and the files; their records are written last,
    so that a run cut short does them again.

    `manual` is what persons gave, by student. `anew`: what lies in `autograded/` is no earlier marking."""
    name = problem_set.name
    _follow_points(course, name, several, manual)
    if book is None:
        write_each_whole(
            {course.notebook("autograded", one.marked.student.id, name): one.notebook for one in several}
        )
    else:
        from corollary.nbgrader.gradebook_record import record_several

        record_several(course, book, problem_set, several, manual, anew=anew)
    new = [
        NewMarks(student, one.record, one.facts, one.page_with(manual.get(student, {})))
        for one in several
        for student in (one.marked.student.id,)
    ]
    write_marks(course, problem_set, new)


def _follow_points(
    course: Course, set_name: str, several: Sequence[GradedSubmission], manual: Mapping[str, OfStudent]
) -> None:
    """What persons gave to those of them in whose work the points of a part changed, out of the points of now; into the journal
    before the gradebook, which lacks entries then if this is cut short, and is given them by the next run."""
    found: dict[Place, ManualMark] = {}
    for one in several:
        student = one.marked.student.id
        before = manual.get(student, {})
        moved = changed_by_points(before, one.record) if before else before
        found |= {Place(set_name, student, part): replace(mark, at="") for part, mark in moved.items()}
    if found:
        write_manual(course, found)


def stale_pages(
    course: Course, set_name: str, manual: ManualMarks, students: Iterable[str]
) -> dict[str, str]:
    """The pages of those to whom a person gave something since theirs was made, or whose was lost, as they are to be."""
    entries = manual.by_student(set_name)
    pages = {
        one: page_now(course, set_name, one, entries.get(one, {}))
        for one in students
        if one in entries or not feedback_place(course, set_name, one).exists()
    }
    return {
        one: page
        for one, page in pages.items()
        if page is not None and page.encode() != _written(course, set_name, one)
    }


def page_now(course: Course, set_name: str, student: str, manual: OfStudent) -> str | None:
    """The feedback page with the marks as they stand; None where what it is made of is lost."""
    record, facts = stored_record(course, set_name, student), stored_facts(course, set_name, student)
    if record is None or facts is None:
        return None
    from corollary.render.feedback_page import feedback_page  # with the templates

    return feedback_page(facts, with_manual(record, manual))


def stored_facts(course: Course, set_name: str, student: str) -> PageFacts | None:
    """What a page is made again from; None when there is nothing, or it is damaged."""
    from corollary.render.feedback_page import unpacked

    try:
        return unpacked(page_facts_place(course, set_name, student).read_bytes())
    except (OSError, msgspec.DecodeError):
        return None


def with_solutions(course: Course, set_name: str) -> tuple[str, ...]:
    """Those in whose feedback pages worked solutions stand."""
    pages = page_facts_place(course, set_name, "any").parent.glob("[!.]*.json")
    every = ((path.stem, stored_facts(course, set_name, path.stem)) for path in sorted(pages))
    return tuple(who for who, facts in every if facts and any(each.solution for each in facts.exercises))


def _written(course: Course, set_name: str, student: str) -> bytes:
    try:
        return feedback_place(course, set_name, student).read_bytes()
    except OSError:
        return b""
