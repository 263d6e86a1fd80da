"""Arguments of floor, ceil and round that lie so near a step that rounding decides the whole number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from corollary.answers.evaluation import BITS
from corollary.formula.arithmetics import exactly
from corollary.formula.ast import Call, Expr, calls, names
from corollary.formula.ball import RationalPi, Undefined, evaluate
from corollary.formula.functions import FUNCTIONS
from corollary.formula.plain_text import text
from corollary.grading.key import Key, named

SHARE, MOST = (
    0.005,
    0.05,
)  # of the argument, and absolute: a number rounded to three figures is off by half a per cent
NOISE = 1e-9  # of the argument: what doubles leave


def near_steps(key: Key) -> Iterator[tuple[str, str]]:
    """The part, or the letters of a find without one, and the argument with its value."""
    known = key.variant.exact | named(key.solution, key.values)
    for find in key.solution.unknowns:
        trees = find.in_givens if find.in_givens is not None else getattr(find.local, "trees", ())
        ends = find.numbering.ends if find.numbering and find.numbering.ends else ()
        for call, value in steps_near((*trees, *ends), known):
            yield find.part or ", ".join(find.names), f"{text(call.arguments[0])} = {value:.6g}"


def steps_near(trees: Iterable[Expr], known: Mapping[str, RationalPi]) -> Iterator[tuple[Call, float]]:
    """The calls of step functions whose argument is too near a step, with its value.

    Exact arithmetic of whole numbers is never near: 8/4 is 2 for everybody. Raises Undefined where an argument has no value.
    """
    for call in dict.fromkeys(
        call for tree in trees for call in calls(tree) if FUNCTIONS[call.function].step
    ):
        argument = call.arguments[0]
        if _of_whole_numbers(argument, known):
            continue
        ball = evaluate(argument, known, BITS)
        if not ball.is_finite():
            raise Undefined(f"{text(argument)} has no value")
        value = float(ball.mid())
        shift = 0.5 if FUNCTIONS[call.function].step == "half" else 0.0
        apart = abs(value + shift - round(value + shift))
        if apart <= max(min(SHARE * abs(value), MOST), NOISE * abs(value), float(ball.rad())):
            yield call, value


def _of_whole_numbers(tree: Expr, known: Mapping[str, RationalPi]) -> bool:
    letters = names(tree)
    whole = all(
        name in known and not known[name].pi and known[name].ratio.denominator == 1 for name in letters
    )
    return whole and exactly(tree, known) is not None
