"""Formulas whose value is a fraction, or a fraction times a power of pi: worked out exactly."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import assert_never

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.functions import FUNCTIONS
from corollary.formula.rational_pi import MINUS_ONE, NOTHING, ONE, PI, RationalPi, plus, raised, times


def constant(tree: Expr) -> Fraction | None:
    """The value of a formula without letters, where it is a fraction."""
    found = exactly(tree, {})
    return found.ratio if found is not None and found.pi == 0 else None


def exactly(tree: Expr, values: Mapping[str, object]) -> RationalPi | None:
    """The value in Q times a power of pi; None where it is not one, is not defined, or has too many digits."""
    match tree:
        case Number(value):
            return RationalPi(value)
        case Name(name):
            known = values.get(name, PI if name == "pi" else None)
            return known if isinstance(known, RationalPi) else None
        case Negative(term):
            return times(MINUS_ONE, exactly(term, values))
        case Sum(terms):
            total: RationalPi | None = NOTHING
            for term in terms:
                total = plus(total, exactly(term, values))
            return total
        case Product(factors):
            product: RationalPi | None = ONE
            for factor in factors:
                product = times(product, exactly(factor, values))
            return product
        case Quotient(top, bottom):
            return times(exactly(top, values), raised(exactly(bottom, values), Fraction(-1)))
        case Power(base, exponent):
            power = exactly(exponent, values)
            return raised(exactly(base, values), power.ratio) if power is not None and not power.pi else None
        case Call(function, arguments):
            known = [exactly(argument, values) for argument in arguments]
            given = [each for each in known if each is not None]
            return FUNCTIONS[function].exact(*given) if len(given) == len(known) else None
        case Relation():
            return None
        case _:
            assert_never(tree)
