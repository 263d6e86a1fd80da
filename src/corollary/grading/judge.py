"""One problem of one student judged, part by part, in the order asked."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING

from corollary.answers.answer import Answer, Blank, Entries, Formulas, Numbers, Prose, Unclear
from corollary.answers.expected import Expected, Values
from corollary.answers.judge_formulas import values_of
from corollary.answers.preview import about_open_words
from corollary.answers.questions import question_in
from corollary.answers.registry import BUILT_IN, answer_type, judging
from corollary.answers.renamed_letters import in_letters
from corollary.answers.tolerance import last_place, same_value
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict
from corollary.formula.ast import Expr, Negative
from corollary.formula.plain_text import text as formula_text
from corollary.formula.value import Nothing, Value
from corollary.grading.expectations import expected_of
from corollary.grading.follow_through import AsWritten, same_as
from corollary.grading.guesses import for_nothing, guessed, one_number, own_work, repeated
from corollary.grading.key import Key
from corollary.grading.rounding import LEAST_TOLERANCE
from corollary.guard import Failure, guarded
from corollary.messages import catalogue, in_convention
from corollary.problem.part import Part
from corollary.problem.variant import Variant

if TYPE_CHECKING:  # programs are not run in a browser, where this judges, too
    from corollary.grading.program_run import ProgramRun

_ = catalogue(__name__)
LONGEST = 10.0
"""Seconds of the processor for reading and judging one answer; a hundredth is usual, and programs are run elsewhere."""


def judge(
    key: Key,
    answers: Mapping[str, Value],
    programs: Mapping[str, ProgramRun] | None = None,
    *,
    secret: bytes = b"",
    student: str = "",
    passing: tuple[type[Exception], ...] = (),
) -> dict[str, tuple[tuple[Verdict, ...], str]]:
    """The verdicts of each part, and how the answer was read. A part of two types (code and plot) has two verdicts.

    What cannot be judged waits for a person; only exceptions that are `passing` are raised.
    """
    so_far = _SoFar()
    result: dict[str, tuple[tuple[Verdict, ...], str]] = {}
    for part in key.variant.problem.parts:
        run = (programs or {}).get(part.id)
        on_runs = (
            partial(_on_runs, key, part, run, secret, student) if run else dict[str, Callable[[], Verdict]]
        )
        value = answers.get(part.id, Nothing())
        found = guarded(partial(_of_part, key, part, value, on_runs, so_far), LONGEST, passing)
        if isinstance(found, Failure):
            found = (
                tuple(
                    Unmarked(_("The program failed to mark this, so your teacher will mark it."))
                    for _type in part.answer_types
                ),
                "",
            )
        result[part.id] = found
    for part in repeated(so_far.typed, {part: verdicts for part, (verdicts, _answer) in result.items()}):
        verdicts, as_read = result[part]
        result[part] = tuple(map(for_nothing, verdicts)), as_read
    return result


@dataclass(frozen=True, slots=True)
class _SoFar:
    """What came of the parts before: their values and how they were written, the slips met, and the one number that was typed."""

    values: dict[str, Values] = field(default_factory=dict[str, Values])
    written: dict[str, AsWritten] = field(default_factory=dict[str, AsWritten])
    slips: set[tuple[str, float]] = field(default_factory=set[tuple[str, float]])
    typed: dict[str, float] = field(default_factory=dict[str, float])


def _of_part(
    key: Key,
    part: Part,
    value: Value,
    on_runs: Callable[[], Mapping[str, Callable[[], Verdict]]],
    so_far: _SoFar,
) -> tuple[tuple[Verdict, ...], str]:
    """The verdicts of one part, and how its answer was read."""
    expected = expected_of(key, part, so_far.values, on_runs(), so_far.written)
    try:
        answer = read(part, value, expected, key.variant)
        verdicts = tuple(verdict_on(name, answer, expected) for name in part.answer_types)
    except (
        Exception
    ) as error:  # in a program of somebody else's, which costs its own part an automatic verdict
        if set(part.answer_types) <= set(BUILT_IN):
            raise
        answer, verdicts = Blank(), tuple(_failed(name, error) for name in part.answer_types)
    values = values_in(answer, expected)
    again = same_as(key.solution, key.truths[part.id].place) if part.id in key.truths else ""
    verdicts = tuple(own_work(verdict, values, so_far.values, again) for verdict in verdicts)
    if part.id in key.truths:
        verdicts = tuple(guessed(verdict, values, key, part, so_far.values) for verdict in verdicts)
    so_far.written[part.id] = AsWritten(_halves(answer, part), any(map(_has_name, verdicts)))
    verdicts = tuple(_once(verdict, so_far.slips) for verdict in verdicts)
    if isinstance(answer, Numbers):
        so_far.typed[part.id] = one_number(answer, part)
    if values is not None:
        so_far.values[part.id] = values
    return verdicts, answer.as_read


def _halves(answer: Answer, part: Part) -> Values:
    """Half of the last figure of each number, in SI; 0 where it was not rounded. A number of one figure or two says less than it
    seems to: 1.8 may be 1.80."""
    if not isinstance(answer, Numbers) or not all(map(math.isfinite, answer.values)):
        return ()
    count = len(answer.values)
    sizes = answer.sizes or (part.unit.si,) * count
    zeros = answer.zeros or (float(part.unit.offset),) * count
    written = [value - zero for value, zero in zip(answer.values, zeros, strict=True)]
    return tuple(
        min(0.5 * last_place(value, figures, size), LEAST_TOLERANCE * abs(value))
        if value and figures
        else 0.0
        for value, figures, size in zip(written, answer.figures, sizes, strict=True)
    )


def _has_name(verdict: Verdict) -> bool:
    """True of an error that was worked out, be it a misconception, a slip, or what follows from another."""
    match verdict:
        case Mistaken(nothing=nothing) | Follows(nothing=nothing):
            return not nothing
        case Slip(once=once):
            return once
        case _:
            return False


def _on_runs(
    key: Key, part: Part, run: ProgramRun, secret: bytes, student: str
) -> Mapping[str, Callable[[], Verdict]]:
    from corollary.grading.programs.judge_programs import verdicts_on_runs  # only here: it brings the sandbox

    return verdicts_on_runs(key.solution, key.variant, part, run, secret, student)


def read(part: Part, value: Value, expected: Expected, variant: Variant) -> Answer:
    """The answer to a part, in the letters of today; of a function or a figure its signature, for it is judged by what it does
    when run."""
    its_type = answer_type(part.answer_type)
    if its_type.found_in in ("function", "figure"):
        return Prose(part.signature)
    if not variant.problem.renamed:
        return its_type.read(value, expected.question)
    meant = {asked: today for today, asked in variant.problem.renamed}
    return in_letters(its_type.read(value, question_in(variant, part)), meant)


def verdict_on(name: str, answer: Answer, expected: Expected) -> Verdict:
    """The verdict of one answer type on one answer; what could not be read is judged by what it may mean."""
    match answer:
        case Blank():
            return Unread(_("No answer was given."), blank=True)
        case Unclear(why, near=near) if any(
            isinstance(verdict_on(name, each, expected), Right) for each in near
        ):
            return Unmarked(
                _(
                    "This is nearly the right word, so your teacher will decide. ({reason})",
                    reason=f"{why[0].upper()}{why[1:]}.",
                )
            )
        case Unclear(why, _excerpt, readings, benefit, sign_alone=sign_alone):
            benefit = benefit or (sign_alone and _has_no_sign(expected))
            verdicts = (verdict_on(name, each, expected) for each in readings)
            right = next((each for each in verdicts if isinstance(each, Right | Follows)), None)
            reason = _begun(f"{why}.", answer.as_read)
            if isinstance(right, Right) and benefit:
                return Right(
                    _("This can be read in two ways; the right one counts. ({reason})", reason=reason)
                )
            if right is not None and benefit:
                return right
            if right is not None:
                return Unmarked(
                    _(
                        "This can be read in two ways, and one of them is right, so your teacher will decide. ({reason})",
                        reason=reason,
                    )
                )
            end = "" if why.endswith((".", "?")) else "."
            return Unread(_begun(why + end, answer.as_read))
        case Numbers(values, open_words=words, turning_words=turning) if words or turning:
            bare = replace(answer, open_words="", turning_words="")
            found = verdict_on(name, bare, expected)
            right = isinstance(found, Right | Follows)
            if not right and turning and any(values):
                turned = replace(bare, values=tuple(-value for value in values))
                right, words = isinstance(verdict_on(name, turned, expected), Right | Follows), turning
            if not (right and words):
                return found
            return Unmarked(
                _(
                    "Read as {answer}; {remark}.",
                    answer=in_convention(answer.as_read),
                    remark=about_open_words(words),
                )
            )
        case Numbers(values=(value,), beside=beside) if beside and expected.quantity is not None:
            found = judging(name).judge(answer, expected)
            if isinstance(found, Right) and (tree := _disagreeing(beside, value, expected)) is not None:
                why = _(
                    "{formula} does not give {answer}; write the answer alone",
                    formula=formula_text(tree),
                    answer=answer.as_read,
                )
                return Unread(f"{why}.")
            return found
        case _:
            return judging(name).judge(answer, expected)


def _disagreeing(sides: Sequence[Expr], value: float, expected: Expected) -> Expr | None:
    """The first formula of the givens on the left that does not come to the number on the right.

    `F = m*g = -2 N` may count upwards; a minus that stands there, as in `F = -m*v/dt = 86 N`, counts.
    """
    assert expected.quantity is not None
    residue = max(expected.quantity.residue, default=0.0)
    for tree in sides:
        signs = (1,) if isinstance(tree, Negative) else (1, -1)
        found = values_of((tree,), expected.quantity.givens())
        if found is not None and not any(same_value(sign * value, found[0], residue) for sign in signs):
            return tree
    return None


def _has_no_sign(expected: Expected) -> bool:
    """True of what is positive for all numbers, such as a mass or a distance: words beside it cannot turn it round."""
    return (
        expected.quantity is not None and bool(expected.quantity.signed) and not any(expected.quantity.signed)
    )


def _begun(sentence: str, typed: str) -> str:
    """With a capital, unless it begins with what was typed: `mn can be mN or MN`."""
    first = re.match(r"[^\W\d_]+(?![\w*^/.(])", sentence)
    own = first is None or len(first[0]) < 2 or re.search(rf"\b{re.escape(first[0])}\b", typed)
    return sentence if own else f"{sentence[0].upper()}{sentence[1:]}"


def _failed(name: str, error: Exception) -> Unmarked:
    """Says what failed without its message, which may hold what is expected."""
    return Unmarked(
        _(
            "The program failed to mark this, so your teacher will mark it. ({error} in the answer type {name})",
            error=type(error).__name__,
            name=name,
        )
    )


def values_in(answer: Answer, expected: Expected) -> Values | None:
    """The numbers an answer comes to, in SI, for later parts to follow from; None where there are none."""
    if expected.quantity is None or expected.question.variables:
        return None  # a formula of a variable is no number, whatever it comes to at one place
    match answer:
        case Numbers(values):
            return values
        case Formulas(trees):
            return values_of(trees, expected.quantity.givens())
        case Entries(entries):
            found = [values_in(each, expected) for each in entries]
            return tuple(each[0] for each in found if each) if all(found) else None
        case _:
            return None


def _once(verdict: Verdict, slips: set[tuple[str, float]]) -> Verdict:
    """The same generic slip costs once: met again, it is pointed out and forgiven; but for one that a guess makes as well."""
    match verdict:
        case Slip(once=False) | Slip(nothing=True):
            return verdict
        case Slip(slip, factor=factor) if (slip, factor) in slips:
            return Right(
                _("{slip} (The same slip as before; it costs only once.)", slip=slip), leniently=True
            )
        case Slip(slip, factor=factor):
            slips.add((slip, factor))
            return verdict
        case _:
            return verdict
