"""Formulas evaluated with certainty: a ball that holds the value is made smaller until only one answer is left."""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar, assert_never

from flint import arb, ctx, fmpq

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
    children,
    names,
    rebuilt,
)
from corollary.formula.errors import Undefined
from corollary.formula.exact import constant, exactly
from corollary.formula.functions import FUNCTIONS, ball_root
from corollary.formula.rational_pi import RationalPi

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


__all__ = [
    "Ball",
    "Certified",
    "RationalPi",
    "Undefined",
    "ball_at",
    "certified",
    "evaluate",
    "holds",
    "in_balls",
    "precision_of",
    "sign",
]

FIRST_BITS = 64  # enough for nine answers in ten, whose balls are then one double wide
EXACT_FROM = 256  # from here on the parts known exactly are put in: smaller balls decide no tie and no zero
MOST_BITS = 8192  # r - b of an orbit at scale 1e300 needs about 2000

T = TypeVar("T")
Ball = arb  # a value and how far it may be off
Values = Mapping[str, RationalPi] | Mapping[str, arb] | Mapping[str, RationalPi | arb]
_FLINT = threading.RLock()  # the working precision is one global of the library, for all threads


@dataclass(frozen=True, slots=True)
class Certified:
    """The double nearest to a value; `proven` unless two doubles were still possible at the largest precision."""

    value: float
    proven: bool
    bits: int


@contextmanager
def precision_of(bits: int) -> Generator[None]:
    """Everything inside works with so many bits; one thread at a time."""
    with _FLINT:
        before = ctx.prec
        ctx.prec = bits
        try:
            yield
        finally:
            ctx.prec = before


def evaluate(tree: Expr, values: Values, precision: int) -> arb:
    """A ball that holds the value. Not finite when this precision does not decide; raises Undefined when there is no value.

    Raises KeyError for a letter without a value.
    """
    with precision_of(precision):
        return _ball(tree, values)


def ball_at(tree: Expr, values: Mapping[str, arb]) -> arb:
    """As `evaluate`, at the precision that is set: inside `precision_of`, for many formulas on values that are balls already."""
    ready = program(tree)
    return ready.run([values[name] if name in values else _constant(name) for name in ready.names])


def in_balls(values: Values, precision: int) -> dict[str, arb]:
    """The values as balls of this precision: to evaluate many formulas on the same numbers."""
    with precision_of(precision):
        return {name: _as_ball(value) for name, value in values.items()}


def certified(tree: Expr, values: Values) -> Certified:
    """The double nearest to the exact value; `inf` beyond the doubles. Raises Undefined when there is no value."""

    def decide(ball: arb) -> float | None:
        if not ball.is_finite():
            return None
        low, high = float(ball.lower()), float(ball.upper())
        return low + 0.0 if low == high else None

    value, bits, last = _refined(tree, values, decide)
    if value is not None:
        return Certified(value, True, bits)
    if last is None or not last.is_finite() or last.rel_accuracy_bits() < 1:
        raise Undefined("no value could be worked out: too large, or at a point where it jumps")
    return Certified(float(last.mid()), False, bits)


def sign(tree: Expr, values: Values) -> int | None:
    """-1, 0 or 1; None when even the largest precision does not tell the value from 0. Raises Undefined."""

    def decide(ball: arb) -> int | None:
        return 1 if ball > 0 else -1 if ball < 0 else 0 if ball.is_zero() else None

    return _refined(tree, values, decide)[0]


def holds(relation: Relation, values: Values) -> bool | None:
    """Whether a condition is true; None when undecided. Raises Undefined when a side has no value."""
    found = sign(_difference(relation), values)
    if found is None:
        return None
    match relation.sign:
        case "=":
            return found == 0
        case "!=":
            return found != 0
        case "<":
            return found < 0
        case "<=":
            return found <= 0
        case ">":
            return found > 0
        case ">=":
            return found >= 0
        case other:
            raise ValueError(f"{other} is not a comparison; use = != < <= > >=")


# By identity, as programs are kept: a condition is asked of every draw. The relation is held, so its id stays its own.
_DIFFERENCES: dict[int, tuple[Relation, Expr]] = {}


def _difference(relation: Relation) -> Expr:
    """Left side less right side."""
    cached = _DIFFERENCES.get(id(relation))
    if cached is not None and cached[0] is relation:
        return cached[1]
    if len(_DIFFERENCES) >= MOST_CACHED:
        _DIFFERENCES.clear()
    made = Sum((relation.left, Negative(relation.right)))
    _DIFFERENCES[id(relation)] = relation, made
    return made


def _refined(
    tree: Expr, values: Values, decide: Callable[[arb], T | None]
) -> tuple[T | None, int, arb | None]:
    """The decision, the bits it took, the last ball."""
    bits, last, settled = FIRST_BITS, None, False
    with _FLINT:
        before = ctx.prec
        try:
            while bits <= MOST_BITS:
                if bits >= EXACT_FROM and not settled:
                    tree, settled = _settled(tree, values), True
                ctx.prec = bits
                last = _ball(tree, values)
                found = decide(last)
                if found is not None:
                    return found, bits, last
                bits *= 2
        finally:
            ctx.prec = before
    return None, bits // 2, last


def _ball(tree: Expr, values: Values) -> arb:
    ready = program(tree)
    return ready.run([_as_ball(values[name]) if name in values else _constant(name) for name in ready.names])


def _as_ball(value: RationalPi | arb) -> arb:
    if isinstance(value, arb):
        return value
    ratio = value.ratio
    ball = arb(fmpq(ratio.numerator, ratio.denominator))
    return ball if value.pi == 0 else ball * arb.pi() ** value.pi


def _constant(name: str) -> arb:
    if name == "pi":
        return arb.pi()
    raise KeyError(name)


def _settled(tree: Expr, values: Values) -> Expr:
    """The same formula, each part whose value is known exactly replaced by it."""
    known = exactly(tree, values)
    if known is not None:
        number = Number(known.ratio)
        return number if known.pi == 0 else Product((number, Power(Name("pi"), Number(Fraction(known.pi)))))
    return rebuilt(tree, tuple(_settled(part, values) for part in children(tree)))
