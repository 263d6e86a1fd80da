"""Answers that the right formulas give when what is worked out on the way is rounded to two figures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms
from corollary.formula.arithmetics import DOUBLES, Arithmetic, Evaluation, NotAvailable, ready
from corollary.formula.ball import Undefined, certified
from corollary.grading.key import Key, Truth
from corollary.grading.unlisted_rules import changes

FIGURES = 2
SAME = 2e-3  # relative: an answer of three figures tells it from another


def explained_by_rounding(key: Key, truth: Truth, values: Values) -> bool:
    """True if the right formulas, rounded to two figures on the way, come to these values, and no formula one change away does."""
    return any(_alike(values, other) for other in _rounded(key, truth)) and not any(
        _alike(values, other) for other in _one_change_away(key, truth)
    )


def _rounded(key: Key, truth: Truth) -> Iterator[Values]:
    """With each step rounded, with each operation rounded, and with either but for the last."""
    for arithmetic in (DOUBLES, replace(DOUBLES, rounded=_by_operation)):
        at = dict(key.variant.letters_in_si)
        for find, exact in zip(key.solution.unknowns[: truth.place + 1], key.values, strict=False):
            values = _evaluated(find.local, arithmetic, at) or exact
            if find is key.find(truth):
                yield values
                yield tuple(map(_shortened, values))
            at.update(zip(find.names, map(_shortened, values), strict=True))


def _evaluated(rule: object, arithmetic: Arithmetic, at: dict[str, float]) -> Values:
    """Nothing where there is no value, or no formula."""
    if not isinstance(rule, ClosedForms):
        return ()
    try:
        return tuple(float(ready(tree, arithmetic)(at)) for tree in rule.trees)
    except (ArithmeticError, ValueError, TypeError, NotAvailable):
        return ()


def _by_operation(step: Evaluation) -> Evaluation:
    return lambda at: _shortened(step(at))


def _shortened(value: float) -> float:
    return float(f"{value:.{FIGURES - 1}e}") if math.isfinite(value) else value


def _one_change_away(key: Key, truth: Truth) -> Iterator[Values]:
    trees = key.find(truth).in_givens
    for change in changes(trees, {}, ()) if trees else ():
        try:
            yield tuple(certified(tree, key.variant.exact).value for tree in change.trees)
        except Undefined:
            continue


def _alike(one: Values, other: Values) -> bool:
    return math.dist(one, other) <= SAME * math.hypot(*one)
