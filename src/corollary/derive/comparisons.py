"""Comparisons that decide a case or a choice, with the numbers of both sides."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from corollary.derive.numbers_in_formulas import quantity
from corollary.derive.solution import Solution, Ways
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr, Number, Relation, names
from corollary.formula.errors import NotAvailable, ParseError
from corollary.formula.latex import SIGNS, latex
from corollary.units.dimension import Dimension
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import Unit, si_unit

MOST = 3  # comparisons; of more, no one decides
UNREADABLE = (NotAvailable, KeyError, ValueError, ArithmeticError, TypeError)
EXACT = {"=", "!="}


def decided(relations: Iterable[Relation], si: Mapping[str, float], solution: Solution) -> list[str]:
    """A displayed line for each relation, as F = 180 N ≤ μN = 196 N; none for what has no letters, or does not hold."""
    found = [line for each in relations if (line := _line(each, si, solution))]
    return [text for line in found for text in (f"$${line}$$", "")] if len(found) <= MOST else []


def way_that_holds(ways: Ways, si: Mapping[str, float]) -> tuple[Relation, ...]:
    """The relations that hold for these numbers, of the ways in which an option is right."""
    return next((way for way in ways if all(_holds(each, si) for each in way)), ())


def _holds(relation: Relation, si: Mapping[str, float]) -> bool:
    try:
        left, right = (ready(side, DOUBLES)(si) for side in (relation.left, relation.right))
    except UNREADABLE:
        return False
    match relation.sign:
        case "<" | "<=":
            return left <= right
        case ">" | ">=":
            return left >= right
        case sign:
            return (left != right) is (sign == "!=")


def _line(relation: Relation, si: Mapping[str, float], solution: Solution) -> str:
    if not names(relation) or relation.sign in EXACT or not _holds(relation, si):
        return ""
    dimensions = {each.symbol: each.unit.dimension for each in solution.problem.letters}
    for find in solution.unknowns:
        dimensions |= dict(zip(find.names, find.dimensions, strict=True))
    sides: list[str] = []
    unit = _unit(relation, dimensions, solution)
    if unit is None:
        return ""
    for side in (relation.left, relation.right):
        value = ready(side, DOUBLES)(si)
        sides.append(" = ".join(_with_value(side, quantity(value, unit))))
    return f"{sides[0]} {SIGNS[relation.sign]} {sides[1]}"


def _with_value(side: Expr, value: str) -> Iterator[str]:
    if isinstance(side, Number) and side.value == 0:
        yield "0"
        return
    if names(side):
        yield latex(side)
    yield value


def _unit(relation: Relation, dimensions: Mapping[str, Dimension], solution: Solution) -> Unit | None:
    """That of a part or a given with this dimension; else the SI's. None where the sides have no common one."""
    side = relation.left if names(relation.left) else relation.right
    try:
        dimension = dimension_of(side, dimensions)
    except KeyError:
        return None
    if isinstance(dimension, ParseError):
        return None
    problem = solution.problem
    units: list[Unit] = [unit for part in problem.parts for unit in part.units]
    units += [given.unit for given in problem.givens]
    standard = si_unit(dimension)
    if dimension == Dimension():
        return standard
    return next((each for each in units if each.dimension == dimension and not each.offset), standard)
