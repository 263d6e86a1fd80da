"""Assignment of a variant to a student: the first draw that is free, has a key, and hides no mistake."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from corollary.answers.choice.option_text import alike
from corollary.answers.evaluation import balls
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.answers.spellings import spelled_alike
from corollary.derive.solution import Solution
from corollary.formula.ball import Undefined
from corollary.grading.key import Key, make_key, named
from corollary.grading.mistakes import visible_mistakes
from corollary.grading.near_steps import near_steps
from corollary.grading.replay import exchanged
from corollary.grading.rounding import MOST_TOLERANCE
from corollary.problem.part import Part
from corollary.problem.sampling import draws
from corollary.problem.variant import Variant, chapter
from corollary.units.unit import show

APART = 0.005  # of the length: as much again as the least tolerance, so that a mistake rounded is not right either
SAME = 1e-9  # relative: doubles of one value by two ways
LARGEST_WHOLE = 1e9  # beyond it one more is no other number to a tolerance that doubles need
TRIED = (
    40  # draws besides the printed numbers: a mistake that shows on a tenth of them is missed once in seventy
)
CORNERS = 64  # of the grid, tried besides
ENOUGH = 300  # draws, when one was found that another student has: a grid so nearly used up is shared


class NoVariant(LookupError):
    """No draw of a problem will do; one sentence says why the last ones did not."""


@dataclass(frozen=True, slots=True)
class AssignedVariant:
    """A student's variant of one problem, and how many draws were refused before it."""

    key: Key
    redrawn: int

    @property
    def variant(self) -> Variant:
        return self.key.variant


def assign_variant(
    solution: Solution, secret: bytes, student: str, in_use: Iterable[int] = ()
) -> AssignedVariant:
    """The student's own variant; `in_use` are the indices of other students' variants. Raises NoVariant."""
    problem, occupied, reasons = solution.problem, set(in_use), list[str]()
    if all(given.grid.count == 1 for given in problem.givens):
        return AssignedVariant(make_key(solution, chapter(problem)), 0)
    fallback: AssignedVariant | None = None
    for redrawn, variant in enumerate(draws(problem, secret, student)):
        key, reason = admitted(solution, variant)
        if key is None:
            reasons.append(reason)
        elif variant.index in occupied:
            fallback = fallback or AssignedVariant(
                key, redrawn
            )  # every variant may be in use: then students share
        else:
            return AssignedVariant(key, redrawn)
        if redrawn >= ENOUGH and fallback is not None:
            return fallback
    if fallback is not None:
        return fallback
    raise NoVariant(
        f"{problem.code}: none of the draws for {student} will do; {reasons[-1] if reasons else 'its conditions leave none'}"
    )


def admitted(solution: Solution, variant: Variant) -> tuple[Key | None, str]:
    """The key of a variant that may be assigned, or None and why it may not."""
    try:
        key = make_key(solution, variant)
        same = next(options_alike(variant), None)
    except Undefined as error:
        return None, f"an answer does not exist: {error}"
    for part, argument in near_steps(key):
        return None, f"part {part}: {argument} is too near a step: rounding would decide the whole number"
    for part, truth in key.truths.items():
        if variant.problem.asks_of_variable(part):
            continue  # a formula is compared as one; what it comes to at one place decides nothing
        most = max(MOST_TOLERANCE, variant.problem.part(part).tolerance)
        if truth.noise > most:
            return (
                None,
                f"part {part}: honest rounding to three figures moves the answer by more than {100 * most:.2g} %",
            )
        if truth.scale == 0 and not truth.counted:
            return (
                None,
                f"part {part}: the answer is zero, and nothing says compared with what: state it in its step, as scale: `v_0`",
            )
    if same is not None:
        part, one, other = same
        return None, f"part {part}: options {one} and {other} print alike"
    for part, number in not_whole(key):
        return (
            None,
            f"part {part}: {number} is not a whole number below {LARGEST_WHOLE:.0e}, and one is asked for",
        )
    for part, number in implausible(key):
        return None, f"part {part}: {number} is not plausible"
    for part, text in collisions(key):
        return None, f"part {part}: the mistake {text!r} cannot be told from the truth"
    return key, ""


def options_alike(variant: Variant, parts: Iterable[Part] | None = None) -> Iterator[tuple[str, str, str]]:
    """The parts with two options that print alike with these numbers, and the marks of these options. Raises Undefined where an
    option has no value."""
    for part in variant.problem.parts if parts is None else parts:
        if not part.options:
            continue
        question = question_in(variant, part)
        texts = dict(zip(question.options, question.option_texts, strict=True))
        if found := alike(texts) if answer_type(part.answer_type).shows_letters else spelled_alike(texts):
            one, other = found
            yield part.id, one.upper(), other.upper()


def not_whole(key: Key) -> Iterable[tuple[str, str]]:
    """Answers to parts that ask for a whole number, and come to none."""
    for part in key.variant.problem.parts:
        if part.answer_type == "integer" and part.id in key.truths:
            (value,) = map(part.unit.from_si, key.truths[part.id].values)
            if abs(value) > LARGEST_WHOLE or not math.isclose(value, round(value), rel_tol=SAME):
                yield part.id, f"{value:.6g}"


def implausible(key: Key) -> Iterable[tuple[str, str]]:
    """Answers outside of what the part says is plausible, each as a number with its unit."""
    for part in key.variant.problem.parts:
        if part.plausible and part.id in key.truths:
            low, high = part.plausible
            for value in map(part.unit.from_si, key.truths[part.id].values):
                if not low <= value <= high:
                    yield part.id, f"{value:.4g} {show(part.unit)}".rstrip()


def collisions(key: Key) -> Iterable[tuple[str, str]]:
    """Parts on which a known mistake falls within the tolerance (and half a per cent more) of the truth.

    A mistake counts for the part of its own step, or, at a step nobody is asked about, for the parts reached from it
    through such steps only. One that never changes a part is no mistake for it.
    """
    solution = key.solution
    known = balls(key.variant.exact | named(solution, key.values))
    for each in visible_mistakes(solution):
        if each.part not in key.truths or key.variant.problem.asks_of_variable(each.part):
            continue
        truth = key.truths[each.part]
        try:
            values = exchanged(solution, known, each.place, each.mistake.rule, each.at)
        except Undefined:
            continue
        if truth.is_met_by(values, APART):
            yield each.part, each.mistake.text
