"""Signs of answers: which components may be negative, or point one way or the other."""

from __future__ import annotations

import re
from fractions import Fraction

from corollary.answers.common_errors import is_directed
from corollary.answers.components import are_axes
from corollary.answers.direction import SIZE
from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Rule, Solution, once
from corollary.formula.ast import TWO, Call, Expr, Number, Power, Sum
from corollary.formula.ball import Undefined, certified
from corollary.problem.part import Part
from corollary.problem.sampling import sample

TRIED = 40  # draws: what is negative for one in ten is found but for one time in seventy
SIZES = (
    "speed", "distance", "height", "depth", "length", "width", "radius", "diameter", "duration", "mass", "magnitude", "period",
    "frequency", "kinetic energy",
)  # fmt: skip
ASKED = re.compile(
    rf"\b(?:at |with )?(?:what|which)(?: (?:is|was|are|were|must be|will be))?(?: (?:the|its|their|your|his|her))?(?: \w+)?"
    rf" (?P<size>{'|'.join(SIZES)})\b(?! (?:difference|change))|\bhow (?P<how>fast|long|far|high|deep|heavy|many)\b",
    re.IGNORECASE,
)
# How large a velocity is does not say that it is one way only; with a value that is never negative it asks for its size.
AS_SIZE = re.compile(
    r"\bhow (?:large|big|great|strong)\b|\bas a positive (?:number|value)\b|\b(?:give|state)\b[^.;?]*\b(?:magnitude|size)\b",
    re.IGNORECASE,
)


def signed(solution: Solution, place: int, part: Part, values: Values) -> tuple[bool, ...]:
    """Of each component, whether its sign can be wrong: it is negative here or for other numbers, or it has a direction.

    What is positive for all numbers, such as a mass, a height or a loss, has no sign to get wrong; nor has the size of a velocity.
    """
    units = part.units_for(len(values))
    zeros = tuple(float(unit.offset) for unit in units)
    axes = bool(part.components) and are_axes(part.components)
    directed = [axes or is_directed(unit) for unit in units]
    if any(directed) and not axes and (_asks_for_size(solution, place) or _is_length(solution, place)):
        directed = [False] * len(units)
    own = [way or value < zero for way, value, zero in zip(directed, values, zeros, strict=True)]
    return tuple(own) if all(own) else tuple(map(max, own, _negative_for_some(solution, place, zeros)))


def size_asked(part: Part) -> str:
    """The words by which a question asks for what cannot be negative; "" where it does not."""
    asked = ASKED.search(part.text)
    if asked is None or part.unit.offset:
        return ""
    return asked["size"] or f"how {asked['how']}"


def _asks_for_size(solution: Solution, place: int) -> bool:
    """True if the title or the question asks for a speed, a magnitude, or a positive number."""
    part = solution.problem.part(solution.unknowns[place].part)
    text = part.text.replace("*", "")
    return bool(SIZE.search(part.title) or ASKED.search(text) or AS_SIZE.search(text))


def _is_length(solution: Solution, place: int) -> bool:
    """True if each component is by its last step the root of a sum of squares."""
    local: Rule = solution.unknowns[place].local
    return isinstance(local, ClosedForms) and all(map(_root_of_squares, local.trees))


def _root_of_squares(tree: Expr) -> bool:
    match tree:
        case Call("sqrt", (Sum(terms),)) | Power(Sum(terms), Number(Fraction(numerator=1, denominator=2))):
            return all(isinstance(each, Power) and each.exponent == TWO for each in terms)
        case Call("abs"):
            return True
        case _:
            return False


@once
def _negative_for_some(solution: Solution, place: int, zeros: tuple[float, ...]) -> tuple[bool, ...]:
    """Of each component, whether it is below its zero for numbers that can be dealt; of a simulation nothing is known."""
    trees = solution.unknowns[place].in_givens
    found = [False] * len(zeros)
    for draw in sample(solution.problem, TRIED, salt="signs") if trees is not None else ():
        for index, tree in enumerate(trees or ()):
            try:
                found[index] = found[index] or certified(tree, draw.exact).value < zeros[index]
            except Undefined:
                continue
    return tuple(found)
