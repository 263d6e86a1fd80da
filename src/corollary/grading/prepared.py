"""What `corollary.answers.prepared` judges by, as plain data, worked out for one part of a key."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from corollary.answers.expected import FollowThrough, Quantity, Values
from corollary.grading.expected import expected_of
from corollary.grading.key import Key
from corollary.problem.part import Part

WITH_NUMBERS = ("value", "vector")
Pairs = Callable[[], Iterable[tuple[Values, str]]]


def prepared(key: Key, part: Part) -> dict[str, Any] | None:
    """None for a part that takes more to judge than numbers and letters: a formula, a proof, a program, words.

    Numbers are in SI. A part whose values a double does not hold is none either.
    """
    expected = expected_of(key, part)
    question = expected.question.as_data()
    if part.answer_types == ("choice",) and expected.option is not None:
        return {
            "question": question,
            "letter": expected.option.letter,
            "overlooked": dict(expected.option.misconceptions),
        }
    if len(part.answer_types) == 1 and part.answer_type in WITH_NUMBERS and expected.quantity is not None:
        return _of_numbers(expected.quantity, question)
    return None


def _of_numbers(quantity: Quantity, question: dict[str, Any]) -> dict[str, Any] | None:
    if not all(map(math.isfinite, (*quantity.values, quantity.scale))):
        return None
    return {
        "question": question,
        "values": quantity.values,
        "scale": quantity.scale,
        "tolerance": quantity.tolerance,
        "uncertain": quantity.uncertain,
        "ways": [_way(each) for each in quantity.routes() if all(map(math.isfinite, each.values))],
    }


def _way(way: FollowThrough) -> dict[str, Any]:
    return {
        "values": way.values,
        "misconceptions": _pairs(way.misconceptions),
        "slips": _pairs(way.slips),
    }


def _pairs(pairs: Pairs | None) -> list[tuple[Values, str]] | None:
    return None if pairs is None else [each for each in pairs() if all(map(math.isfinite, each[0]))]
