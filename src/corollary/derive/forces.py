"""The forces on a body as an author states them, held against the laws in which they stand."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from typing import Any

import sympy

from corollary.answers.ways import DEGREES, of_a_slope
from corollary.derive.applied import applied
from corollary.derive.assumptions import Known, vanishes
from corollary.derive.sampled import identical
from corollary.derive.solution import SolvedForces
from corollary.derive.statements import Acting, Along, Forces
from corollary.formula.ast import Expr, Relation
from corollary.formula.from_sympy import tree
from corollary.formula.syntax import author_formula
from corollary.formula.to_sympy import expression
from corollary.laws.law import Law, sides
from corollary.problem.part import Part


def solved_forces(entry: Forces[Any, Law], part: Part, known: Known) -> SolvedForces:
    """The forces in givens. Raises ValueError where they are not those of the laws, or a direction is none."""
    letters = {option.letter for option in part.options}
    if strange := ({each.letter for each in entry.forces} | entry.mistakes.keys()) - letters:
        raise ValueError(f"{', '.join(sorted(strange))} is none of its options {', '.join(sorted(letters))}")
    if both := {each.letter for each in entry.forces} & entry.mistakes.keys():
        raise ValueError(f"{', '.join(sorted(both))} acts; a mistake is to name a force that does not")
    slope = _slope(part, known)
    pulls = [(each.letter, each.magnitude, angle_of(each.way, slope)) for each in entry.forces]
    words = [each.way if isinstance(each.way, str) else "" for each in entry.forces]
    for balance in entry.balances:
        _check(balance, pulls, slope, known)
    axes = [angle_of(each.way, slope) for each in entry.balances]
    for letter, _magnitude, angle in pulls:
        if all(vanishes(sympy.cos(angle - axis)) for axis in axes):
            raise ValueError(f"no law along a direction in which ({letter}) acts is named; add along(…)")
    return Forces(
        entry.statement,
        tuple(
            Acting(letter, tree(known.in_givens_alone(size)), tree(known.in_givens_alone(angle)), word)
            for (letter, size, angle), word in zip(pulls, words, strict=True)
        ),
        tuple(Along(str(each.way), applied(each.law)) for each in entry.balances),
        entry.mistakes,
        None if slope is None else tree(slope),
    )


def sum_along(entry: Forces[Any, Law], way: Any, slope: str) -> Expr:
    """The sum of the components of all forces along a direction, as a formula; `slope` is the letter of its angle. Raises ValueError."""
    angle = sympy.Symbol(slope, real=True) if slope else None
    axis = angle_of(way, angle)
    pulls = [each.magnitude * sympy.cos(angle_of(each.way, angle) - axis) for each in entry.forces]
    return tree(sum(pulls, sympy.S.Zero))


def angle_of(way: Any, slope: sympy.Expr | None) -> sympy.Expr:
    """A direction as an angle, counter-clockwise from the right. Raises ValueError for a word that is none."""
    if not isinstance(way, str):
        return sympy.sympify(way)
    if way not in DEGREES:
        raise ValueError(f"{way!r} is not a direction; choose one of {', '.join(DEGREES)}, and angles")
    if of_a_slope(way) and slope is None:
        raise ValueError(
            f'{way!r} needs the angle of the slope: add slope="alpha" to the heading of the part'
        )
    angle = sympy.pi * DEGREES[way] / 180
    return angle + slope if of_a_slope(way) and slope is not None else angle


def _slope(part: Part, known: Known) -> sympy.Expr | None:
    if not part.slope:
        return None
    try:
        formula = author_formula(part.slope)
        if isinstance(formula, Relation):
            raise ValueError("an angle is one formula of the givens")
        found = expression(formula, {symbol.name: symbol for symbol in known.letters})
    except (ValueError, KeyError) as error:
        raise ValueError(f"slope={part.slope!r}: {error}") from None
    return found


def _check(
    balance: Along[Law], pulls: list[tuple[str, Any, sympy.Expr]], slope: sympy.Expr | None, known: Known
) -> None:
    """The sum of the components along the direction is one side of the law, or what its two sides differ by.

    So by algebra, or at numbers: for all values of the letters, not only for those that the laws make of them.
    """
    axis = angle_of(balance.way, slope)
    total = sum(
        (size * sympy.expand_trig(sympy.cos(angle - axis)) for _letter, size, angle in pulls), sympy.S.Zero
    )
    for left, right in sides(balance.law):
        letters: set[Any] = {
            symbol for each in (left, right, total) for symbol in each.free_symbols
        } - known.givens
        found = [identical(side, total, known, letters) for side in (left, right, left - right, right - left)]
        if any(each.holds for each in found):
            continue
        differs = all(each.how == "differ" for each in found)
        fault = (
            "a force is missing, too much, or points elsewhere"
            if differs
            else "whether that is the same was not decided, neither by algebra nor at numbers; state the law in the same form"
        )
        raise ValueError(
            f"the forces add up to {sympy.sstr(sympy.simplify(total))} along {balance.way!r}, but "
            f"{balance.law.name or 'the law'} says {sympy.sstr(left)} = {sympy.sstr(right)}: {fault}"
            + (
                f"; {found[2].at_numbers('what its sides differ by', 'the sum of the forces')}"
                if differs
                else ""
            )
        )
