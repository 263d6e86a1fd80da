"""A formula of a variable with the student's own numbers in it, `12*(1 - exp(-t/1.03))`, compared along the variable's domain."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from corollary.answers.answer import Formulas
from corollary.answers.common_errors import ratio_of_formulas
from corollary.answers.evaluation import as_exact, number
from corollary.answers.expected import Quantity
from corollary.answers.formula import dimension_in
from corollary.answers.question import Question
from corollary.answers.verdict import Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr
from corollary.formula.errors import Undefined
from corollary.formula.numerals import decimal_text
from corollary.messages import catalogue, in_convention
from corollary.units.unit import show

_ = catalogue(__name__)

PLACES = 24  # along the domain
SPREAD = (
    0.5,
    0.7548776662466927,
    0.5698402909980532,
)  # shares by which the places of several variables go on
ALLOWED = 0.01  # of the largest value: the usual half per cent, and numbers rounded to three figures
STEADY = 0.02  # relative: a quotient that changes by less along the domain is a factor


def has_own_numbers(answer: Formulas, question: Question) -> bool:
    """True if the letters are variables only, and numbers stand for the givens: in letters alone it would measure something else."""
    return bool(question.variables) and any(
        dimension_in(tree, question) != question.unit.dimension for tree in answer.trees
    )


def judge_in_numbers(answer: Formulas, wanted: Quantity, question: Question) -> Verdict:
    """Against the laws with the numbers of the sheet, then against known misconceptions with these."""
    if wanted.formulas is None:
        return Unmarked(_("This answer has no formula to compare yours with, so your teacher will mark it."))
    places = list(_places(question))
    truth = _along(wanted.formulas, wanted, places)
    own = [_own(answer.trees, question, at) for at in places]
    if any(each is None for each in truth):
        return Unmarked(
            _("The program could not decide whether this formula is right, so your teacher will mark it.")
        )
    if _alike(own, truth):
        return Right()
    for wrong, sentence in wanted.wrong_formulas():
        if _alike(own, _along(wrong, wanted, places)):
            return Mistaken(sentence)
    if (ratio := _ratio(own, truth)) is not None and (slip := ratio_of_formulas(ratio)):
        return Slip(f"{slip[0].upper()}{slip[1:]}.")
    return Wrong(_farthest(own, truth, places, question))


Row = tuple[float, ...] | None
"""A value for each component at one place; None where there is none."""


def _places(question: Question) -> Sequence[Mapping[str, float]]:
    """Values of the variables in SI, spread over the domain."""
    return [
        {
            name: low + (high - low) * ((place + 0.5) * share * (2 if index else 2 / PLACES) % 1.0)
            for index, ((name, low, high), share) in enumerate(zip(question.variables, SPREAD, strict=False))
        }
        for place in range(PLACES)
    ]


def _along(trees: Sequence[Expr], wanted: Quantity, places: Sequence[Mapping[str, float]]) -> list[Row]:
    """What formulas come to at each place with the numbers of the sheet."""
    found: list[Row] = []
    for at in places:
        letters = {**wanted.givens(), **{name: as_exact(value) for name, value in at.items()}}
        try:
            found.append(tuple(number(tree, letters) for tree in trees))
        except Undefined:
            found.append(None)
    return found


def _own(trees: Sequence[Expr], question: Question, at: Mapping[str, float]) -> Row:
    """What the student's formulas come to, in SI: they have each variable in its own unit, and the result in the part's."""
    letters = {each.name: each.unit.from_si(at[each.name]) for each in question.symbols if each.name in at}
    try:
        values = tuple(float(ready(tree, DOUBLES)(letters)) * question.unit.si for tree in trees)
    except (ArithmeticError, ValueError, KeyError):
        return None
    return values if all(map(math.isfinite, values)) else None


def _alike(own: Sequence[Row], truth: Sequence[Row]) -> bool:
    """True if they are as near as rounded numbers are, all along the domain."""
    size = max((abs(value) for row in truth if row for value in row), default=0.0)
    return all(
        mine is not None
        and theirs is not None
        and all(abs(x - y) <= ALLOWED * size for x, y in zip(mine, theirs, strict=True))
        for mine, theirs in zip(own, truth, strict=True)
    )


def _ratio(own: Sequence[Row], truth: Sequence[Row]) -> float | None:
    """Own over true where that is the same along the domain; a power of ten or a small number, made exact."""
    size = max((abs(value) for row in truth if row for value in row), default=0.0)
    quotients = [
        x / y
        for mine, theirs in zip(own, truth, strict=True)
        for x, y in zip(mine or (), theirs or (), strict=False)
        if abs(y) > ALLOWED * size
    ]
    if not quotients or None in own or max(quotients) - min(quotients) > STEADY * abs(quotients[0]):
        return None
    middle = quotients[len(quotients) // 2]
    if not middle:
        return None
    power = 10.0 ** round(math.log10(abs(middle)))
    exact = next(
        (
            each
            for each in (math.copysign(power, middle), float(round(middle)), 1 / (round(1 / middle) or 1))
            if math.isclose(each, middle, rel_tol=ALLOWED)
        ),
        None,
    )
    return None if exact in (None, 1.0, 0.0) else exact


def _farthest(
    own: Sequence[Row], truth: Sequence[Row], places: Sequence[Mapping[str, float]], question: Question
) -> str:
    """Where the formula is farthest from the laws, and what it gives there."""
    distances = [
        max(abs(x - y) for x, y in zip(mine, theirs, strict=True)) if mine and theirs else -1.0
        for mine, theirs in zip(own, truth, strict=True)
    ]
    place = max(range(len(places)), key=distances.__getitem__)
    values = own[place]
    if values is None:
        return ""
    at = ", ".join(
        f"`{each.name}` = {_quantity(each.unit.from_si(places[place][each.name]), show(each.unit))}"
        for each in question.symbols
        if each.name in places[place]
    )
    numbers = ", ".join(_quantity(value / question.unit.si, show(question.unit)) for value in values)
    return _(
        "With {numbers} your formula gives {value}; the laws give another value.",
        numbers=in_convention(at),
        value=in_convention(numbers),
    )


def _quantity(value: float, symbol: str) -> str:
    return f"{decimal_text(value, 3) if value else '0'} {symbol}".rstrip()
