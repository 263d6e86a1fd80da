"""The verdict on a "show that": every line true, none empty, the first a law, the last what was to be shown."""

from __future__ import annotations

import random
from collections.abc import Sequence

from corollary.answers.answer import Chain
from corollary.answers.verdict import Mistaken, Right, Unmarked, Verdict, Wrong
from corollary.formula.ast import Name, Negative, Relation, Sum, names
from corollary.formula.ball import RationalPi, Undefined
from corollary.formula.text import text
from corollary.grading.examples import holds_nearly
from corollary.grading.key import Key
from corollary.grading.replay import as_exact, number, replay
from corollary.problem.part import Part
from corollary.problem.sampling import sample

EXACT = 1e-9
POINTS = 6
SECANTS = 60
Point = dict[str, RationalPi]


def judge_proof(key: Key, part: Part, answer: Chain) -> Verdict:
    """Checked at points where all laws hold (for truth) and at points where none does (for content).

    That each line *follows* from the one before is taken from this: it is true wherever the laws are, and says something.
    """
    truth = key.solution.proofs[part.id]
    lawful = lawful_points(key)
    for place, line in enumerate(answer.lines, 1):
        if not all(_true(line, point) for point in lawful):
            for mistake in truth.mistakes:
                if any(_equivalent(line, law.here[0], lawful) for law in mistake.rule):
                    return Mistaken(mistake.text)
            return Wrong(f"Line {place} does not hold: {text(line)}.")
        if all(_true(line, point) for point in lawless_points(lawful)):
            return Wrong(f"Line {place} says nothing: it is true whatever the quantities are.")
    first, last = answer.lines[0], answer.lines[-1]
    if not any(_equivalent(first, law, lawful) for stated in truth.laws for law in stated.here):
        return Wrong("Begin with a law, as the first line, before anything is put in or left out.")
    if not _equivalent(last, truth.target.here[0], lawful):
        return Wrong("The last line is true, but it is not yet what was to be shown.")
    if len(answer.lines) < 2:
        return Wrong("One line is a claim; a proof shows the way from a law to it.")
    if _leaps(
        answer.lines, [law for stated in truth.laws for law in stated.here], truth.target.here[0], lawful
    ):
        return Unmarked(
            "Every line holds, but the way from the law to the last line is not written down; a person will look at it."
        )
    return Right("Every line holds, from the law to what was to be shown.")


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


def lawful_points(key: Key) -> list[Point]:
    """Givens drawn anew, with everything found for them: points where every law of the derivation holds."""
    solution, points = key.solution, []
    for variant in sample(key.variant.problem, POINTS, salt="proof"):
        try:
            found = replay(solution, variant.exact)
        except Undefined:
            continue
        finds = {
            name: as_exact(value)
            for find, values in zip(solution.finds, found, strict=True)
            for name, value in zip(find.names, values, strict=True)
        }
        points.append(variant.exact | finds)
    return points


def lawless_points(lawful: Sequence[Point]) -> list[Point]:
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
        checks = [_solved(other, letter, point) for point in lawless_points(lawful)]
        solved = [point for point in checks if point is not None]
        if len(solved) == len(checks) and solved:
            return all(_true(line, point) for point in solved)
    return False


def _solved(equation: Relation, letter: str, point: Point) -> Point | None:
    """The point with one letter changed so that the equation holds, found by secants; None where none is found."""
    difference = Sum((equation.left, Negative(equation.right)))

    def at(value: float) -> float:
        return number(difference, point | {letter: as_exact(value)})

    try:
        before = number(Name(letter), point)
        here, low, high = 1.3 * before, at(before), at(1.3 * before)
        for _ in range(SECANTS):
            if low == high:
                break
            before, here, low = here, here - high * (here - before) / (high - low), high
            high = at(here)
        if abs(here) < EXACT * abs(number(Name(letter), point)):
            return None  # a common factor of both sides set to nought makes any equation hold
        changed = point | {letter: as_exact(here)}
        return changed if holds_nearly(equation, changed, EXACT) else None
    except (Undefined, OverflowError):
        return None
