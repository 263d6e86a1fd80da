"""A problem set made for a roster: variants assigned, one notebook for each student, and the set registered with nbgrader."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeVar

from corollary.atomic import write_whole
from corollary.course.renew import Renewal, check_folders
from corollary.grading.solutions import Solutions
from corollary.messages import speak, spoken
from corollary.nbgrader.gradebook import NoNbgrader, need_nbgrader
from corollary.nbgrader.register import source_notebook
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.parallel import ProcessDied, Workers, cores
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, at, chapter, index_of
from corollary.records.assignments import (
    Assigned,
    AssignedSheet,
    as_printed,
    held_codes,
    numbers_of,
    open_record,
    printed_date,
    save_record,
    sheets,
)
from corollary.records.editions import values_now
from corollary.records.files import Course, create_course, one_writer
from corollary.records.notebook_archive import drop_sheet, has_sheet
from corollary.records.origin import write_origin
from corollary.records.settings import write_settings

if TYPE_CHECKING:
    from nbformat import NotebookNode

T = TypeVar("T")
R = TypeVar("R")
AT_ONCE = 8  # students that a process is given at a time
WORTH_A_POOL = 24  # fewer are done sooner than processes start


@dataclass(frozen=True, slots=True)
class Drawn:
    """A student's first admissible draw of each of their problems, in their order: its place in the grid (None: the chapter's
    numbers, there are no others), and how many draws were rejected before it."""

    student: str
    draws: tuple[tuple[int | None, int], ...]


@dataclass(frozen=True, slots=True)
class ToWrite:
    """A student and the numbers of today's problems, by code: values in the givens' units, and the place in the grid."""

    student: Student
    numbers: Mapping[str, tuple[Mapping[str, Fraction], int | None]]


@dataclass(slots=True)
class Makers:
    """What draws and writes; without a pool, in this process."""

    course: Course
    problem_set: ProblemSet
    solutions: Solutions
    dealt: Mapping[str, tuple[Problem, ...]]
    pool: Workers | None = field(default=None)

    def draw(self, students: Sequence[str]) -> Iterator[Drawn]:
        """In the order of the students. Raises NoVariant."""
        return self._each(_draw, students)

    def write(self, sheets: Sequence[ToWrite]) -> Iterator[str]:
        """Gives each student's id when the notebook is there; other processes begin at once."""
        return self._each(_write, sheets)

    def _each(self, work: Callable[[Makers, Sequence[T]], list[R]], todo: Sequence[T]) -> Iterator[R]:
        parts = [todo[at : at + AT_ONCE] for at in range(0, len(todo), AT_ONCE)]
        futures = [self._begin(work, part) for part in parts]
        return self._results(work, zip(parts, futures, strict=True))

    def _begin(
        self, work: Callable[[Makers, Sequence[T]], list[R]], part: Sequence[T]
    ) -> Future[list[R]] | None:
        return None if self.pool is None else self.pool.submit(_in_worker, work, part)

    def _results(
        self,
        work: Callable[[Makers, Sequence[T]], list[R]],
        begun: Iterable[tuple[Sequence[T], Future[list[R]] | None]],
    ) -> Iterator[R]:
        for part, future in begun:
            try:
                yield from work(self, part) if future is None else future.result()
            except ProcessDied:  # a process was killed: what it was at is done here
                yield from work(self, part)


