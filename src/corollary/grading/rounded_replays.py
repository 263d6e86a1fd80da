"""A derivation replayed many times at once, rounded differently each time: arrays of doubles, one element for each replay."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from random import Random

import numpy as np

from corollary.answers.evaluation import ball_of, balls
from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Solution, Unknown, once
from corollary.formula.arithmetics import Arithmetic, Evaluation, arrays, ready
from corollary.formula.ball import Ball, RationalPi, Undefined
from corollary.grading.replay import compute, letters_of

REPLAYS = 32  # with random roundings; what so few of them miss, the key's margin of a quarter is for
FIGURES = 3  # what the book asks for
FINE = 1e-9  # relative: how close doubles must come to the truth for rounding to be seen in them


class _Dice:
    """How far each result lies from what was rounded, in half units of its last figure: a row for each, an element for each replay.

    The same for every variant: fair, and the same in ten years. In the first replay nothing is rounded.
    """

    def __init__(self, seed: int) -> None:
        self.seed, self.count = seed, 0
        self.rows: list[np.ndarray] = []

    def rounded(self, step: Evaluation, zero: float = 0.0) -> Evaluation:
        """What is evaluated, rounded by the next row of the dice; `zero` is that of the scale it is written in."""
        mine = self.count
        self.count += 1
        return lambda at: _off(step(at), self.rows[mine], zero)

    def throw(self) -> None:
        """When it is known how many results are rounded: replay by replay, as somebody would go through them."""
        random = Random(self.seed).random
        thrown = [[-1 + 2 * random() for _ in range(self.count)] for _ in range(REPLAYS)]
        self.rows = list(np.array([[0.0] * self.count, *thrown]).T.copy())


@dataclass(frozen=True, slots=True)
class _Step:
    """An unknown ready to be replayed: its formulas with the answer rounded, and with every operation; none where a scene gives it."""

    find: Unknown
    by_steps: list[Evaluation]
    by_operations: list[Evaluation]
    letters: frozenset[str]
    zero: float
    rows: slice


@dataclass(frozen=True, slots=True)
class _Ready:
    steps: list[_Step]
    dice: _Dice


def rounded_replays(
    solution: Solution, givens: Mapping[str, RationalPi], values: Sequence[Values]
) -> np.ndarray:
    """What every step gives when each before it was rounded, and what it gives when every operation was: both of these by the
    components of all unknowns by replays.

    A replay in which something has no value is left out of both. `values` are those of the unknowns with nothing rounded: where
    doubles miss them, the formula is worked out in balls. What a scene gives nobody works out by hand: both have it from the steps.
    """
    made, exact = _ready(solution), balls(givens)
    by_steps: dict[str, np.ndarray | float] = {name: float(ball) for name, ball in exact.items()}
    by_operations = dict(by_steps)
    stepwise, worked = list[np.ndarray](), list[np.ndarray]()
    with np.errstate(all="ignore"):
        for step, truth in zip(made.steps, values, strict=True):
            answer = _evaluated(step.by_steps, by_steps)
            if not _fine(answer, truth):
                answer = _one_by_one(step, exact, by_steps, truth)
                if step.by_steps:
                    answer = _off(answer, np.array(made.dice.rows[step.rows]), step.zero)
            by_hand = _evaluated(step.by_operations, by_operations) if step.by_operations else answer
            by_steps.update(zip(step.find.names, answer, strict=True))
            by_operations.update(zip(step.find.names, by_hand, strict=True))
            stepwise += [*answer]
            worked += [*by_hand]
    found = np.array([stepwise, worked])[:, :, 1:]
    return found[:, :, np.isfinite(found).all(axis=(0, 1))]


@once
def _ready(solution: Solution) -> _Ready:
    steps, operations, made = _Dice(1), _Dice(2), list[_Step]()
    whole = arrays()
    by_hand = replace(whole, rounded=operations.rounded)
    for find in solution.unknowns:
        trees = find.local.trees if isinstance(find.local, ClosedForms) else ()
        zero, first = _zero_of_scale(solution, find), steps.count
        # Who works in °C does not write down products of kelvins: where the scale has a zero of its own, only the answer.
        written: Arithmetic = whole if zero else by_hand
        made.append(
            _Step(
                find,
                [steps.rounded(ready(tree, whole), zero) for tree in trees],
                [operations.rounded(ready(tree, written), zero) for tree in trees],
                letters_of(find.local),
                zero,
                slice(first, steps.count),
            )
        )
    steps.throw()
    operations.throw()
    return _Ready(made, steps)


def _evaluated(forms: list[Evaluation], at: Mapping[str, np.ndarray | float]) -> np.ndarray:
    """Components by replays; NaN where there is no value. Numbers that are the same in all replays are Python's, and raise."""
    try:
        return np.array([form(at) for form in forms])
    except (ZeroDivisionError, OverflowError):
        return np.full((len(forms), 1 + REPLAYS), math.nan)


def _fine(answer: np.ndarray, truth: Values) -> bool:
    """Whether the first replay, in which nothing is rounded, gives the truth: to what the others make of it."""
    if len(answer) != len(truth):
        return False
    return bool((abs(answer[:, 0] - truth) <= FINE * abs(answer).max()).all())


def _one_by_one(
    step: _Step, givens: Mapping[str, Ball], found: Mapping[str, np.ndarray | float], truth: Values
) -> np.ndarray:
    """What a rule gives in each replay: a formula that doubles are too coarse for, or a scene."""
    answer = np.full((len(truth), 1 + REPLAYS), math.nan)
    known = {name: givens[name] for name in step.letters & givens.keys()}
    rounded = {
        name: value for name, value in found.items() if name in step.letters and isinstance(value, np.ndarray)
    }
    answer[:, : 1 if rounded else None] = np.array(truth)[
        :, None
    ]  # of givens alone it is the truth each time
    for replay in range(1, 1 + REPLAYS) if rounded else ():
        with suppress(Undefined):
            here = {name: ball_of(float(value[replay])) for name, value in rounded.items()}
            values = compute(step.find.local, known | here)
            if len(values) == len(truth):  # a list may have another length
                answer[:, replay] = values
    return answer


def _off(x: np.ndarray | float, dice: np.ndarray, zero: float) -> np.ndarray:
    """Rounded: off by so many half units of the last of the figures written down."""
    size = np.abs(x - zero if zero else x)
    return x + 0.5 * 10.0 ** (np.floor(np.log10(size)) - (FIGURES - 1)) * dice


def _zero_of_scale(solution: Solution, find: Unknown) -> float:
    """The zero of the unit an answer is written in: 20.4 °C are rounded as such, not as 293.55 K."""
    part = next((part for part in solution.problem.parts if part.id == find.part), None)
    return float(part.unit.offset) if part else 0.0
