"""The keys of the numbers that each student of a course drew, and what is known of these numbers."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

from corollary.formula.ball import Undefined
from corollary.grading.key import Key
from corollary.grading.number_features import number_features
from corollary.grading.solutions import Solutions
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import read_assigned
from corollary.records.files import Course
from corollary.records.statistics import PartFeatures

DrawnKeys = Mapping[tuple[str, str], Key]
"""By student and problem; none of numbers dealt by a solution of before which have no answer by today's."""


def drawn_keys(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    students: Collection[str],
    done: Callable[[str], None],
) -> DrawnKeys:
    """`done` is told the id of each student. Raises NotACourse, NotSettled and NotDerivable."""
    found: dict[tuple[str, str], Key] = {}
    for student, sheet in read_assigned(course, problem_set).items():
        if student not in students:
            continue
        for variant in sheet.variants:
            try:
                found[student, variant.problem.code] = solutions.key(variant)
            except Undefined:
                continue
        done(student)
    return found


def drawn_numbers(keys: DrawnKeys) -> PartFeatures:
    """What the derivations know of the numbers, by student, problem and part."""
    return {
        (student, problem, part): features
        for (student, problem), key in keys.items()
        for part, features in number_features(key).items()
    }
