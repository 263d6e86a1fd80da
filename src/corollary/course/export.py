"""A problem set, its marks and its feedback as files for elsewhere: sheets of each student, print runs, tables, archives."""

from __future__ import annotations

import string
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import Literal, TypeVar

from corollary.course.lms_places import NoPlaces, packed, places
from corollary.course.up_to_date import up_to_date
from corollary.grading.solutions import Solutions
from corollary.messages import speak, spoken
from corollary.nbgrader.written_marks import stored_facts
from corollary.notebook.worksheet import SheetPlan, Worksheet
from corollary.parallel import ProcessDied, Workers, cores
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, chapter
from corollary.records.assignments import as_printed, open_record, read_assigned, sheets
from corollary.records.deadlines import read_deadlines
from corollary.records.editions import NotSettled
from corollary.records.files import Course, students
from corollary.records.lms_file import FilledIn, fill_in
from corollary.records.lms_names import LmsName
from corollary.records.manual_marks import read_manual
from corollary.records.marks import feedback_place, stored_record, with_manual
from corollary.records.marks_table import (
    Column,
    MarksTable,
    Notation,
    every_column,
    part_columns,
    set_column,
)
from corollary.render.exports import MarksText, Target
from corollary.render.feedback_page import feedback_notebook
from corollary.render.paper.print_run import Pages, PrintRun

NOBODY = Student("")
PRACTICE = "practice.html"


def sheets_of_course(course: Course, problem_set: ProblemSet) -> list[SheetPlan]:
    """The sheets as they were handed out; empty when the set was never generated. Raises NotACourse."""
    record = open_record(course, problem_set)
    assigned = sheets(course, problem_set, record)
    return [
        SheetPlan(as_printed(problem_set, record, student.id), student, tuple(assigned[student.id].variants))
        for student in students(course)
        if student.id in assigned
    ]


def sheets_for(problem_set: ProblemSet, solutions: Solutions, owners: Sequence[Student]) -> list[SheetPlan]:
    """Sheets without a course: distinct numbers that follow from the owners' ids alone, the same each time.

    Raises NotDerivable and NoVariant.
    """
    assigned: dict[str, list[Variant]] = {owner.id: [] for owner in owners}
    used: dict[str, set[int]] = {problem.code: set() for problem in problem_set.problems}
    dealt = problem_set.deal(b"", assigned)
    for owner in owners:
        for problem in dealt[owner.id]:
            variant = solutions.assign_variant(problem, b"", owner.id, used[problem.code]).variant
            used[problem.code] |= set() if variant.index is None else {variant.index}
            assigned[owner.id].append(replace(variant, problem=problem))
    return [SheetPlan(problem_set, owner, tuple(assigned[owner.id])) for owner in owners]


def chapters_sheet(problem_set: ProblemSet) -> SheetPlan:
    """The sheet with the chapter's own numbers, which is nobody's."""
    return SheetPlan(problem_set, NOBODY, tuple(map(chapter, problem_set.problems)))


def sheet_files(
    target: Target, problem_set: ProblemSet, sheets: Sequence[Worksheet], solutions: Solutions | None
) -> dict[str, bytes]:
    """The files that a target for worksheets or for whole sets makes, by name; `solutions` adds the worked ones."""
    if target.problem_set is not None:
        return dict(target.problem_set(problem_set, sheets))
    if target.worksheet is None:
        raise TypeError("this target takes neither worksheets nor whole sets")
    files: dict[str, bytes] = {}
    for sheet in sheets:
        worked = {} if solutions is None else _worked(solutions, sheet)
        owner = f"-{sheet.student.id}" if sheet.student.id else ""
        name = f"{problem_set.name}{owner}.{target.ending}"
        files[name] = target.worksheet(sheet, worked).encode("utf-8", "replace")
    return files


def _worked(solutions: Solutions, sheet: Worksheet) -> dict[str, str]:
    return {each.problem.code: solutions.worked_solution(each.variant) for each in sheet.exercises}


def owners(count: int) -> Iterable[Student]:
    """Whoever is to get one of so many variants."""
    return (Student(str(number), "Variant", str(number)) for number in range(1, count + 1))


By = Literal["sets", "parts", "every"]


@dataclass(frozen=True, slots=True)
class Template:
    """A file that the LMS exported, and the headings of the columns to fill in where their titles do not say."""

    path: Path
    headings: Sequence[str] = ()


def marks_table(course: Course, sets: Sequence[ProblemSet], by: By, notation: Notation) -> MarksTable:
    """The marks as they stand, for everybody on the roster; excused students have none. Raises NothingGraded and NotACourse."""
    roster = students(course)
    columns: list[Column] = []
    for problem_set in sets:
        report = up_to_date(course, problem_set)
        deadlines = read_deadlines(course, problem_set)
        excused = {each.id for each in roster if deadlines.excused(each.id)}
        if by == "sets":
            columns.append(set_column(problem_set, report, excused))
        elif by == "parts":
            columns += part_columns(problem_set, report, excused)
        else:
            columns += every_column(problem_set, report, roster, excused, _out_of(course, problem_set))
    return MarksTable(roster, tuple(columns), notation)


def _out_of(course: Course, problem_set: ProblemSet) -> dict[str, float]:
    """What each student's own sheet is out of; nothing while a name is to be settled."""
    try:
        sheets = read_assigned(course, problem_set)
    except NotSettled:
        return {}
    return {
        student: sum(
            part.points * problem_set.weight(variant.problem)
            for variant in sheet.variants
            for part in variant.problem.parts
        )
        for student, sheet in sheets.items()
    }


