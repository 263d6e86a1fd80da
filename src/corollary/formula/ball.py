"""Formulas evaluated with certainty: a ball that holds the value is made smaller until only one answer is left."""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

from flint import arb, ctx, fmpq

from corollary.formula.arithmetics import Arithmetic, Evaluation, as_formula, constant, exactly, ready
from corollary.formula.ast import (
    Expr,
    Relation,
    difference,
    map_children,
    names,
)
from corollary.formula.errors import Undefined
from corollary.formula.functions import ball_root
from corollary.formula.rational_pi import RationalPi

MOST_CACHED = 1024
ROOTS_UP_TO = 64


def _number(value: Fraction) -> arb:
    return arb(fmpq(value.numerator, value.denominator))


def _literal(value: Fraction) -> Evaluation:
    """Rounded anew at each precision, unless it is a short whole number."""
    if value.denominator == 1 and value.numerator.bit_length() <= 64:
        whole = arb(value.numerator)
        return lambda at: whole
    ratio = fmpq(value.numerator, value.denominator)
    return lambda at: arb(ratio)


def _quotient(top: Evaluation, bottom: Evaluation) -> Evaluation:
    def run(at: Mapping[str, arb]) -> arb:
        below = bottom(at)
        if below.is_zero():
            raise Undefined("division by zero")
        return top(at) / below

    return run


def _raised(base: Evaluation, exponent: Expr, made: Callable[[Expr], Evaluation]) -> Evaluation:
    fixed = constant(exponent)
    if fixed is None or fixed.denominator > ROOTS_UP_TO or abs(fixed.numerator) >= 1 << 20:
        above = made(exponent)
        return lambda at: _power(base(at), above(at))
    up, degree = fixed.numerator, fixed.denominator

    def run(at: Mapping[str, arb]) -> arb:
        ball = base(at)
        if up < 0 and ball.is_zero():
            raise Undefined("division by zero")
        if degree > 1:
            ball = ball_root(ball, degree)
        return ball**up

    return run


def _power(below: arb, above: arb) -> arb:
    if below < 0 and not above.contains_integer():
        raise Undefined("a negative number to a fractional power")
    if not below.is_zero():
        return below**above
    if above < 0:
        raise Undefined("division by zero")
    return arb(0) if above > 0 else arb(1) if above.is_zero() else arb("nan")


BALLS = Arithmetic(
    "balls", _number, None, lambda row: row.ball, literal=_literal, quotient=_quotient, raised=_raised
)
"""At the precision that is set; a division by zero raises Undefined."""


@dataclass(frozen=True, slots=True)
class Program:
    """A formula ready to run on the balls of its letters; pi is one of them."""

    names: tuple[str, ...]
    run: Evaluation


# Kept by identity: to hash a formula costs as much as to evaluate it. The formula is held, so its id stays its own.
_CACHE: dict[int, tuple[Expr, Program]] = {}


def program(tree: Expr) -> Program:
    """The program of a formula, made once."""
    cached = _CACHE.get(id(tree))
    if cached is not None and cached[0] is tree:
        return cached[1]
    made = Program(tuple(sorted(names(tree))), ready(tree, BALLS))
    if len(_CACHE) >= MOST_CACHED:
        _CACHE.clear()
    _CACHE[id(tree)] = (tree, made)
    return made


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
    made = program(tree)
    return made.run({name: values[name] if name in values else _constant(name) for name in made.names})


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
    made = difference(relation)
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
    made = program(tree)
    return made.run(
        {name: _as_ball(values[name]) if name in values else _constant(name) for name in made.names}
    )


def _as_ball(value: RationalPi | arb) -> arb:
    if isinstance(value, arb):
        return value
    ball = _number(value.ratio)
    return ball if value.pi == 0 else ball * arb.pi() ** value.pi


def _constant(name: str) -> arb:
    if name == "pi":
        return arb.pi()
    raise KeyError(name)


def _settled(tree: Expr, values: Values) -> Expr:
    """The same formula, each part whose value is known exactly replaced by it."""
    known = exactly(tree, values)
    if known is not None:
        return as_formula(known)
    return map_children(tree, lambda part: _settled(part, values))
