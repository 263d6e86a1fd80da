"""What was handed in, marked: run, judged, recorded, with feedback for each student; what is unchanged is left alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from corollary.deliver.course import Course, read_dealt, students, submissions, write_atomically
from corollary.deliver.generating import variants_of
from corollary.deliver.keeping import fingerprint, keep, lateness, read_record
from corollary.deliver.nbgrader_book import NoNbgrader, need_nbgrader
from corollary.deliver.report import report
from corollary.deliver.report_page import report_page
from corollary.deliver.tally import HandedIn, Report, Row
from corollary.mark.grade import Marked
from corollary.mark.marking import mark
from corollary.mark.solutions import Solutions
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.sheet.sheet import sheet
from corollary.submission.notebook import Notebook, content_of, read_notebook
from corollary.submission.take import Runner


class NotDealt(LookupError):
    """The set was never generated for this course; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run of grading did. `records` holds every student's marks, those skipped included."""

    graded: tuple[str, ...]
    skipped: tuple[str, ...]
    failed: tuple[str, ...]
    strangers: tuple[str, ...]
    records: dict[str, dict[str, Any]]
    in_gradebook: bool
    report: Report
    page: Path


def grade_set(
    course: Course, problem_set: ProblemSet, solutions: Solutions, runner: Callable[[], Runner], *,
    regrade: bool = False, tell: Callable[[str, int], None] = lambda student, left: None,
) -> Outcome:  # fmt: skip
    """Marks every submission that is new or changed. Killed at any moment, the next run finishes the rest.

    Raises NotDealt, and what the gradebook refuses (GradebookLocked, NotRegistered).
    """
    dealt = read_dealt(course, problem_set.name)
    if not dealt:
        raise NotDealt(f"{problem_set.name} was never generated in {course.folder}; run corollary generate {problem_set.name} first")
    roster = {student.id: student for student in students(course)}
    papers = submissions(course, problem_set.name)
    strangers = tuple(student for student in papers if student not in roster or student not in dealt)
    todo, skipped = [], []
    for student, path in papers.items():
        if student in strangers:
            continue
        mark_of = fingerprint(course, problem_set, solutions, student, path, dealt[student])
        if not regrade and (kept := read_record(course, problem_set, student)) is not None and kept.get("fingerprint") == mark_of:
            skipped.append(student)
        else:
            todo.append((roster[student], path, mark_of))
    if todo:
        with runner() as running:
            for place, (student, path, mark_of) in enumerate(todo):
                tell(student.id, len(todo) - place)
                _grade_one(course, problem_set, solutions, running, student, path, mark_of, dealt[student.id])
    records = {student: kept for student in papers if (kept := read_record(course, problem_set, student)) is not None}
    found = report_of(course, problem_set)
    page = course.folder / "reports" / f"{problem_set.name}.html"
    write_atomically(page, report_page(found, problem_set))
    failed = tuple(one.student for one in found.failed)
    return Outcome(tuple(student.id for student, _, _ in todo), tuple(skipped), failed, strangers, records, has_nbgrader(), found, page)


def _grade_one(
    course: Course, problem_set: ProblemSet, solutions: Solutions, runner: Runner, student: Student, path: Path, mark_of: str, row: dict[str, int]
) -> Marked:
    """One submission from file to gradebook; its record is written last, so that a run cut short does it again."""
    variants = variants_of(problem_set, row)
    paper = sheet(problem_set, student, variants)
    keys = {variant.problem.code: solutions.key(variant) for variant in variants}
    read = read_notebook(path)
    marked = mark(paper, keys, read, runner, course.key, lateness(course, problem_set, student.id))
    if has_nbgrader():
        from corollary.deliver.nbgrader import record

        record(course, problem_set, [marked], {student.id: read.node if isinstance(read, Notebook) else None})
    keep(course, problem_set, solutions, marked, mark_of)
    return marked


def report_of(course: Course, problem_set: ProblemSet) -> Report:
    """The report from the records kept beside the course."""
    order = [(problem.code, part.id) for problem in problem_set.problems for part in problem.parts]
    roster = [student.id for student in students(course)]
    kept = [entry for student in roster if (entry := read_record(course, problem_set, student)) is not None]
    all_rows = [Row(**each) for entry in kept for each in entry["rows"]]
    all_rows.sort(key=lambda each: order.index((each.problem, each.part)) if (each.problem, each.part) in order else len(order))
    return report([HandedIn(**entry["handed_in"]) for entry in kept], all_rows, roster=roster)


def has_nbgrader() -> bool:
    try:
        need_nbgrader()
    except NoNbgrader:
        return False
    return True
