"""The verdict on numbers: right, right from what came before, a known misconception, a slip, or wrong."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations

from corollary.answers.answer import Numbers
from corollary.answers.common_errors import common_factor, slips
from corollary.answers.expected import FollowThrough, Quantity, Values
from corollary.answers.guessing import are_round, may_be_guessed
from corollary.answers.question import Question
from corollary.answers.remade import remade
from corollary.answers.tolerance import (
    ENOUGH,
    NEAR,
    ROUNDING_NOISE,
    coarse,
    coarse_polar,
    last_place,
    same_signs,
    within,
)
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.formula.ast import names
from corollary.messages import catalogue
from corollary.units.unit import CALLED, ONE, Unit, kind, show

_ = catalogue(__name__)

LARGE_COUNT = 1e5
EXACT = 1e-9  # relative: what a calculation leaves
LITTLE_OFF = 0.05
MOST_MOVED, LEAST_MOVED = (
    0.2,
    0.02,
)  # of what follows, and of what is right: further off, no rounding is believed


def judge_numbers(answer: Numbers, wanted: Quantity, question: Question) -> Verdict:
    """What a good marker says of these numbers.

    Temperatures are compared as they are asked for, in °C: how near 20 °C and 21 °C are is not asked of 293 K and 294 K. They
    are rounded as they are written: in whole kelvins 20 °C are 293 K.
    """
    if question.unit.offset:
        moved, scale = replace(question, unit=replace(question.unit, offset=Fraction(0))), question.unit
        zeros = answer.zeros or (float(scale.offset),) * len(answer.values)
        above = replace(answer, values=_above(answer.values, scale), zeros=_above(zeros, scale))
        return judge_numbers(above, _from_zero(wanted, scale), moved)
    if answer.in_words:
        return _in_words(answer, wanted, question)
    if answer.missing:
        verdict = judge_numbers(replace(answer, missing=""), wanted, question)
        if not isinstance(verdict, Right) or verdict.note:
            return verdict
        return Right(_("Taken in the unit asked for; a quantity is a number *and* a unit."))
    if answer.misfit:
        return _misfit(answer.misfit, judge_numbers(replace(answer, misfit=""), wanted, question))
    if _meets(answer, wanted, wanted.values):
        return Right(_exact_value(answer, wanted))
    ways = list(wanted.follow_through())
    turned: list[FollowThrough] = []
    for way in _leading_to(answer, wanted, ways):
        if not way.earlier:
            return Right()
        if not _has_a_sign_turned(answer, way, question):
            return Follows(way.earlier)
        turned.append(way)
    few = _coarse(answer, wanted, question, wanted.values)
    if few >= ENOUGH:
        return Right()
    if few > 1:
        if not _fits_misconception(answer, wanted, question, ways):
            note = _("Right, but coarse: {figures} figures are few; give three.", figures=few)
            return Right(note, leniently=True)
        return Slip(_("Rounded too far to tell: give three significant figures."), once=False)
    for way in ways:
        for value, sentence in way.misconceptions() if way.misconceptions else ():
            if _meets(answer, wanted, value):
                return Mistaken(sentence, way.earlier, nothing=not any(value))
    if turned:
        return Wrong(
            _(
                "This is what your answer in {parts} gives when one term has the wrong sign: look at what is added and what is taken away.",
                parts=_(" and ").join(f"({part})" for part in turned[0].earlier),
            )
        )
    for way in ways:
        if way.earlier and _coarse(answer, wanted, question, way.values) > 1:
            return Follows(way.earlier)
    if few:  # one figure says hardly more than a guess
        return Slip(_("Rounded too far to tell: give three significant figures."), once=False, nothing=True)
    for way in _distinct(ways):
        for value, sentence in slips(way.values, question.unit, question.title, wanted.signed):
            if any(value) and _meets(answer, wanted, value):
                factor = common_factor(value, way.values)
                if are_round(value, question.unit, counted=wanted.counted):
                    continue  # of 45° it would be wrong to say that a factor of 90° is missing
                guess = _guess(answer, question, value, way.values, counted=wanted.counted)
                return Slip(sentence, nothing=guess, factor=float(f"{factor:.3g}"))
        for value, sentence in way.slips() if way.slips else ():
            if any(value) and _meets(answer, wanted, value):
                return Slip(
                    sentence,
                    nothing=_guess(answer, question, value, way.values, counted=wanted.counted),
                )
    return Wrong(_hint(answer, wanted, question))


def _leading_to(answer: Numbers, wanted: Quantity, ways: Sequence[FollowThrough]) -> Iterator[FollowThrough]:
    """The ways that give what was typed; then those from earlier answers that give it where nothing was rounded."""
    yield from (way for way in ways if _meets(answer, wanted, way.values))
    carried = {(way.values, way.earlier): way for way in ways if way.earlier}.values()
    yield from (way for way in carried if _meets_unrounded(answer, wanted, way))


def _exact_value(answer: Numbers, wanted: Quantity) -> str:
    """What is said beside a right number that was rounded on the way though the laws give a whole one, whatever the numbers."""
    target = wanted.values[0]
    if (
        len(wanted.values) > 1
        or wanted.formulas is None
        or names(wanted.formulas[0])
        or not target.is_integer()
    ):
        return ""
    if not target or math.isclose(answer.values[0], target, rel_tol=EXACT):
        return ""
    return _("Right; it is exactly {value} for all numbers.", value=f"{target:g}")


def _above(values: Values, unit: Unit) -> Values:
    """Temperatures above the zero of their scale."""
    return tuple(value - float(unit.offset) for value in values)


def _from_zero(wanted: Quantity, unit: Unit) -> Quantity:
    """The same quantity counted from the zero of its scale."""
    return remade(wanted, lambda values: _above(values, unit))


def _guess(answer: Numbers, question: Question, value: Values, target: Values, *, counted: bool) -> bool:
    sizes: Sequence[float] = answer.sizes or (question.unit.si,) * len(answer.values)
    typed = [x / size for x, size in zip(answer.values, sizes, strict=True)]
    return may_be_guessed(typed, value, target, question.unit, counted=counted)


def _in_words(answer: Numbers, wanted: Quantity, question: Question) -> Verdict:
    """Signs that were given in words: where others would be right for these, a person looks at the words."""
    words, bare = answer.in_words, replace(answer, in_words=())
    verdict = judge_numbers(bare, wanted, question)
    if isinstance(verdict, (Right, Follows)):
        return verdict
    turns = (turn for count in range(1, len(words) + 1) for turn in combinations(words, count))
    signed = (
        replace(bare, values=tuple(-x if place in turn else x for place, x in enumerate(answer.values)))
        for turn in turns
    )
    if not any(isinstance(judge_numbers(each, wanted, question), (Right, Follows)) for each in signed):
        return verdict
    return Unmarked(
        _(
            "The size is right; your teacher will read your words on the direction: {answer}.",
            answer=answer.as_read,
        )
    )


def _misfit(why: str, verdict: Verdict) -> Verdict:
    """A wrong unit is a slip on a right number, is told by a known misconception, and settles everything else."""
    match verdict:
        case Right() | Follows():
            return Slip(_("The number is right, but not its unit: {why}.", why=why))
        case Mistaken():
            return verdict
        case _:
            return Wrong(f"{why[0].upper()}{why[1:]}.")


def _meets(answer: Numbers, wanted: Quantity, target: Values) -> bool:
    """Within the tolerance of the target's length, every component pointing the right way; zero but for what calculating leaves."""
    if not any(target):
        if _is_zero(answer, wanted):
            return True
        if any(wanted.values):
            return False
    return within(answer.values, target, wanted.tolerance, _length(target, wanted)) and same_signs(
        answer.values, target, wanted.uncertain
    )


