"""A proof judged: every line true, none empty, the first a law, the last what was to be shown; and samples."""

from __future__ import annotations

import random
from collections.abc import Sequence

from corollary.answers.answer import Answer, Chain
from corollary.answers.evaluation import as_exact, holds_nearly, number
from corollary.answers.expected import Expected, Point
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Mistaken, Right, Unmarked, Verdict, Wrong
from corollary.formula.ast import Name, Negative, Relation, Sum, names
from corollary.formula.ball import RationalPi, Undefined
from corollary.formula.text import text
from corollary.messages import catalogue

_ = catalogue(__name__)

EXACT = 1e-9  # relative: doubles lose some seven digits on the way through a derivation at worst
SECANTS = 60


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Checked at points where all laws hold (for truth) and at points where none does (for content).

    That each line *follows* from the one before is taken from this: it is true wherever the laws are, and says something.
    """
    assert isinstance(answer, Chain)
    claim = expected.claim
    assert claim is not None
    lawful = claim.points()
    for place, line in enumerate(answer.lines, 1):
        if not all(_true(line, point) for point in lawful):
            for wrong, sentence in claim.wrong:
                if _equivalent(line, wrong, lawful):
                    return Mistaken(sentence)
            return Wrong(_("Line {place} does not hold: {line}.", place=place, line=text(line)))
        if all(_true(line, point) for point in _lawless_points(lawful)):
            return Wrong(_("Line {place} says nothing: it is true whatever the quantities are.", place=place))
    first, last = answer.lines[0], answer.lines[-1]
    if not any(_equivalent(first, law, lawful) for law in claim.laws):
        return Wrong(_("Begin with a law, as the first line, before anything is put in or left out."))
    if not _equivalent(last, claim.target, lawful):
        return Wrong(_("The last line is true, but it is not yet what was to be shown."))
    if len(answer.lines) < 2:
        return Wrong(_("One line is a claim; a proof shows the way from a law to it."))
    if _leaps(answer.lines, claim.laws, claim.target, lawful):
        return Unmarked(
            _(
                "Every line holds, but the way from the law to the last line is not written down; a person will look at it."
            )
        )
    return Right(_("Every line holds, from the law to what was to be shown."))


def _leaps(
    lines: Sequence[Relation], laws: Sequence[Relation], target: Relation, lawful: Sequence[Point]
) -> bool:
    """Whether nothing stands between some of the laws and the claim: no step, and not every law that it takes."""
    written = {text(line): line for line in lines}.values()
    if len(written) > len(laws) + 1:
        return False
    steps = [line for line in written if text(line) not in (text(lines[-1]), text(target))]
    stated = [[_equivalent(step, law, lawful) for law in laws] for step in steps]
    return all(map(any, stated)) and not all(
        any(each[place] for each in stated) for place in range(len(laws))
    )


def _lawless_points(lawful: Sequence[Point]) -> list[Point]:
    """The same letters, each moved on its own, so that no law holds any more but by chance."""
    dice = random.Random(7)
    return [
        {
            name: RationalPi(value.ratio * (1000 + dice.randint(50, 900)) / 1000, value.pi)
            for name, value in point.items()
        }
        for point in lawful
    ]


def _true(line: Relation, point: Point) -> bool:
    try:
        return holds_nearly(line, point, EXACT)
    except Undefined:
        return False


def _equivalent(line: Relation, other: Relation, lawful: Sequence[Point]) -> bool:
    """Whether two equations say the same: where the letter they share is changed so that one holds, the other holds too.

    The other equation is solved for that letter at lawless points.
    """
    for letter in sorted(names(other) & names(line)):
        checks = [_solved(other, letter, point) for point in _lawless_points(lawful)]
        solved = [point for point in checks if point is not None]
        if len(solved) == len(checks) and solved:
            return all(_true(line, point) for point in solved)
    return False


def _solved(equation: Relation, letter: str, point: Point) -> Point | None:
    """The point with one letter changed so that the equation holds, found by secants; None where none is found."""
    difference = Sum((equation.left, Negative(equation.right)))

    def at(value: float) -> float:
        return number(difference, {**point, letter: as_exact(value)})

    try:
        before = number(Name(letter), point)
        here, low, high = 1.3 * before, at(before), at(1.3 * before)
        for _step in range(SECANTS):
            if low == high:
                break
            before, here, low = here, here - high * (here - before) / (high - low), high
            high = at(here)
        if abs(here) < EXACT * abs(number(Name(letter), point)):
            return None  # a common factor of both sides set to zero makes any equation hold
        changed = {**point, letter: as_exact(here)}
        return changed if holds_nearly(equation, changed, EXACT) else None
    except (Undefined, OverflowError):
        return None


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` holds a right chain, one equation a line."""
    assert isinstance(truth, str)
    lines = truth.splitlines()
    return (
        Sample(lines, "right"),
        Sample(["1 = 1", lines[-1]], "wrong"),
        Sample([*lines[:-1], "0 = 1"], "wrong"),
        Sample(["so it is"], "unread"),
        Sample(4, "unread"),
        Sample(None, "unread"),
    )