def marks_file(target: Target, table: MarksTable, template: Template | None) -> FilledIn:
    """The file's content, with what is to be said of it. Raises Malformed for a template that cannot be filled in."""
    if template is not None:
        return fill_in(template.path, table, template.headings)
    if target.marks is None:
        raise TypeError("this target takes no marks")
    made = target.marks(table)
    if isinstance(made, str):
        made = MarksText(made)
    return FilledIn(made.text.encode(), (), made.absent, made.notes)


@dataclass(frozen=True, slots=True)
class FeedbackFiles:
    """The pages by their names in the archive that `lms` ("moodle" or "canvas") takes back, and whose have no place in it."""

    lms: str
    files: Mapping[str, bytes]
    without: tuple[str, ...]


def feedback_files(
    course: Course, problem_set: ProblemSet, ids: Path | None = None, practice: Path | None = None
) -> FeedbackFiles:
    """The pages with what persons gave up to now, for the LMS that `ids`, or else what was collected, comes from. `practice` is a
    folder of practice sheets, which lie beside the pages.

    Raises NoPlaces, NotACourse and Malformed.
    """
    up_to_date(course, problem_set)
    name, roster = problem_set.name, students(course)
    pages: dict[str, tuple[str, bytes]] = {}
    for student in roster:
        path = feedback_place(course, name, student.id)
        if path.is_file():
            pages[student.id] = (f"{name}-feedback.html", path.read_bytes())
    if not pages:
        raise NoPlaces(
            f"nobody has a feedback page of {name} in {course.folder}: nothing was handed in when it was graded"
        )
    try:
        lms, found = "moodle", places(course, name, roster, "moodle", ids)
    except NoPlaces as error:
        try:
            lms, found = "canvas", places(course, name, roster, "canvas", ids)
        except NoPlaces:
            raise error from None
    if lms == "canvas":
        pages |= _as_handed_in(course, name, found, pages)
    files = packed(lms, found, pages, roster)
    if practice is not None:
        if lms == "canvas":
            raise NoPlaces(
                "Canvas gives back one file for each hand-in; give the practice sheets back by Moodle or by mail"
            )
        sheets = {each.id: practice / each.id / PRACTICE for each in roster}
        pages_to_practise = {
            student: (PRACTICE, path.read_bytes()) for student, path in sheets.items() if path.is_file()
        }
        files |= packed(lms, found, pages_to_practise, roster)
    return FeedbackFiles(lms, files, tuple(student for student in pages if student not in found))


def _as_handed_in(
    course: Course, set_name: str, found: Mapping[str, LmsName], pages: Iterable[str]
) -> Iterator[tuple[str, tuple[str, bytes]]]:
    """Notebooks for those who handed one in: Canvas gives a file back under the name of theirs (`display_name`), and a page
    that is called `week1.ipynb` opens nowhere."""
    manual = read_manual(course).by_student(set_name)
    for student in pages:
        record, facts = stored_record(course, set_name, student), stored_facts(course, set_name, student)
        if student in found and found[student].file.endswith(".ipynb") and record and facts:
            text = feedback_notebook(facts, with_manual(record, manual.get(student, {})))
            yield student, (f"{set_name}-feedback.ipynb", text.encode())


T = TypeVar("T")

WORTH_A_POOL = 8  # fewer are done sooner than processes start

_at_work: list[PrintRun] = []  # of a worker process


def form_owners(count: int) -> list[Student]:
    """Whoever gets one of so many forms: A to Z, then AA, AB, …"""
    letters = string.ascii_uppercase
    pairs = ("".join(pair) for pair in product(letters, repeat=2))
    return [Student(name) for name, _number in zip([*letters, *pairs], range(count), strict=False)]


def print_files(run: PrintRun, done: Callable[[str], None]) -> dict[str, bytes]:
    """Every file of a print run by its name; `done` is told the name of each sheet. Raises CannotTypeset, NotDerivable, Undefined."""
    run.prepare()
    if cores() < 2 or len(run.sheets) < WORTH_A_POOL:
        pages = [run.pages(sheet) for sheet in run.sheets]
        return _collected(run, map(run.printed, run.sheets, pages), done) | run.together(pages)
    with Workers(cores(), _start, run, spoken()) as pool:
        written = [pool.submit(_pages, at) for at in range(len(run.sheets))]
        pages = [
            _result(future, partial(run.pages, sheet))
            for future, sheet in zip(written, run.sheets, strict=True)
        ]
        together = pool.submit(_together, pages)  # the longest job is the first, so that none waits for it
        futures = [pool.submit(_printed, at, each) for at, each in enumerate(pages)]
        each = (
            _result(future, partial(run.printed, sheet, pages[at]))
            for at, (future, sheet) in enumerate(zip(futures, run.sheets, strict=True))
        )
        return _collected(run, each, done) | _result(together, partial(run.together, pages))


def _collected(
    run: PrintRun, printed: Iterable[dict[str, bytes]], done: Callable[[str], None]
) -> dict[str, bytes]:
    """In the order of the sheets."""
    files: dict[str, bytes] = {}
    for sheet, found in zip(run.sheets, printed, strict=True):
        files |= found
        done(sheet.mark)
    return files


def _result(future: Future[T], here: Callable[[], T]) -> T:
    try:
        return future.result()
    except ProcessDied:  # a process was killed: what it was at is done here
        return here()


def _start(run: PrintRun, language: str) -> None:
    speak(language)
    _at_work.append(run)


def _pages(at: int) -> Pages:
    run = _at_work[0]
    return run.pages(run.sheets[at])


def _printed(at: int, pages: Pages) -> dict[str, bytes]:
    run = _at_work[0]
    return run.printed(run.sheets[at], pages)


def _together(pages: Sequence[Pages]) -> dict[str, bytes]:
    return _at_work[0].together(pages)
