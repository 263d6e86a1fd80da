"""Wrong answers of a graded course as numbers again, with the keys of the numbers that each student drew."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

from corollary.answers.answer import Numbers
from corollary.answers.verdict import Mistaken
from corollary.derive.solution import Solution
from corollary.formula.ball import Undefined
from corollary.formula.value import Text
from corollary.grading.expectations import expected_of
from corollary.grading.judge import read, values_in
from corollary.grading.key import Key
from corollary.grading.number_features import number_features
from corollary.grading.points import share
from corollary.grading.solutions import Solutions
from corollary.problem.part import Part
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import read_assigned
from corollary.records.files import Course
from corollary.records.marks import WRONG, PartRecord, Record, Row, read_marks
from corollary.records.statistics import PartFeatures
from corollary.records.unlisted import DrawnLetters, SharedRule, shared_rules

DrawnKeys = Mapping[tuple[str, str], Key]
"""By student and problem; none of numbers dealt by a solution of before which have no answer by today's."""


def drawn_keys(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    students: Collection[str],
    done: Callable[[str], None],
    code: str = "",
) -> DrawnKeys:
    """`done` is told the id of each student; `code` names the one problem of which the keys are wanted. Raises NotACourse, NotSettled and NotDerivable."""
    found: dict[tuple[str, str], Key] = {}
    for student, sheet in read_assigned(course, problem_set).items():
        if student not in students:
            continue
        for variant in sheet.variants:
            if code not in ("", variant.problem.code):
                continue
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


Marked = Mapping[str, tuple[Row, PartRecord]]
"""What became of each part of one problem."""


def unlisted(course: Course, problem_set: ProblemSet, keys: DrawnKeys) -> list[SharedRule]:
    """Rules that nobody listed and that several students share, part by part. Raises NotACourse and NotSettled."""
    records = read_marks(course, problem_set, read_assigned(course, problem_set))
    wrong = {
        (row.problem, row.part)
        for record in records.values()
        for row in record.rows
        if row.verdict == WRONG and not row.by_hand
    }
    codes = {problem for problem, _ in wrong}
    drawn: dict[tuple[str, str], list[tuple[Solution, DrawnLetters]]] = {}
    for (student, code), key in keys.items():
        if code in codes and student in records:
            for part, letters in letters_of(
                student, key, parts_of(records[student], code), problem_set
            ).items():
                if (code, part) in wrong:
                    drawn.setdefault((code, part), []).append((key.solution, letters))
    return [
        shared
        for (problem, part), several in drawn.items()
        for solution in {id(solution): solution for solution, _ in several}.values()
        for shared in shared_rules(
            solution, problem, part, [letters for its, letters in several if its is solution]
        )
    ]


def parts_of(record: Record, code: str) -> Marked:
    """What became of each part of one problem."""
    pairs = zip(record.rows, record.parts.values(), strict=True)  # rows and parts are of one order
    return {row.part: (row, part) for row, part in pairs if row.problem == code}


def letters_of(
    student: str, key: Key, marked: Marked, problem_set: ProblemSet, asked: str = ""
) -> dict[str, DrawnLetters]:
    """By part, those that ask for a number or a vector: values typed earlier count in the place of those of the key. The answer to
    the part `asked` is looked at whatever its verdict."""
    variant = key.variant
    letters = dict(variant.si)
    for find, values in zip(key.solution.unknowns, key.values, strict=True):
        letters |= zip(find.names, values, strict=True)
    found: dict[str, DrawnLetters] = {}
    for part in variant.problem.parts:
        truth = key.truths.get(part.id)
        if truth is None or truth.scales or part.unit.offset or part.id not in marked:
            continue
        row, record = marked[part.id]
        typed = _typed(key, part, record.answer)
        is_wrong = typed is not None and (part.id == asked or (row.verdict == WRONG and not row.by_hand))
        points = row.out_of * share(Mistaken(""), problem_set.scheme, part.answer_type)
        found[part.id] = DrawnLetters(
            student, dict(letters), typed if is_wrong else None, truth.tolerance, points - row.points
        )
        if typed is not None:
            letters |= zip(key.find(truth).names, typed, strict=True)
    return found


def _typed(key: Key, part: Part, answer: str) -> tuple[float, ...] | None:
    """The answer as it was read, in SI; None where it is no number, or of another dimension."""
    expected = expected_of(key, part)
    answered = read(part, Text(answer), expected, key.variant)
    if isinstance(answered, Numbers) and answered.misfit:
        return None
    values = values_in(answered, expected)
    return values if values is not None and len(values) == len(key.truths[part.id].values) else None
