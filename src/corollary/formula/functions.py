"""The functions a formula may use: one row each, which every reader, evaluator and writer of formulas asks."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from corollary.formula.errors import Undefined
from corollary.formula.rational_pi import (
    HALF,
    NOTHING,
    ONE,
    RationalPi,
    arc_cosine,
    arc_sine,
    arc_tangent,
    cosine,
    largest,
    sine,
    smallest,
    tangent,
)

if TYPE_CHECKING:  # a student's notebook reads formulas with Python alone; the balls bring flint with them
    from flint import arb


def _irrational(*arguments: RationalPi) -> RationalPi | None:
    """Of a function with no rational value known."""
    return None


@dataclass(frozen=True, slots=True)
class Function:
    """One function of one or more numbers, and what each reader, evaluator and writer needs to know of it.

    double: of floats; raises ValueError, ZeroDivisionError or OverflowError where it has no value.
    ball: of flint's `arb`, enclosing the value; raises Undefined where no number of the ball has one. It uses the methods
        of its arguments only, so that the table needs no flint.
    arity: how many numbers it takes.
    spellings: what else may be typed for it; its name always may, and is its text.
    exact: of numbers q·pi^n, giving such a number; None (or Irrational raised) where it is none.
    dimension: the power of its arguments' common dimension that the value has; None: it takes plain numbers only.
    derivatives: for each argument (x, y) the partial derivative as a formula; none where there is no simple one.
    slope: a bound on the derivative anywhere, where there is one.
    branches: whether it loses a sign or chooses: two formulas with it may be equal on one side only.
    angle: whether it takes an angle, for which a bare number says neither degrees nor radians.
    step: where it jumps between whole numbers: at whole numbers ("whole") or half way between them ("half"); "" where it does not.
    tex: what TeX calls it, or a form in which # stands for the argument; left out, its name.
    sympy: its name in sympy, or what makes sympy's expression of it; left out, its name.
    array: its name in numpy (which may lack it); left out, its name.
    """

    name: str
    double: Callable[..., float]
    ball: Callable[..., arb]
    arity: int = 1
    spellings: tuple[str, ...] = ()
    exact: Callable[..., RationalPi | None] = _irrational
    dimension: Fraction | int | None = None
    derivatives: tuple[str, ...] = ()
    slope: int | None = None
    branches: bool = False
    angle: bool = False
    step: Literal["", "whole", "half"] = ""
    tex: str = ""
    sympy: str | Callable[..., Any] = ""
    array: str = ""


FUNCTIONS: dict[str, Function] = {}
SPELLINGS: dict[str, str] = {}
"""What may be typed, and which function is meant: `log` is the natural logarithm, as in numpy and sympy."""


def register(row: Function) -> Function:
    """Makes a function known to everything that reads, evaluates or writes formulas. Raises ValueError for a name in use."""
    for spelling in (row.name, *row.spellings):
        if spelling in SPELLINGS:
            raise ValueError(f"the function {row.name}: {spelling} means {SPELLINGS[spelling]} already")
    FUNCTIONS[row.name] = row
    SPELLINGS.update(dict.fromkeys((row.name, *row.spellings), row.name))
    return row


def ball_root(ball: arb, degree: int) -> arb:
    """The root of what is not negative in the ball. Raises Undefined if all of it is negative."""
    if ball < 0:
        raise Undefined("the root of a negative number")
    if ball.contains(0):
        zero = type(ball)(0)
        return zero if ball.is_zero() else zero.union(ball.upper().root(degree))
    return ball.sqrt() if degree == 2 else ball.root(degree)


def _arc(ball: arb, arc: Callable[[arb], arb]) -> arb:
    """An inverse sine or cosine; a ball across 1 or -1 is cut there."""
    if abs(ball) > 1:
        raise Undefined("the inverse sine or cosine of a number beyond 1")
    if not ball.is_finite() or abs(ball) <= 1:
        return arc(ball)
    low = type(ball)(-1) if ball.contains(-1) else ball.lower()
    high = type(ball)(1) if ball.contains(1) else ball.upper()
    return arc(low).union(arc(high))


def _direction(y: arb, x: arb) -> arb:
    if y.is_zero() and x.is_zero():
        raise Undefined("a vector of length zero has no direction")
    return type(y).atan2(y, x)


def _logarithm(ball: arb) -> arb:
    if ball <= 0:
        raise Undefined("the logarithm of a number that is not positive")
    return ball.log()


def _gamma(ball: arb) -> arb:
    if ball <= 0 and ball.is_integer():
        raise Undefined("the gamma function has no value at 0, -1, -2 …")
    return ball.gamma()


def _rounded_down(number: Fraction) -> Fraction:
    return Fraction(math.floor(number))


def _rounded_up(number: Fraction) -> Fraction:
    return Fraction(math.ceil(number))


def _rounded(number: Fraction) -> Fraction:
    """The nearest whole number; the larger one of a half."""
    return Fraction(math.floor(number + HALF))


def _whole(nearest: Callable[[Fraction], Fraction]) -> Callable[[RationalPi], RationalPi | None]:
    """A step function of fractions; of a multiple of pi a ball tells."""
    return lambda x: RationalPi(nearest(x.ratio)) if not x.pi else None


def _round_in_sympy(x: Any) -> Any:
    import sympy

    return sympy.floor(x + sympy.Rational(1, 2))


NARROW = 1e-3  # of a ball across a step: a number not known well enough to say on which side it lies


def _floor(ball: arb) -> arb:
    """The whole numbers below those of the ball; nothing is known of a number next to a step."""
    if not ball.is_integer() and ball.contains_integer() and ball.upper() - ball.lower() < NARROW:
        return type(ball)("nan")
    return ball.floor()


def _log10_in_sympy(x: Any) -> Any:
    import sympy

    return sympy.log(x) / sympy.log(10)


def _at(number: Fraction | int, value: RationalPi) -> Callable[[RationalPi], RationalPi | None]:
    """Rational at one rational number only (for these functions by the theorem of Lindemann and Weierstrass)."""
    return lambda x: value if x.ratio == number and (x.pi == 0 or not number) else None


for _row in (
    Function(
        "sqrt",
        math.sqrt,
        lambda x: ball_root(x, 2),
        exact=lambda x: x ** RationalPi(HALF),
        dimension=HALF,
        derivatives=("1/(2*sqrt(x))",),
        branches=True,
        tex=r"\sqrt{#}",
    ),
    Function(
        "abs",
        math.fabs,
        lambda x: abs(x),
        spellings=("Abs", "fabs", "absolute"),
        exact=lambda x: RationalPi(abs(x.ratio), x.pi),
        dimension=1,
        slope=1,
        branches=True,
        tex=r"\left|#\right|",
        sympy="Abs",
    ),
    Function(
        "sin",
        math.sin,
        lambda x: x.sin(),
        exact=sine,
        derivatives=("cos(x)",),
        slope=1,
        angle=True,
    ),
    Function(
        "cos",
        math.cos,
        lambda x: x.cos(),
        exact=cosine,
        derivatives=("-sin(x)",),
        slope=1,
        angle=True,
    ),
    Function(
        "tan",
        math.tan,
        lambda x: x.tan(),
        exact=tangent,
        derivatives=("1/cos(x)^2",),
        angle=True,
        spellings=("tg",),
    ),
    Function(
        "asin",
        math.asin,
        lambda x: _arc(x, type(x).asin),
        exact=arc_sine,
        derivatives=("1/sqrt(1 - x^2)",),
        tex=r"\arcsin",
        array="arcsin",
        spellings=("arcsin", "invsin"),
    ),
    Function(
        "acos",
        math.acos,
        lambda x: _arc(x, type(x).acos),
        exact=arc_cosine,
        derivatives=("-1/sqrt(1 - x^2)",),
        tex=r"\arccos",
        array="arccos",
        spellings=("arccos", "invcos"),
    ),
    Function(
        "atan",
        math.atan,
        lambda x: x.atan(),
        exact=arc_tangent,
        derivatives=("1/(1 + x^2)",),
        slope=1,
        tex=r"\arctan",
        array="arctan",
        spellings=("arctan", "invtan"),
    ),
    Function(
        "atan2",
        math.atan2,
        _direction,
        2,
        dimension=0,
        derivatives=("y/(x^2 + y^2)", "-x/(x^2 + y^2)"),
        branches=True,
        tex=r"\mathrm{atan2}",
        array="arctan2",
        spellings=("arctan2",),
    ),
    Function("exp", math.exp, lambda x: x.exp(), exact=_at(0, ONE), derivatives=("exp(x)",), tex="e^{#}"),
    Function(
        "ln",
        math.log,
        _logarithm,
        spellings=("log", "Ln", "Log"),
        exact=_at(1, NOTHING),
        derivatives=("1/x",),
        sympy="log",
        array="log",
    ),
    Function(
        "log10",
        math.log10,
        lambda x: _logarithm(x) / type(x).const_log10(),
        exact=_at(1, NOTHING),
        derivatives=("1/(x*ln(10))",),
        tex=r"\log_{10}",
        sympy=_log10_in_sympy,
        spellings=("lg",),
    ),
    Function("sinh", math.sinh, lambda x: x.sinh(), exact=_at(0, NOTHING), derivatives=("cosh(x)",)),
    Function("cosh", math.cosh, lambda x: x.cosh(), exact=_at(0, ONE), derivatives=("sinh(x)",)),
    Function(
        "tanh", math.tanh, lambda x: x.tanh(), exact=_at(0, NOTHING), derivatives=("1/cosh(x)^2",), slope=1
    ),
    Function("gamma", math.gamma, _gamma, tex=r"\Gamma", spellings=("Gamma",)),
    Function(
        "min",
        min,
        lambda x, y: x.min(y),
        2,
        spellings=("Min", "minimum"),
        exact=smallest,
        dimension=1,
        slope=1,
        branches=True,
        sympy="Min",
        array="minimum",
    ),
    Function(
        "max",
        max,
        lambda x, y: x.max(y),
        2,
        spellings=("Max", "maximum"),
        exact=largest,
        dimension=1,
        slope=1,
        branches=True,
        sympy="Max",
        array="maximum",
    ),
    Function(
        "floor",
        lambda x: float(math.floor(x)),
        _floor,
        exact=_whole(_rounded_down),
        branches=True,
        step="whole",
        tex=r"\left\lfloor #\right\rfloor",
    ),
    Function(
        "ceil",
        lambda x: float(math.ceil(x)),
        lambda x: -_floor(-x),
        spellings=("ceiling",),
        exact=_whole(_rounded_up),
        branches=True,
        step="whole",
        tex=r"\left\lceil #\right\rceil",
        sympy="ceiling",
    ),
    Function(
        "round",
        lambda x: float(math.floor(x + 0.5)),
        lambda x: _floor(x + 0.5),
        exact=_whole(_rounded),
        branches=True,
        step="half",
        tex=r"\operatorname{round}\left(#\right)",
        sympy=_round_in_sympy,
    ),
):
    register(_row)


def steps() -> frozenset[str]:
    """The functions that jump between whole numbers."""
    return frozenset(name for name, row in FUNCTIONS.items() if row.step)
