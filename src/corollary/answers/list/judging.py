"""Several quantities judged in any order, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import Expected, Quantity, Values
from corollary.answers.in_any_order import judge_in_any_order
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.table.judging import entry
from corollary.answers.tolerance import within
from corollary.answers.verdict import Follows, Mistaken, Right, Verdict, Wrong
from corollary.messages import catalogue

_ = catalogue(__name__)


def judge(answer: Answer, expected: Expected) -> Verdict:
    """All of them, in whichever order; else each value that is right counts, and each one too many takes one of these away."""
    wanted = expected.quantity
    assert wanted is not None
    assert isinstance(answer, Numbers | Formulas)
    given = len(answer.values) if isinstance(answer, Numbers) else len(answer.trees)
    whole: Verdict | None = None
    if given == len(wanted.values):
        whole = judge_in_any_order(answer, wanted, expected.question)
        if not isinstance(whole, Wrong):
            return whole
    elif isinstance(answer, Numbers) and (known := _known_length(answer, wanted)) is not None:
        return known
    right = (
        _right(answer, wanted)
        if isinstance(answer, Numbers)
        else _right_formulas(answer, wanted, expected.question)
    )
    if whole is not None and not right:
        return whole
    return Wrong(_what_is_right(right, given, wanted), _entries(right, given, len(wanted.values)))


def _known_length(answer: Numbers, wanted: Quantity) -> Verdict | None:
    """The verdict on a list as long as a mistake, or an earlier answer, makes it; None where none does."""

    def met(values: Values) -> bool:
        scale = math.hypot(*values)
        return len(values) == len(answer.values) and within(
            sorted(answer.values), sorted(values), wanted.tolerance, scale
        )

    ways = list(wanted.follow_through())
    for way in ways:
        if way.earlier and met(way.values):
            return Follows(way.earlier)
    for way in ways:
        for values, sentence in way.misconceptions() if way.misconceptions else ():
            if met(values):
                given, asked = len(answer.values), len(wanted.values)
                entries = _entries(_right(answer, wanted), given, asked)
                return Mistaken(sentence, way.earlier, not any(values), entries)
    return None


def _entries(right: int, given: int, asked: int) -> tuple[Verdict, ...]:
    """A verdict for each value asked for; none where nothing counts."""
    counted = max(0, right - max(0, given - asked))
    return (Right(),) * counted + (Wrong(),) * (asked - counted) if counted else ()


def _what_is_right(right: int, given: int, wanted: Quantity) -> str:
    if right == given and given < len(wanted.values):
        return _("What you give is right, but it is not all.")
    if right == len(wanted.values):
        return _("The right values are among yours, but there are others that are not right.")
    return _("{right} of your {given} values are right.", right=right, given=given)


def _right(answer: Numbers, wanted: Quantity) -> int:
    """How many of the values wanted are in the list, each counted once."""
    left, off = list(answer.values), wanted.tolerance * wanted.scale
    for value in wanted.values:
        near = min(left, key=lambda x: abs(x - value), default=None)
        if near is not None and abs(near - value) <= min(off, max(wanted.tolerance * abs(value), 1e-9 * off)):
            left.remove(near)
    return len(answer.values) - len(left)


def _right_formulas(answer: Formulas, wanted: Quantity, question: Question) -> int:
    """The same for formulas."""
    one, left = replace(question, components=()), list(range(len(wanted.values)))
    for tree in answer.trees:
        for place in left:
            if isinstance(judge_formulas(replace(answer, trees=(tree,)), entry(wanted, place), one), Right):
                left.remove(place)
                break
    return len(wanted.values) - len(left)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The values in two orders, as a list and in words; one missing, one too many, one off."""
    assert not isinstance(truth, str)
    values, unit = to_be_typed(truth, question)
    texts = [f"{value!r}{unit}" for value in values]
    more = 2.7 * max(map(abs, values)) + 1.3
    off = [f"{values[0] + more!r}{unit}", *texts[1:]]
    return (
        Sample(texts, "right"),
        Sample(texts[::-1], "right"),
        Sample("; ".join(texts), "right"),
        Sample(" and ".join(texts), "right") if len(texts) == 2 else Sample(texts, "right"),
        Sample(texts[1:] if len(texts) > 1 else [*texts, *texts], "wrong"),
        Sample([*texts, f"{more!r}{unit}"], "wrong"),
        Sample(off, "wrong"),
        Sample([], "unread"),
        Sample("some", "unread"),
        Sample(None, "unread"),
    )
