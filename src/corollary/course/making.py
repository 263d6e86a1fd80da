"""Numbers drawn and notebooks written on all cores of this machine; what comes out does not depend on how many there are."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeVar

from corollary.atomic import write_whole
from corollary.grading.solutions import Solutions
from corollary.messages import speak, spoken
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.parallel import ProcessDied, Workers, cores
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant
from corollary.records.files import Course

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
    course: Course, problem_set: ProblemSet, solutions: Solutions, count: int, jobs: int | None = None
) -> Generator[Makers]:
    """For so many students, in at most so many processes (None: one for each core)."""
    most = min(jobs or cores(), -(-count // AT_ONCE))
    here = Makers(course, problem_set, solutions)
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
    _at_work.append(Makers(context.course, context.problem_set, context.solutions))


def _in_worker(work: Callable[[Makers, Sequence[T]], list[R]], part: Sequence[T]) -> list[R]:
    return work(_at_work[0], part)


def _draw(by: Makers, students: Sequence[str]) -> list[Drawn]:
    return [
        Drawn(
            student,
            tuple(
                (found.variant.index, found.redrawn)
                for problem in by.problem_set.problems_of(by.course.key, student)
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
