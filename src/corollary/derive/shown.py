"""Laws and suppositions made ready to be shown: a law as the textbook has it and in the letters of the problem."""

from __future__ import annotations

from corollary.answers.quantity import read_quantity
from corollary.derive.solution import LawShown, SupposedValue
from corollary.derive.statements import Supposed
from corollary.formula.ast import Relation, substitute
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import tree
from corollary.laws.law import Law, component
from corollary.units.dimensions import Dimension
from corollary.units.unit import unit


def shown(stated: Law) -> LawShown:
    """The law with its letters replaced and nothing simplified."""
    here = []
    for index in range(stated.components):
        meaning = {letter: tree(value) for letter, value in component(stated, index).items()}
        here.append(
            Relation(
                "=", substitute(stated.textbook.left, meaning), substitute(stated.textbook.right, meaning)
            )
        )
    return LawShown(stated.name, stated.source, stated.holds, stated.textbook, stated.vectors, tuple(here))


def supposed_value(supposition: Supposed) -> SupposedValue:
    """The value in SI. Raises ValueError where the text is no quantity."""
    read = read_quantity(supposition.text, unit("1"))
    if isinstance(read, ParseError):
        raise ValueError(f"{supposition.symbol} is supposed to be {supposition.text!r}: {read.why}")
    ratio, pi = read.si
    if pi:
        raise ValueError(f"{supposition.symbol} is supposed to be {supposition.text!r}; give angles in rad")
    dimension = read.unit.dimension if read.unit else Dimension()
    return SupposedValue(supposition.symbol.name, ratio, dimension, supposition.text, supposition.why)
