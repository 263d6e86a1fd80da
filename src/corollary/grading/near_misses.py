"""Near misses of reading: answers that earned nothing and would be right if they were read otherwise, for a person to decide."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial

from corollary.answers.answer import Answer, Entries, Formulas, Letter, Numbers, Unclear
from corollary.answers.expected import Expected, Values
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Right, Unmarked
from corollary.formula.value import Nothing, Value
from corollary.grading.expectations import expected_of
from corollary.grading.judge import read, values_in, verdict_on
from corollary.grading.key import Key
from corollary.grading.other_readings import (
    CASE,
    NO_NAME,
    NO_QUOTES,
    OTHER_LETTER,
    POWER,
    TWO_WAYS,
    other_readings,
    text_typed,
)
from corollary.grading.part_grades import Grade, NearMiss, PartGrade
from corollary.guard import Failure, guarded
from corollary.messages import catalogue, in_convention
from corollary.problem.part import Part
from corollary.problem.variant import Variant

_ = catalogue(__name__)

LONGEST = 2.0
"""Seconds of the processor for all readings of one answer; a hundredth is usual."""


def with_near_misses(
    key: Key, grade: Grade, answers: Mapping[str, Value], nameless: Mapping[str, str] | None = None
) -> Grade:
    """The grade, in which each part that earned nothing has the other reading by which it would be right, where there is one.

    Right is, too, what follows from the student's own earlier answers. No verdict and no points are changed. `nameless`: how the
    answers stand in their cells that no cell gave to their names.
    """
    lines = nameless or {}
    if not any(_may_be_one(part, answers) for part in grade.parts):
        return grade
    so_far, parts = dict[str, Values](), list[PartGrade]()
    for part in grade.parts:
        value = answers.get(part.part.id, Nothing())
        if part.part.id not in key.truths and part.part.id not in key.choices:
            parts.append(part)
            continue
        expected = expected_of(key, part.part, so_far)
        answer = read(part.part, value, expected, key.variant)
        if _may_be_one(part, answers):
            text = lines.get(part.part.id, "")
            found = guarded(partial(_near_miss, key.variant, part, value, answer, expected, text), LONGEST)
            part = replace(part, near=None if isinstance(found, Failure) else found)
        if (values := values_in(answer, expected)) is not None:
            so_far[part.part.id] = values
        parts.append(part)
    return replace(grade, parts=tuple(parts))


def accepted_text(reading: str) -> str:
    """What a student reads whose answer a person has accepted."""
    return _("Your answer was taken as `{reading}`. Write it so next time.", reading=in_convention(reading))


def _may_be_one(part: PartGrade, answers: Mapping[str, Value]) -> bool:
    """True if a part earned nothing for an answer that could be read otherwise."""
    names = part.part.answer_types
    return (
        not part.points
        and part.out_of > 0
        and len(names) == 1
        and answer_type(names[0]).found_in == "variable"
        and not isinstance(part.verdict, Right | Follows)
        and not isinstance(answers.get(part.part.id, Nothing()), Nothing)
    )


def _near_miss(
    variant: Variant, grade: PartGrade, value: Value, answer: Answer, expected: Expected, nameless: str
) -> NearMiss | None:
    """The first other reading that is right; `nameless` is the text of an answer that was not given to its name."""
    part = grade.part
    kind_typed = NO_NAME if nameless else NO_QUOTES
    as_typed = [(kind_typed, answer)] if isinstance(grade.verdict, Unmarked) else []
    wrong = set[tuple[tuple[float, ...], ...]]()
    for kind, other in (*as_typed, *_readings(variant, part, value, answer, expected)):
        if isinstance(other, Numbers) and not other.misfit and not other.in_words:
            number = (other.values, other.figures, other.sizes)
            if number in wrong:
                continue
            wrong.add(number)
        if isinstance(verdict_on(part.answer_type, other, expected), Right | Follows):
            return NearMiss(kind, nameless or text_typed(value), other.as_read)
    return None


def _readings(
    variant: Variant, part: Part, value: Value, answer: Answer, expected: Expected
) -> Iterator[tuple[str, Numbers | Formulas | Letter | Entries]]:
    if isinstance(answer, Unclear):
        yield from ((TWO_WAYS, each) for each in (*answer.readings, *answer.near))
    zero = expected.quantity is not None and not any(expected.quantity.values)
    read_already: list[Value | Numbers] = [value]
    for kind, other in other_readings(value, answer, expected.question):
        if zero and kind in (CASE, POWER):  # what is read as next to nothing would be it
            continue
        if other in read_already:
            continue
        read_already.append(other)
        if not isinstance(other, Numbers):
            other = read(part, other, expected, variant)
        if kind == OTHER_LETTER and not isinstance(other, Formulas):
            continue
        if isinstance(other, Numbers | Formulas | Letter | Entries):
            yield kind, other
