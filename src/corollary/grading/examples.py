"""The verdict on an example: the student's own numbers are put into the laws."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.answers.answer import Numbers
from corollary.answers.verdict import Right, Unread, Verdict, Wrong
from corollary.formula.ast import Expr, Negative, Product, Quotient, Relation, Sum
from corollary.formula.ball import RationalPi, Undefined
from corollary.grading.closeness import within
from corollary.grading.key import Key, named
from corollary.grading.replay import as_exact, number
from corollary.problem.part import Part

TOLERANCE = 0.01


def judge_example(key: Key, part: Part, answer: Numbers) -> Verdict:
    """Right when every law holds to one per cent of its larger side, and it is none of the excluded sets."""
    truth = key.solution.examples[part.id]
    known = key.variant.exact | named(key.solution, list(key.values))
    scale = abs(number(truth.scale, known))
    try:
        mine = known | {name: as_exact(value) for name, value in zip(truth.finds, answer.values, strict=True)}
        for values, why in truth.apart:
            if within(answer.values, tuple(number(tree, known) for tree in values), 2 * TOLERANCE, scale):
                return Wrong(f"No: {why}.")
        broken = [law for law in truth.laws if not all(holds_nearly(relation, mine) for relation in law.here)]
    except Undefined as error:
        return Unread(f"These numbers cannot be put into the laws: {error}")
    if broken:
        return Wrong(
            f"Your numbers do not keep this law: {' and '.join(law.name.lower() for law in broken)}."
        )
    return Right("Every law holds for your numbers.")


def holds_nearly(relation: Relation, values: Mapping[str, RationalPi], tolerance: float = TOLERANCE) -> bool:
    """Whether both sides agree, to the tolerance of what is added up on them before anything cancels."""
    left, right = number(relation.left, values), number(relation.right, values)
    return abs(left - right) <= tolerance * max(_size(relation.left, values), _size(relation.right, values))


def _size(tree: Expr, values: Mapping[str, RationalPi]) -> float:
    """The value with every subtraction made an addition: how large the terms are."""
    match tree:
        case Negative(term):
            return _size(term, values)
        case Sum(terms):
            return sum(_size(term, values) for term in terms)
        case Product(factors):
            return math.prod(_size(factor, values) for factor in factors)
        case Quotient(top, bottom):
            return _size(top, values) / abs(number(bottom, values))
        case _:
            return abs(number(tree, values))