def _meets_unrounded(answer: Numbers, wanted: Quantity, way: FollowThrough) -> bool:
    """Whether an answer lies where the earlier ones lead with the figures that were not written down."""
    length = math.hypot(*way.values)
    most = max(MOST_MOVED * length, LEAST_MOVED * wanted.scale)
    near = wanted.tolerance * length
    if way.moved is None or not within(answer.values, way.values, 0.0, 0.0, near + most):
        return False
    reach = sum(math.dist(moved, way.values) for moved in way.moved())
    return within(answer.values, way.values, 0.0, 0.0, near + min(reach, most))


def _has_a_sign_turned(answer: Numbers, way: FollowThrough, question: Question) -> bool:
    """Whether the way leads to just what was typed when one term has the other sign, and as it stands does not."""
    sizes: Sequence[float] = answer.sizes or (question.unit.si,) * len(answer.values)
    halves = [
        0.5 * last_place(value, figures, size) if value and figures else EXACT * abs(value)
        for value, figures, size in zip(answer.values, answer.figures, sizes, strict=True)
    ]

    def is_typed(values: Values) -> bool:
        triples = zip(answer.values, values, halves, strict=True)
        return all(abs(x - y) <= half * (1 + EXACT) for x, y, half in triples)

    return way.turned is not None and not is_typed(way.values) and any(map(is_typed, way.turned()))


def _is_zero(answer: Numbers, wanted: Quantity) -> bool:
    """Whether it is 0 but for the noise of a calculation: a small number is none."""
    residue = ROUNDING_NOISE * wanted.scale if any(wanted.values) else max(wanted.residue, default=0.0)
    return within(answer.values, (0.0,) * len(answer.values), 0.0, 0.0, residue)


