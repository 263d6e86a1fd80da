"""What the gradebook knows of a set: its parts, and what each is out of, which is one number for everybody."""

# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.
# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false, reportReturnType=false

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from corollary.problem.problem_set import ProblemSet
from corollary.records.marks import Record

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


def is_registered(book: Gradebook, problem_set: ProblemSet) -> bool:
    """Whether the gradebook has the set, with every part of it."""
    return _maxima_now(problem_set).keys() <= _maxima(book, problem_set).keys()


def may_follow_points(
    book: Gradebook, problem_set: ProblemSet, records: Callable[[], Iterable[Record]]
) -> bool:
    """Whether it has parts out of other points than they are out of now, in which all marks recorded are."""
    now = _maxima_now(problem_set)
    return not now.items() <= _maxima(book, problem_set).items() and all(
        part.out_of == now.get(key, part.out_of) for record in records() for key, part in record.parts.items()
    )


def _maxima_now(problem_set: ProblemSet) -> dict[str, float]:
    return {
        problem.answer_name(part): part.points * problem_set.weight(problem)
        for problem in problem_set.problems
        for part in problem.parts
    }


def _maxima(book: Gradebook, problem_set: ProblemSet) -> dict[str, float]:
    """By the part's name in the notebook; empty where the set is not known."""
    from nbgrader.api import MissingEntry

    try:
        notebooks = book.find_assignment(problem_set.name).notebooks
    except MissingEntry:
        return {}
    return {cell.name: cell.max_score for notebook in notebooks for cell in notebook.grade_cells}
