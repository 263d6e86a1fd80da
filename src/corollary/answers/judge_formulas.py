"""The verdict on formulas: decided at random points of the problem's own domain, never by their looks."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.answers.answer import Formulas, Numbers
from corollary.answers.equality import Different, Equal, Undecided, compare, hint
from corollary.answers.evaluation import number
from corollary.answers.expected import Point, Quantity, Values
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.tolerance import within
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.formula.ast import Expr, Name, Number, names, walk
from corollary.formula.ball import Undefined
from corollary.formula.degrees import in_degrees
from corollary.formula.numerals import decimal_text
from corollary.messages import catalogue, in_convention
from corollary.units.unit import show

_ = catalogue(__name__)

EXACTLY = 1e-6
LEAST_SEEN = 0.01  # of the answer: what four figures show


def judge_formulas(
    answer: Formulas, wanted: Quantity, question: Question, *, in_symbols: bool = False
) -> Verdict:
    """Component by component against the closed form, by its value where numbers stand in it, then against known misconceptions.

    `in_symbols`: a formula is asked for, so that numbers in it are not enough.
    """
    if wanted.formulas is None:
        return Unmarked(_("This answer has no formula to compare yours with, so your teacher will mark it."))
    where = wanted.domain()
    found = [compare(tree, right, where) for tree, right in zip(answer.trees, wanted.formulas, strict=True)]
    if all(isinstance(each, Equal) for each in found):
        return Right()
    if any(isinstance(each, Undecided) for each in found):
        return Unmarked(
            _("The program could not decide whether this formula is right, so your teacher will mark it.")
        )
    if not in_symbols and (verdict := _by_value(answer, wanted, wanted.formulas, question)) is not None:
        return verdict
    for wrong, sentence in wanted.wrong_formulas():
        pairs = zip(answer.trees, wrong, strict=True)
        if all(isinstance(compare(tree, other, where), Equal) for tree, other in pairs):
            return Mistaken(sentence)
    place, first = next((place, each) for place, each in enumerate(found) if isinstance(each, Different))
    if slip := hint(first, signed=not wanted.signed or wanted.signed[place]):
        return Slip(f"{slip[0].upper()}{slip[1:]}.")
    return Wrong(_with_own_numbers(answer, wanted, question) or _at_point(first))


def _with_own_numbers(answer: Formulas, wanted: Quantity, question: Question) -> str:
    """What the formula comes to with the numbers of the sheet, where that is not what the laws give; else empty."""
    for place, tree in enumerate(answer.trees):
        found = values_of((tree,), wanted.givens())
        length = math.hypot(*wanted.values)
        if (
            found is None
            or abs(found[0] - wanted.values[place]) <= max(wanted.tolerance, LEAST_SEEN) * length
        ):
            continue
        letters, at = names(tree), wanted.givens()
        numbers = [
            f"`{each.name}` = {_short(number(Name(each.name), at) / each.unit.si)} {show(each.unit)}".strip().replace(
                " °", "°"
            )
            for each in question.symbols
            if each.name in letters and not each.unit.offset
        ]
        value = f"{_short(found[0] / question.unit.si)} {show(question.unit)}".strip()
        if numbers:
            return _(
                "With {numbers} your formula gives {value}; the laws give another value.",
                numbers=in_convention(", ".join(numbers)),
                value=in_convention(value),
            )
    return ""


def _short(value: float) -> str:
    """Four figures at most, without zeros at the end."""
    text = decimal_text(value, 4)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def _at_point(found: Different) -> str:
    point = ", ".join(f"{name} = {value:.4g}" for name, value in sorted(found.point.items()))
    return _("Your formula and the laws differ, for example at {point} (SI).", point=in_convention(point))


def values_of(trees: tuple[Expr, ...], givens: Point) -> Values | None:
    """What the student's formulas come to with the student's numbers; None where they have no value."""
    try:
        return tuple(number(tree, givens) for tree in trees)
    except Undefined:
        return None


def _by_value(
    answer: Formulas, wanted: Quantity, formulas: tuple[Expr, ...], question: Question
) -> Verdict | None:
    """Right where only some letters were put in as numbers, or where it follows from earlier answers; else None."""
    if all(names(mine) <= names(right) | {"pi"} for mine, right in zip(answer.trees, formulas, strict=True)):
        return _numbers_put_in(answer, wanted, formulas, question)
    values = values_of(answer.trees, wanted.givens())
    verdict = judge_numbers(_as_numbers(values, answer), wanted, question) if values is not None else None
    return verdict if isinstance(verdict, Follows) else None


def _numbers_put_in(
    answer: Formulas, wanted: Quantity, formulas: tuple[Expr, ...], question: Question
) -> Right | None:
    """`m v cos(30°)`, `L/9`: right when the letters left out were put in as numbers, exactly or as decimals."""
    pairs = zip(answer.trees, formulas, strict=True)
    if not any(names(right) - names(mine) - {"pi"} for mine, right in pairs):
        return None
    decimals = any(isinstance(node, Number) and node.figures for tree in answer.trees for node in walk(tree))
    alone = replace(wanted, follow_through=wanted.routes)
    for trees in (answer.trees, tuple(map(in_degrees, answer.trees))):
        values = values_of(trees, wanted.givens())
        if values is None or not (decimals or within(values, wanted.values, EXACTLY, wanted.scale)):
            continue
        if isinstance(judge_numbers(_as_numbers(values, answer), alone, question), Right):
            return Right("" if trees == answer.trees else _("Right. (Write 30° where degrees are meant.)"))
    return None


def _as_numbers(values: Values, answer: Formulas) -> Numbers:
    return Numbers(values, (0,) * len(values), answer.as_read)