@contextmanager
def makers(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    count: int,
    jobs: int | None = None,
    dealt: Mapping[str, tuple[Problem, ...]] = MappingProxyType({}),
) -> Generator[Makers]:
    """For so many students, in at most so many processes (None: one for each core). `dealt`: the problems of those to draw for."""
    most = min(jobs or cores(), -(-count // AT_ONCE))
    here = Makers(course, problem_set, solutions, dict(dealt))
    if most < 2 or (jobs is None and count < WORTH_A_POOL):
        yield here
        return
    for problem in problem_set.problems:
        solutions.of(problem)  # once, before there are processes that would each do it
    with Workers(most, _start, here, spoken()) as here.pool:
        yield here


_at_work: list[Makers] = []  # of a worker process


def _start(context: Makers, language: str) -> None:
    speak(language)
    _at_work.append(Makers(context.course, context.problem_set, context.solutions, context.dealt))


def _in_worker(work: Callable[[Makers, Sequence[T]], list[R]], part: Sequence[T]) -> list[R]:
    return work(_at_work[0], part)


def _draw(by: Makers, students: Sequence[str]) -> list[Drawn]:
    return [
        Drawn(
            student,
            tuple(
                (found.variant.index, found.redrawn)
                for problem in by.dealt[student]
                for found in [by.solutions.assign_variant(problem, by.course.key, student, ())]
            ),
        )
        for student in students
    ]


def _write(by: Makers, sheets: Sequence[ToWrite]) -> list[str]:
    todays = {problem.code: problem for problem in by.problem_set.problems}
    for each in sheets:
        variants = [Variant(todays[code], *numbers) for code, numbers in each.numbers.items()]
        path = by.course.notebook("release", each.student.id, by.problem_set.name)
        write_whole(path, file_text(notebook(worksheet(by.problem_set, each.student, variants))))
    return [each.student.id for each in sheets]


@dataclass(frozen=True, slots=True)
class Generated:
    """What was made: where each student's notebook lies, what everybody on the roster has been given, how many draws were
    rejected for each problem, and whether nbgrader knows of the set. `new` are those who were given theirs by this run."""

    course: Course
    notebooks: dict[str, Path]
    assigned: dict[str, AssignedSheet]
    redrawn: dict[str, int]
    registered: bool
    new: tuple[str, ...] = ()

    @property
    def shared(self) -> dict[str, int]:
        """How many students have numbers that somebody else has too, by code of the problem; only where there are any."""
        variants = [each for sheet in self.assigned.values() for each in sheet.variants]
        held = Counter((each.problem.code, tuple(each.exact.items())) for each in variants)
        found = Counter[str]()
        for (code, _), count in held.items():
            found[code] += count if count > 1 else 0
        return {code: count for code, count in found.items() if count}


def generate(
    folder: Path,
    problem_set: ProblemSet,
    roster: Iterable[Student],
    solutions: Solutions,
    progress: Callable[[str], None] = lambda step: None,
    renewed: Sequence[Renewal] = (),
    jobs: int | None = None,
) -> Generated:
    """Makes or completes the course; who has a sheet keeps it, as it is, but for the `renewed`.
    `jobs`: how many processes (None: one for each core).

    Raises NoVariant, NotRegistered, GradebookLocked, NotOurs, NotSettled, BeingGraded, OneFolder.
    """
    roster = tuple(roster)
    check_folders(roster, problem_set.name)
    course = create_course(folder, roster)
    write_settings(course.folder)
    with one_writer(course):
        record = open_record(course, problem_set)
        new = tuple(student.id for student in roster if student.id not in record.students)
        for problem in problem_set.problems:  # in this order, by which the renewed name them
            record.place(problem, problem_set.weight(problem))
        for each in renewed:
            record.students[each.student] = each.row
            # Gone before the record says otherwise: cut short here, the next run writes what the record says.
            drop_sheet(course, problem_set.name, each.student)
        dealt = problem_set.deal(course.key, new, held_codes(record))
        with makers(course, problem_set, solutions, len(new) + len(renewed), jobs, dealt) as by:
            drawing = by.draw(
                new
            )  # other processes begin at once; meanwhile nbgrader, which waits for the disk, is told
            registered = _register(course, problem_set, source_notebook(problem_set), progress)
            redrawn = _deal(by, record, drawing, progress)
            notebooks = {
                student.id: course.notebook("release", student.id, problem_set.name) for student in roster
            }
            todays = {*new, *(each.student for each in renewed)}
            record.dates |= {
                student: printed_date(problem_set.due)
                for student in notebooks
                if student in todays
                or (student not in record.dates and not has_sheet(course, problem_set.name, student))
            }
            write_origin(course, problem_set.name, solutions.bank, problem_set.file)
            save_record(course, problem_set, record)
            assigned = sheets(course, problem_set, record)
            # What was handed out stays as it is, to the byte.
            missing = [
                each
                for each in roster
                if each.id in todays or not has_sheet(course, problem_set.name, each.id)
            ]
            for student in by.write(
                [_to_write(each, assigned[each.id]) for each in missing if each.id in todays]
            ):
                progress(f"notebook of {student}")
        for student in missing:
            if student.id not in todays:
                own = as_printed(problem_set, record, student.id)
                sheet = worksheet(own, student, assigned[student.id].variants)
                write_whole(notebooks[student.id], file_text(notebook(sheet)))
    of_roster = {student.id: assigned[student.id] for student in roster}
    return Generated(course, notebooks, of_roster, redrawn, registered, new)


def _deal(
    by: Makers, record: Assigned, drawing: Iterable[Drawn], progress: Callable[[str], None]
) -> dict[str, int]:
    """What was drawn, into the record, or the next that nobody has; how many draws were rejected, by code. Raises NoVariant."""
    problem_set, redrawn = by.problem_set, dict[str, int]()
    used = {problem.code: set(_in_use(record, problem)) for problem in problem_set.problems}
    places = {each.code: record.place(each, problem_set.weight(each)) for each in problem_set.problems}
    for drawn in drawing:
        progress(f"numbers of {drawn.student}")
        row = record.students.setdefault(drawn.student, {})
        for problem, (index, rejected) in zip(by.dealt[drawn.student], drawn.draws, strict=True):
            in_use = used[problem.code]
            if index in in_use:  # somebody has it: the next draw that is free
                found = by.solutions.assign_variant(problem, by.course.key, drawn.student, in_use)
                variant, rejected = found.variant, found.redrawn
            else:
                variant = chapter(problem) if index is None else at(problem, index)
            row[problem.code] = numbers_of(variant, places[problem.code])
            redrawn[problem.code] = redrawn.get(problem.code, 0) + rejected
            in_use |= set() if variant.index is None else {variant.index}
    return redrawn


def _to_write(student: Student, sheet: AssignedSheet) -> ToWrite:
    return ToWrite(student, {each.problem.code: (each.values, each.index) for each in sheet.variants})


def _in_use(record: Assigned, problem: Problem) -> Iterator[int]:
    """The places in today's grid of the numbers that somebody has; they may have been drawn from another."""
    for row in record.students.values():
        for numbers in row.values():
            edition = record.edition(numbers)
            if edition.code_now == problem.code:
                values = values_now(problem, edition, numbers.exact)
                if (place := index_of(problem, values)) is not None:
                    yield place


def _register(
    course: Course, problem_set: ProblemSet, source: NotebookNode, progress: Callable[[str], None]
) -> bool:
    """Makes the set known to nbgrader, where it is installed; source and release are written in any case."""
    try:
        need_nbgrader()
    except NoNbgrader:
        for step in ("source", "release"):
            write_whole(course.notebook(step, ".", problem_set.name), file_text(source))
        return False
    from corollary.nbgrader.register import register

    progress("registering with nbgrader")
    register(course, problem_set, source)
    return True
