"""A published answer put back into the laws: which of them it breaks."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from corollary.audit.exercise import AdmittedRoot, PublishedExercise, quantities_apart
from corollary.formula.ast import Expr, Relation, names
from corollary.formula.ball import RationalPi, certified
from corollary.formula.errors import ParseError, Undefined
from corollary.formula.syntax import author_formula
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import Dimension, Unit, si_unit

FIGURES = 4  # of the sides; more where these are the same
ROUNDING = 1e-9  # relative: sides so near are the same


@dataclass(frozen=True, slots=True)
class BrokenLaw:
    """A law by its name, and its two sides as they come out."""

    law: str
    written: tuple[str, str]


def broken_law(
    exercise: PublishedExercise, root: AdmittedRoot, letter: str, published: RationalPi
) -> BrokenLaw | None:
    """The law that breaks, with the published answer for a letter and all else as derived."""
    values = {name: RationalPi(Fraction(value)) for name, value in root.values.items()} | exercise.numbers
    relations = [(law.name, author_formula(law.formula)) for law in exercise.record.laws]
    return most_broken(
        relations, letter, values | {letter: published}, exercise.dimensions, exercise.unknowns
    )


def most_broken(
    relations: Iterable[tuple[str, Expr]],
    letter: str,
    values: Mapping[str, RationalPi],
    dimensions: Mapping[str, Dimension],
    unknowns: Collection[str],
) -> BrokenLaw | None:
    """Of the relations that a letter breaks the one with the fewest other unknowns, which decides it most nearly; of several
    such the one whose sides differ most, as a share of them. None where none is broken."""
    known = {name for name in values if name not in unknowns}
    best: tuple[int, float] | None = None
    found = None
    for law, relation in relations:
        if not isinstance(relation, Relation) or letter not in names(relation):
            continue
        try:
            left, right = (certified(side, values).value for side in (relation.left, relation.right))
        except (Undefined, KeyError):
            continue
        size = max(abs(left), abs(right))
        share = abs(left - right) / size if size else 0.0
        rank = (len(names(relation) - known), -share)
        if share > ROUNDING and (best is None or rank < best):
            best, unit = rank, _unit(relation, dimensions)
            found = BrokenLaw(law, _written(left, right, unit))
    return found


def _written(left: float, right: float, unit: Unit | None) -> tuple[str, str]:
    one, other = quantities_apart((left, right), unit, FIGURES)
    return one, other


def _unit(relation: Relation, dimensions: Mapping[str, Dimension]) -> Unit | None:
    if not names(relation) <= {*dimensions, "pi"}:
        return None
    measured = dimension_of(relation, dimensions)
    return None if isinstance(measured, ParseError) else si_unit(measured)
