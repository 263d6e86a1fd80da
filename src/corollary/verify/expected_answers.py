"""Answers judged as they are named: those that an author expects, and each answer type's own samples."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from corollary.answers.answer import Answer, Entries, Equation, Letter, Numbers, Unclear
from corollary.answers.evaluation import number
from corollary.answers.expected import Claim, Values
from corollary.answers.numbers import scalar
from corollary.answers.option_names import option_named
from corollary.answers.proof.argument import sufficient
from corollary.answers.proof.judging import grounds_of
from corollary.answers.proof.rates import derivative, with_known_rates
from corollary.answers.proof.truth import truths
from corollary.answers.question import Question
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type, judging
from corollary.answers.sample import Sample, Truth
from corollary.answers.vectors import vector
from corollary.answers.verdict import described, word
from corollary.formula.ast import Relation
from corollary.formula.plain_text import text
from corollary.formula.value import Text
from corollary.grading.expectations import expected_of
from corollary.grading.forces_on_body import as_answered, free_body
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, named
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.units.unit import Unit, show
from corollary.verify.checked import Tally

NOT_RIGHT = ("wrong", "slip", "mistaken")


def check_samples(key: Key, tally: Tally) -> None:
    """Right samples are right, unreadable ones unread, and wrong ones neither."""
    for part in key.variant.problem.parts:
        for sample in samples(key, part):
            ((verdict,), _) = judge(key, {part.id: from_json(sample.answer)})[part.id]
            got = word(verdict)
            as_named = got in NOT_RIGHT if sample.verdict == "wrong" else got == sample.verdict
            if not tally.check(as_named, "kind samples"):
                tally.complain(
                    f"{key.variant.problem.path.name}:{part.line}: part {part.id}: "
                    f"the sample {sample.answer!r} should be {sample.verdict} and is {described(verdict)}"
                )


def check_claims(key: Key, tally: Tally) -> None:
    """The laws that a proof names imply what it is to show, and hold at all times by its rates."""
    for part in key.variant.problem.parts:
        expected = expected_of(key, part)
        if expected.claim is None:
            continue
        grounds = grounds_of(expected.claim, expected.claim.points(), expected.question)
        if not tally.check(bool(sufficient(grounds)), "claims shown"):
            tally.complain(
                f"{key.variant.problem.path.name}:{part.line}: part {part.id}: the laws of the proof are not found to imply "
                f"{text(expected.claim.target)}: every derivation would wait for marking; name the law that is missing"
            )
        for law in changing(expected.claim, expected.question):
            tally.complain(
                f"{key.variant.problem.path.name}:{part.line}: part {part.id}: by its rates= the law {text(law)} does not go on to hold; "
                "name the derivative of each letter in it that changes"
            )


def changing(claim: Claim, question: Question) -> list[Relation]:
    """The laws of a proof that its rates contradict: whose sides change otherwise, where all that is in them has a known rate."""
    if not claim.rates:
        return []
    rates = dict(claim.rates)
    found: list[Relation] = []
    for law in (*claim.laws, claim.target):
        moved = [derivative(side) for side in (law.left, law.right)]
        if moved[0] is None or moved[1] is None:
            continue
        step = Equation(Relation("=", moved[0], moved[1]), 0)
        (known,) = with_known_rates((step,), rates, set(question.symbol_names) - set(rates))
        if "false" in truths((known,), claim.points()):
            found.append(law)
    return found


def samples(key: Key, part: Part) -> tuple[Sample, ...]:
    """What the part's answer type makes of its truth; programs and figures have theirs run elsewhere."""
    truth = _truth(key, part)
    question = question_in(key.variant, part)
    return () if truth is None else tuple(judging(part.answer_type).samples(truth, question))


def _truth(key: Key, part: Part) -> Truth | None:
    """What is right, as the part's answer type makes samples of it; None where there is nothing to make them of."""
    if part.id in key.choices:
        return key.choices[part.id]
    if part.id in key.solution.forces:
        return as_answered(free_body(key.solution.forces[part.id], key.variant), part)
    if part.id in key.solution.proofs:
        return "\n".join(key.solution.proofs[part.id].lines)
    if part.id in key.solution.examples:
        known = key.variant.exact | named(key.solution, list(key.values))
        instance = key.solution.examples[part.id].instance
        return None if instance is None else [number(tree, known) for tree in instance]
    if part.id not in key.truths:
        return ""
    if not answer_type(part.answer_type).in_symbols:
        return key.truths[part.id].values
    in_givens = key.find(key.truths[part.id]).in_givens
    return "; ".join(map(text, in_givens)) if in_givens else None


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
    for given, value, zero in zip(numbers, values, zeros, strict=True):
        mine, theirs = given - zero, value - zero
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
