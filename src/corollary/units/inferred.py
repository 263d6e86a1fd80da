"""Dimensions of letters, inferred from equations in which both sides, and all terms, measure the same."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import assert_never

from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    names,
    walk,
)
from corollary.formula.errors import ParseError, sentence
from corollary.formula.functions import FUNCTIONS
from corollary.units.dimension import ONE, Dimension
from corollary.units.dimensional_analysis import dimension_of


@dataclass(frozen=True, slots=True)
class PowerProduct:
    """A dimension that is known in part: `known` times powers of what letters measure."""

    known: Dimension
    letters: Mapping[str, Fraction]

    def times(self, other: PowerProduct, power: Fraction) -> PowerProduct:
        letters = dict(self.letters)
        for name, exponent in other.letters.items():
            letters[name] = letters.get(name, Fraction(0)) + exponent * power
        return PowerProduct(
            self.known * other.known**power, {name: each for name, each in letters.items() if each}
        )


PURE_NUMBER = PowerProduct(ONE, {})


class DimensionInference:
    """Learns from one relation after the other; what it has learned so far is in `dimensions`."""

    def __init__(self, known: Mapping[str, Dimension]):
        self._known = dict(known)
        self._found: dict[str, PowerProduct] = {}
        self._zeros = 0

    @property
    def dimensions(self) -> dict[str, Dimension]:
        """Of each letter that is known or has been found."""
        found = {name: self._resolved(PowerProduct(ONE, {name: Fraction(1)})) for name in self._found}
        return self._known | {name: each.known for name, each in found.items() if not each.letters}

    def learn(self, relation: Expr) -> None:
        """Takes a relation as true. Raises ValueError where no choice of dimensions makes it so."""
        try:
            self._of(relation)
            if names(relation) - {"pi"} <= (so_far := self.dimensions).keys():
                misfit = dimension_of(relation, so_far)
                if isinstance(misfit, ParseError):
                    raise ValueError(sentence(misfit))
        except ValueError:
            so_far = self.dimensions
            for part in walk(relation):
                if names(part) - {"pi"} <= so_far.keys():
                    misfit = dimension_of(part, so_far)
                    if isinstance(misfit, ParseError):
                        raise ValueError(sentence(misfit)) from None
            raise

    def _resolved(self, product: PowerProduct) -> PowerProduct:
        while inside := next((name for name in product.letters if name in self._found), None):
            power = product.letters[inside]
            rest = PowerProduct(
                product.known, {n: each for n, each in product.letters.items() if n != inside}
            )
            product = rest.times(self._found[inside], power)
        return product

    def _equal(self, one: PowerProduct, other: PowerProduct) -> None:
        quotient = self._resolved(one.times(other, Fraction(-1)))
        if quotient.letters:
            name, power = next(iter(quotient.letters.items()))
            rest = PowerProduct(
                quotient.known, {n: each for n, each in quotient.letters.items() if n != name}
            )
            self._found[name] = PURE_NUMBER.times(rest, -1 / power)
        elif quotient.known != ONE:
            raise ValueError("its sides, or its terms, do not measure the same")

    def _of(self, tree: Expr) -> PowerProduct:
        match tree:
            case Number(value):
                return PURE_NUMBER if value else self._anything()
            case Name(name):
                if name in self._known:
                    return PowerProduct(self._known[name], {})
                return PURE_NUMBER if name == "pi" else PowerProduct(ONE, {name: Fraction(1)})
            case Negative(term):
                return self._of(term)
            case Sum(terms):
                return self._alike(terms)
            case Product(factors):
                product = PURE_NUMBER
                for factor in factors:
                    product = product.times(self._of(factor), Fraction(1))
                return product
            case Quotient(top, bottom):
                return self._of(top).times(self._of(bottom), Fraction(-1))
            case Power(base, exponent):
                self._equal(self._of(exponent), PURE_NUMBER)
                below, power = self._of(base), constant(exponent)
                if power is None:
                    if not below.letters and below.known != ONE:
                        return (
                            self._anything()
                        )  # T*V^(k-1): only the whole law tells, once all of it is known
                    self._equal(below, PURE_NUMBER)
                    return PURE_NUMBER
                return PURE_NUMBER.times(below, power)
            case Call(function, arguments):
                row = FUNCTIONS[function]
                if row.dimension is None:
                    for argument in arguments:
                        self._equal(self._of(argument), PURE_NUMBER)
                    return PURE_NUMBER
                return PURE_NUMBER.times(self._alike(arguments), Fraction(row.dimension))
            case Relation(_, left, right):
                return self._alike((left, right))
            case _:
                assert_never(tree)

    def _alike(self, terms: tuple[Expr, ...]) -> PowerProduct:
        first, *others = map(self._of, terms)
        for each in others:
            self._equal(first, each)
        return self._resolved(first)

    def _anything(self) -> PowerProduct:
        """The dimension of 0: that of whatever it is added to."""
        self._zeros += 1
        return PowerProduct(ONE, {f"0.{self._zeros}": Fraction(1)})