def _length(target: Values, wanted: Quantity) -> float:
    """What a tolerance is relative to: the length of the target, or the part's own scale where that is zero."""
    return math.hypot(*target) or wanted.scale


def _coarse(answer: Numbers, wanted: Quantity, question: Question, target: Values) -> int:
    """How many figures were written, where they are too few to tell the answer from the target; else 0."""
    unit = question.unit.si
    sizes: Sequence[float] = answer.sizes or (unit,) * len(target)
    near = NEAR * wanted.tolerance
    if answer.polar is not None:
        return coarse_polar(answer.values, answer.polar, target, sizes[0], near)
    if not all(answer.figures):
        return 0
    zeros: Sequence[float] = answer.zeros or (float(question.unit.offset),) * len(target)
    enough = near * _length(target, wanted) if len(target) > 1 else 0.0
    counts = (answer.most, answer.figures) if answer.most else (answer.figures,)
    found = (coarse(answer.values, count, target, sizes, (enough,) * len(target), zeros) for count in counts)
    few = next(filter(None, found), 0)
    return few if not wanted.counted or (few >= ENOUGH and _rounded_by_all(target)) else 0


def _rounded_by_all(counts: Values) -> bool:
    """Whether whole numbers are so large that nobody writes out their digits."""
    return all(abs(count) >= LARGE_COUNT for count in counts)


def _fits_misconception(
    answer: Numbers, wanted: Quantity, question: Question, ways: Sequence[FollowThrough]
) -> bool:
    """Whether so few figures fit a known misconception as well."""
    return any(
        _coarse(answer, wanted, question, value)
        for way in ways[:1]
        for value, _sentence in (way.misconceptions() if way.misconceptions else ())
    )


def _distinct(ways: Iterable[FollowThrough]) -> Iterable[FollowThrough]:
    first: dict[Values, FollowThrough] = {}
    for way in ways:
        if way.slips:
            first.setdefault(way.values, way)
    return first.values()


def _hint(answer: Numbers, wanted: Quantity, question: Question) -> str:
    """What may be said without giving the value away."""
    sort, unit = kind(question.unit), show(question.unit)
    if any(value < 0 and not has for value, has in zip(answer.values, wanted.signed, strict=False)):
        return _("This cannot be negative: what is asked for is never below zero.")
    if len(answer.values) == 1 and wanted.values[0] and answer.values[0]:
        ratio = answer.values[0] / wanted.values[0]
        if abs(ratio) > 100 or abs(ratio) < 0.01:
            if question.unit.dimension == ONE:
                return _("A number of this size cannot be right here: look at what is divided by what.")
            if question.unit.dimension not in CALLED:
                return _("The size cannot be right: look at powers of ten and units.")
            return _("The size cannot be right for {sort} here: look at powers of ten and units.", sort=sort)
        if ratio < 0 and abs(ratio + 1) > LITTLE_OFF:
            return _("Neither the sign nor the size fits.")
        if abs(ratio - 1) < LITTLE_OFF:
            return _of_little_off(answer, wanted)
    if len(answer.values) > 1 and question.components:
        off = wanted.tolerance * wanted.scale
        triples = zip(question.components, answer.values, wanted.values, strict=True)
        right = [name for name, x, target in triples if abs(x - target) <= off]
        if len(right) == len(answer.values):
            return _of_little_off(answer, wanted)
        if right:
            return _components_fit(right, len(answer.values) - len(right))
    if (
        unit
        and not question.unit.is_angle
        and (question.unit.dimension == ONE or question.unit.dimension not in CALLED)
    ):
        return _("Read in {unit}; it does not follow from the numbers given.", unit=unit)
    if unit:
        return _("Read as {sort} in {unit}; it does not follow from the numbers given.", sort=sort, unit=unit)
    return _("Read as {sort}; it does not follow from the numbers given.", sort=sort)


def _of_little_off(answer: Numbers, wanted: Quantity) -> str:
    """What is said where an answer is hardly off."""
    if wanted.counted:
        return _("Close, but this is counted, not measured: it is a whole number, and exact.")
    if wanted.explained_by_rounding(answer.values):
        return _("Close: carry four figures on the way and round at the end.")
    return _("Close, but rounding does not explain it: look for a small term, or a number put in wrongly.")


def _components_fit(right: Sequence[str], others: int) -> str:
    first, last = ", ".join(right[:-1]), right[-1]
    if not first and others == 1:
        return _("Component {name} fits; look at the other again.", name=last)
    if not first:
        return _("Component {name} fits; look at the others again.", name=last)
    if others == 1:
        return _("Components {names} and {name} fit; look at the other again.", names=first, name=last)
    return _("Components {names} and {name} fit; look at the others again.", names=first, name=last)
