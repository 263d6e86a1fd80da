"""A formula made ready to be evaluated many times: each part becomes a small function of the letters' balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import assert_never

from flint import arb, fmpq

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
)
from corollary.formula.errors import Undefined
from corollary.formula.exact import constant
from corollary.formula.functions import FUNCTIONS, ball_root

Step = Callable[[Sequence[arb]], arb]
MOST_CACHED = 1024
ROOTS_UP_TO = 64


@dataclass(frozen=True, slots=True)
class Program:
    """A formula ready to run on the balls of its letters, in the order of `names`."""

    names: tuple[str, ...]
    run: Step


# Kept by identity: to hash a formula costs as much as to evaluate it. The formula is held, so its id stays its own.
_CACHE: dict[int, tuple[Expr, Program]] = {}


def program(tree: Expr) -> Program:
    """The program of a formula, made once."""
    cached = _CACHE.get(id(tree))
    if cached is not None and cached[0] is tree:
        return cached[1]
    letters = tuple(sorted(names(tree)))
    made = Program(letters, _step(tree, {name: place for place, name in enumerate(letters)}))
    if len(_CACHE) >= MOST_CACHED:
        _CACHE.clear()
    _CACHE[id(tree)] = (tree, made)
    return made


def _step(tree: Expr, place: dict[str, int]) -> Step:
    match tree:
        case Number(value):
            return _number(value)
        case Name(name):
            index = place[name]
            return lambda at: at[index]
        case Negative(term):
            inner = _step(term, place)
            return lambda at: -inner(at)
        case Sum(terms):
            signed = [
                (isinstance(term, Negative), term.term if isinstance(term, Negative) else term)
                for term in terms
            ]
            return _sum([(minus, _step(term, place)) for minus, term in signed])
        case Product(factors):
            return _product([_step(factor, place) for factor in factors])
        case Quotient(top, bottom):
            return _quotient(_step(top, place), _step(bottom, place))
        case Power(base, exponent):
            fixed = constant(exponent)
            if fixed is not None and fixed.denominator <= ROOTS_UP_TO and abs(fixed.numerator) < 1 << 20:
                return _fixed_power(_step(base, place), fixed)
            return _power(_step(base, place), _step(exponent, place))
        case Call(function, arguments):
            return _call(function, [_step(argument, place) for argument in arguments])
        case Relation(sign):
            raise ValueError(f"a comparison ({sign}) has no number as its value")
        case _:
            assert_never(tree)


def _number(value: Fraction) -> Step:
    if value.denominator == 1 and value.numerator.bit_length() <= 64:
        whole = arb(value.numerator)
        return lambda at: whole
    ratio = fmpq(value.numerator, value.denominator)
    return lambda at: arb(ratio)  # rounded anew at each precision


def _sum(terms: list[tuple[bool, Step]]) -> Step:
    if len(terms) == 2 and not terms[0][0]:
        (_, left), (minus, right) = terms
        return (lambda at: left(at) - right(at)) if minus else (lambda at: left(at) + right(at))

    def run(at: Sequence[arb]) -> arb:
        total = arb(0)
        for minus, term in terms:
            total = total - term(at) if minus else total + term(at)
        return total

    return run


def _product(factors: list[Step]) -> Step:
    if len(factors) == 2:
        left, right = factors
        return lambda at: left(at) * right(at)

    def run(at: Sequence[arb]) -> arb:
        product = arb(1)
        for factor in factors:
            product = product * factor(at)
        return product

    return run


def _quotient(top: Step, bottom: Step) -> Step:
    def run(at: Sequence[arb]) -> arb:
        below = bottom(at)
        if below.is_zero():
            raise Undefined("division by zero")
        return top(at) / below

    return run


def _fixed_power(base: Step, power: Fraction) -> Step:
    up, degree = power.numerator, power.denominator

    def run(at: Sequence[arb]) -> arb:
        ball = base(at)
        if up < 0 and ball.is_zero():
            raise Undefined("division by zero")
        if degree > 1:
            ball = ball_root(ball, degree)
        return ball**up

    return run


def _power(base: Step, exponent: Step) -> Step:
    def run(at: Sequence[arb]) -> arb:
        below, above = base(at), exponent(at)
        if below < 0 and not above.contains_integer():
            raise Undefined("a negative number to a broken power")
        if not below.is_zero():
            return below**above
        if above < 0:
            raise Undefined("division by zero")
        return arb(0) if above > 0 else arb(1) if above.is_zero() else arb("nan")

    return run


def _call(function: str, arguments: list[Step]) -> Step:
    ball, first = FUNCTIONS[function].ball, arguments[0]
    if len(arguments) == 1:
        return lambda at: ball(first(at))
    return lambda at: ball(*[argument(at) for argument in arguments])
