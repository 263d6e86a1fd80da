"""What is known of the numbers that each student of a course drew."""

from __future__ import annotations

from collections.abc import Callable, Collection

from corollary.formula.ball import Undefined
from corollary.grading.number_features import number_features
from corollary.grading.solutions import Solutions
from corollary.problem.problem_set import ProblemSet
from corollary.records.assigned import read_assigned
from corollary.records.fairness import PartFeatures
from corollary.records.files import Course


def drawn_numbers(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    students: Collection[str],
    done: Callable[[str], None],
) -> PartFeatures:
    """By student, problem and part; `done` is told the id of each student. Raises NotACourse, NotSettled and NotDerivable."""
    features: dict[tuple[str, str, str], dict[str, float]] = {}
    for student, sheet in read_assigned(course, problem_set).items():
        if student not in students:
            continue
        for variant in sheet.variants:
            try:
                of_parts = number_features(solutions.key(variant))
            except Undefined:  # dealt by a solution of before; by today's they have no answer
                continue
            features |= {(student, variant.problem.code, part): found for part, found in of_parts.items()}
        done(student)
    return features
