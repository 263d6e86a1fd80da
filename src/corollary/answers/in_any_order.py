"""Numbers and formulas whose order says nothing: judged the smallest first, or in whichever order fits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import permutations
from typing import TypeVar

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import FollowThrough, Quantity, Values
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.remade import remade
from corollary.answers.verdict import Right, Verdict

T = TypeVar("T")
MOST_FORMULAS = 4  # whose orders are tried: 24


def judge_in_any_order(answer: Answer, wanted: Quantity, question: Question) -> Verdict:
    """The verdict on as many numbers, or formulas, as there are components, whatever their order."""
    match answer:
        case Numbers():
            return judge_numbers(rising(answer), _rising(of_length(wanted, len(answer.values))), question)
        case Formulas(trees):
            orders = permutations(trees) if len(trees) <= MOST_FORMULAS else [trees]
            found = [judge_formulas(replace(answer, trees=order), wanted, question) for order in orders]
            return next((each for each in found if isinstance(each, Right)), found[0])
        case _:
            raise TypeError(f"numbers or formulas have an order, {type(answer).__name__} has none")


def of_length(wanted: Quantity, count: int) -> Quantity:
    """The same with only those ways, and mistakes on them, that lead to so many values."""

    def same(
        found: Callable[[], Iterable[tuple[Values, str]]] | None,
    ) -> Callable[[], Iterable[tuple[Values, str]]]:
        return lambda: [each for each in (found() if found else ()) if len(each[0]) == count]

    def ways(found: Callable[[], Iterable[FollowThrough]]) -> Callable[[], Iterable[FollowThrough]]:
        return lambda: [
            replace(way, misconceptions=same(way.misconceptions), slips=same(way.slips))
            for way in found()
            if len(way.values) == count
        ]

    return replace(wanted, routes=ways(wanted.routes), follow_through=ways(wanted.follow_through))


def rising(answer: Numbers) -> Numbers:
    """The numbers, the smallest first, each with its figures and the unit it was written in."""
    order = sorted(range(len(answer.values)), key=answer.values.__getitem__)

    def put(several: Sequence[T]) -> tuple[T, ...]:
        return tuple(several[place] for place in order) if len(several) == len(order) else tuple(several)

    return replace(
        answer,
        values=put(answer.values),
        figures=put(answer.figures),
        most=put(answer.most),
        sizes=put(answer.sizes),
        zeros=put(answer.zeros),
        in_words=tuple(sorted(order.index(place) for place in answer.in_words)),
    )


def _rising(wanted: Quantity) -> Quantity:
    order = sorted(range(len(wanted.values)), key=wanted.values.__getitem__)
    uncertain = tuple(wanted.uncertain[place] for place in order)
    signed = tuple(wanted.signed[place] for place in order) if wanted.signed else ()
    return replace(remade(wanted, _sorted), uncertain=uncertain, signed=signed)


def _sorted(values: Values) -> Values:
    return tuple(sorted(values))
