"""The answers that an author expects, held against the key of the problem's own numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from corollary.answers.answer import Answer, Entries, Letter, Numbers, Unclear
from corollary.answers.expected import Values
from corollary.answers.numbers import scalar
from corollary.answers.option_names import option_named
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.answers.vectors import vector
from corollary.formula.value import Text
from corollary.grading.key import Key
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.units.unit import Unit, show
from corollary.verify.checked import Tally

FACTOR = 2.0  # an estimate in one's head is within it; most slips of the algebra are not
SMALL = 0.1  # of the length of a vector: nobody foresees the sign of such a component
FIGURES = 3
RANGE = re.compile(r"\d[^\d,;()]{0,12}?\s*(?:\bto\b|\band\b|\bbis\b|\btil\b|(?<![eE])[-\N{EN DASH}])\s*\d")


def check_expected(key: Key, tally: Tally) -> None:
    """Complains of each answer that is not about what the author expects; `key` is that of the problem's own numbers."""
    problem = key.variant.problem
    for part_id, expected in problem.expected:
        part = problem.part(part_id)
        sentences = list(disagreements(key, part, expected))
        tally.check(not sentences, "expected answers")
        for sentence in sentences:
            tally.complain(f"{problem.path.name}:{part.line}: part {part.id}: {sentence}")


def unexpected(problem: Problem) -> str:
    """A line that asks for the answers which the author expects of quantities; "" where there are all."""
    missing = [
        part
        for part in problem.parts
        if part.id not in dict(problem.expected) and answer_type(part.answer_type).stated_by == "step"
    ]
    if not missing:
        return ""
    parts, unit = ", ".join(part.id for part in missing), show(missing[0].unit)
    which = f"part {parts}" if len(missing) == 1 else f"parts {parts}"
    example = f"about 40 {unit}".rstrip()
    return (
        f"{problem.path.name}:{missing[0].line}: what do you expect of {which}? Write it into the heading, from your own estimate, "
        f'such as {{#{missing[0].id} … expected="{example}"}}: verify then holds the key against it'
    )


def disagreements(key: Key, part: Part, expected: str) -> Iterator[str]:
    """A sentence for each way in which the key of a part is not what is expected."""
    answer = _read(key.variant.problem, part, expected)
    truth = key.truths.get(part.id)
    if isinstance(answer, Letter) and part.id in key.choices:
        if answer.letter != key.choices[part.id]:
            right = option_named(part, key.choices[part.id])
            yield f"you expect {option_named(part, answer.letter)}, and {right} holds; one of the two is wrong"
        return
    numbers = _numbers(answer)
    if isinstance(numbers, str) or truth is None:
        why = numbers if isinstance(numbers, str) else "it has no number"
        if RANGE.search(expected) and part.answer_type != "interval":
            why = "it is a range; write the value in its middle, for the key may be half of that or twice as much"
        yield f'expected="{expected}" cannot be compared: {why}'
        return
    units = part.units_for(len(truth.values))
    derived = _written(truth.values, units)
    if len(numbers) != len(truth.values):
        yield f"you expect {len(numbers)} numbers ({expected}), and the derivation gives {len(truth.values)}: {derived}"
        return
    zeros = tuple(float(unit.offset) for unit in units)
    if how := difference(in_order(part, numbers), in_order(part, truth.values), zeros):
        yield f"you expect {expected}, and the derivation gives {derived}: {how}; a law is wrong, or the estimate"


def foreseen(problem: Problem, part: Part, expected: str) -> Values | None:
    """The numbers, in SI, that an author expects of a part; None where it is none."""
    found = _numbers(_read(problem, part, expected))
    return None if isinstance(found, str) else found


def _read(problem: Problem, part: Part, expected: str) -> Answer:
    """As a student's answer is read; of a formula the value."""
    question, its_type = question_in(chapter(problem), part), answer_type(part.answer_type)
    if not its_type.in_symbols:
        return its_type.read(Text(expected), question)
    return vector(Text(expected), question) if part.components else scalar(Text(expected), question)


def _numbers(answer: Answer) -> tuple[float, ...] | str:
    """The numbers of an answer in SI; a sentence where it has none."""
    match answer:
        case Numbers(values, misfit=""):
            return values
        case Numbers(misfit=misfit):
            return misfit
        case Entries(entries):
            found = [_numbers(each) for each in entries]
            wrong = [each for each in found if isinstance(each, str)]
            return wrong[0] if wrong else tuple(each[0] for each in found if not isinstance(each, str))
        case Unclear(why):
            return why
        case _:
            return "say a number that you would expect, with its unit"


def difference(numbers: Values, values: Values, zeros: Values) -> str:
    """How numbers in SI differ from what is expected of them; `zeros` are where their scales begin."""
    length, foreseen = math.hypot(*values), math.hypot(*numbers)
    for number, value, zero in zip(numbers, values, zeros, strict=True):
        mine, theirs = number - zero, value - zero
        small = len(values) > 1 and abs(mine) <= SMALL * foreseen and abs(theirs) <= SMALL * length
        if mine == theirs or small:
            continue
        if mine * theirs < 0:
            return "the sign is another"
        if not mine or not theirs:
            return "one of the two is zero"
        if not 1 / FACTOR <= mine / theirs <= FACTOR:
            return f"they differ by a factor of {max(mine / theirs, theirs / mine):.3g}"
    return ""


def in_order(part: Part, values: Values) -> Values:
    """The numbers of a part whose order says nothing, the smallest first."""
    return tuple(sorted(values)) if {"list", "interval"} & {*part.answer_types} else values


def _written(values: Values, units: Sequence[Unit]) -> str:
    pairs = zip(values, units, strict=True)
    return ", ".join(f"{unit.from_si(value):.{FIGURES}g} {show(unit)}".rstrip() for value, unit in pairs)
