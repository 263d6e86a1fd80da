"""Equality of two formulas: evaluated with certainty at random points, equal at all or different at one."""

from __future__ import annotations

import hashlib
import random
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Literal

from flint import arb

from corollary.answers.common_errors import ratio_of_formulas
from corollary.formula.arithmetics import constant
from corollary.formula.ast import Call, Expr, Power, names, walk
from corollary.formula.ball import Undefined, evaluate
from corollary.formula.functions import FUNCTIONS
from corollary.formula.plain_text import text

POINTS, POINTS_WITH_BRANCHES, MOST_DRAWN = 5, 40, 400
BITS_TO_AGREE = 320
BITS = (64, BITS_TO_AGREE, 640, 1280, 2560)  # a difference mostly shows at once
AGREED = arb(2) ** -200
NEARLY_ZERO = arb(2) ** -1000
POSITIVE = (0.1, 10.0)

Seen = Literal["equal", "different", "undecided", "nowhere"]


@dataclass(frozen=True, slots=True)
class Equal:
    """The same at every point tried."""


@dataclass(frozen=True, slots=True)
class Different:
    """Not the same: at `point` they certainly differ. `ratio` is student over truth, where it is the same everywhere."""

    point: Mapping[str, float]
    ratio: float | None


@dataclass(frozen=True, slots=True)
class Undecided:
    """Neither could be shown; a person looks at it."""

    why: str


def compare(
    student: Expr, truth: Expr, domain: Mapping[str, tuple[float, float]]
) -> Equal | Different | Undecided:
    """Decides on the box `domain`; letters it does not name are taken positive. The points depend on the formulas only.

    Different is proven (balls that do not meet, or no value where the truth has one); equal means closer than 2^-200 at
    every point, 40 points where absolute values, even roots or choices occur, 5 elsewhere.
    """
    wanted = POINTS_WITH_BRANCHES if _branches(student) or _branches(truth) else POINTS
    agreed = 0
    for point in _points(student, truth, domain):
        values = {name: arb(value) for name, value in point.items()}  # a double is exact as a ball
        match _at(student, truth, values, BITS[1:] if agreed else BITS):
            case "nowhere":
                continue
            case "equal":
                agreed += 1
                if agreed == wanted:
                    return Equal()
            case "different":
                return Different(
                    point, _ratio(student, truth, (point, *islice(_points(student, truth, domain), 2)))
                )
            case "undecided":
                return Undecided("the two formulas are closer than can be told apart at one point")
    return Undecided("too few points were found where the formulas have values")


def hint(difference: Different, *, signed: bool = True) -> str:
    """What the constant ratio between the two tells: a sign (of what is `signed`), a factor 2, a unit; "" where it tells nothing."""
    return "" if difference.ratio is None else ratio_of_formulas(difference.ratio, signed=signed)


def _branches(tree: Expr) -> bool:
    """Whether an absolute value, an even root or a choice occurs: two such formulas can agree on one side only."""
    for node in walk(tree):
        if isinstance(node, Call) and FUNCTIONS[node.function].branches:
            return True
        if isinstance(node, Power) and (
            (power := constant(node.exponent)) is None or power.denominator % 2 == 0
        ):
            return True
    return False


def _points(
    student: Expr, truth: Expr, domain: Mapping[str, tuple[float, float]]
) -> Iterator[dict[str, float]]:
    letters = sorted((names(student) | names(truth)) - {"pi"})
    written = f"{text(student)} = {text(truth)}"
    draw = random.Random(int.from_bytes(hashlib.blake2b(written.encode(), digest_size=16).digest(), "big"))
    for _ in range(MOST_DRAWN):
        yield {name: _between(*domain.get(name, POSITIVE), draw.random()) for name in letters}


def _between(low: float, high: float, share: float) -> float:
    return low + (high - low) * share


def _at(student: Expr, truth: Expr, values: Mapping[str, arb], precisions: tuple[int, ...]) -> Seen:
    """What is seen at one point; "nowhere" when the truth has no value there."""
    for bits in precisions:
        try:
            right = evaluate(truth, values, bits)
        except Undefined:
            return "nowhere"
        try:
            given = evaluate(student, values, bits)
        except Undefined:
            if right.is_finite():
                return "different"
            continue
        if not given.overlaps(right):
            return "different"
        if bits >= BITS_TO_AGREE and given.is_finite() and right.is_finite() and _agree(given, right):
            return "equal"
    return "undecided"


def _agree(given: arb, right: arb) -> bool:
    size = abs(right).lower()
    if size > 0:
        return bool(abs(given - right) < AGREED * size)
    return bool(abs(given) < NEARLY_ZERO and abs(right) < NEARLY_ZERO)


def _ratio(student: Expr, truth: Expr, points: Iterable[Mapping[str, float]]) -> float | None:
    """Student over truth, when it is the same at all points and not 1."""
    found: list[float] = []
    for point in points:
        values = {name: arb(value) for name, value in point.items()}
        try:
            ratio = evaluate(student, values, BITS_TO_AGREE) / evaluate(truth, values, BITS_TO_AGREE)
        except Undefined:
            return None
        if not ratio.is_finite():
            return None
        found.append(float(ratio))
    same = max(found) - min(found) <= 1e-12 * abs(found[0])
    return found[0] if same and found[0] not in (0.0, 1.0) else None
