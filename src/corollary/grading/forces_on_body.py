"""The forces on a body for one student's numbers, and how they are written as an answer."""

from __future__ import annotations

import math

from corollary.answers.evaluation import number
from corollary.answers.expected import FreeBody
from corollary.answers.spellings import main_spelling
from corollary.answers.ways import DEGREES, in_words, of_a_slope
from corollary.derive.solution import SolvedForces
from corollary.formula.ast import Expr
from corollary.problem.part import Part
from corollary.problem.variant import Variant

NONE = 1e-9  # of the largest: a force that comes to nothing


def free_body(stated: SolvedForces, variant: Variant) -> FreeBody:
    """The forces that act: those whose magnitude is negative point the other way. Raises Undefined where one has no value."""
    givens = variant.exact
    sizes = [number(each.magnitude, givens) for each in stated.forces]
    least = NONE * max(map(abs, sizes), default=0.0)
    acting = [
        (each.letter, number(_angle(each.way), givens) + (math.pi if size < 0 else 0.0))
        for each, size in zip(stated.forces, sizes, strict=True)
        if abs(size) > least
    ]
    slope = None if stated.slope is None else number(stated.slope, givens)
    return FreeBody(tuple(acting), stated.mistakes, slope, lambda: givens)


def as_answered(body: FreeBody, part: Part) -> str:
    """The answer in one text, with every direction as an angle: `weight: 270 deg; normal force: 110 deg`."""
    return "; ".join(f"{_name(part, letter)}: {_degrees(angle):.6g} deg" for letter, angle in body.forces)


def as_people_say(body: FreeBody, part: Part) -> str:
    """The same with directions in words, in the language spoken, where there is one."""
    return "; ".join(f"{_name(part, letter)}: {_way(body, angle)}" for letter, angle in body.forces)


def _angle(way: str | Expr) -> Expr:
    assert not isinstance(way, str)  # once solved
    return way


def _name(part: Part, letter: str) -> str:
    return next(main_spelling(option.text) for option in part.options if option.letter == letter)


def _degrees(angle: float) -> float:
    return math.degrees(angle) % 360


def _way(body: FreeBody, angle: float) -> str:
    for way, degrees in DEGREES.items():
        turned = (
            (body.slope if of_a_slope(way) else 0.0)
            if body.slope is not None or not of_a_slope(way)
            else None
        )
        if (
            turned is not None
            and abs(math.remainder(angle - math.radians(degrees) - turned, math.tau)) < NONE
        ):
            return in_words(way)
    return f"{_degrees(angle):.4g}°"
