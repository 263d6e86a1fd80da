"""Functions that numpy and sympy have and a formula says by others: `cot`, `atanh`, `hypot`, `log2`, `radians`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from corollary.formula.ast import ONE, TWO, Call, Expr, Name, Negative, Number, Power, Product, Quotient, Sum
from corollary.formula.functions import FUNCTIONS, SPELLINGS, steps

DEGREE = Quotient(Name("pi"), Number(Fraction(180)))


@dataclass(frozen=True, slots=True)
class Abbreviation:
    """`formula` makes of the arguments what the function stands for; `angle`: a bare number in it has no unit."""

    arity: int
    formula: Callable[[tuple[Expr, ...]], Expr]
    angle: bool = False


def _inverse(function: str, *, angle: bool = True) -> Abbreviation:
    return Abbreviation(1, lambda a: Quotient(ONE, Call(function, (a[0],))), angle)


def _power_of(base: int) -> Abbreviation:
    return Abbreviation(1, lambda a: Power(Number(Fraction(base)), a[0]))


def _of_degrees(function: str) -> Abbreviation:
    return Abbreviation(1, lambda a: Call(function, (Product((a[0], DEGREE)),)))


def _squared(x: Expr) -> Expr:
    return Power(x, TWO)


def _ln(x: Expr) -> Expr:
    return Call("ln", (x,))


def _root(x: Expr) -> Expr:
    return Call("sqrt", (x,))


ROWS: dict[str, Abbreviation] = {
    "cot cotan": _inverse("tan"),
    "sec": _inverse("cos"),
    "csc cosec": _inverse("sin"),
    "arccot acot": Abbreviation(1, lambda a: Call("atan", (Quotient(ONE, a[0]),))),
    "arcsec asec": Abbreviation(1, lambda a: Call("acos", (Quotient(ONE, a[0]),))),
    "arccsc acsc": Abbreviation(1, lambda a: Call("asin", (Quotient(ONE, a[0]),))),
    "coth": _inverse("tanh", angle=False),
    "sech": _inverse("cosh", angle=False),
    "csch": _inverse("sinh", angle=False),
    "asinh arcsinh arsinh": Abbreviation(1, lambda a: _ln(Sum((a[0], _root(Sum((_squared(a[0]), ONE))))))),
    "acosh arccosh arcosh": Abbreviation(
        1, lambda a: _ln(Sum((a[0], _root(Sum((_squared(a[0]), Negative(ONE)))))))
    ),
    "atanh arctanh artanh": Abbreviation(
        1, lambda a: Quotient(_ln(Quotient(Sum((ONE, a[0])), Sum((ONE, Negative(a[0]))))), TWO)
    ),
    "cbrt": Abbreviation(1, lambda a: Power(a[0], Quotient(ONE, Number(Fraction(3))))),
    "hypot": Abbreviation(2, lambda a: _root(Sum((_squared(a[0]), _squared(a[1]))))),
    "square": Abbreviation(1, lambda a: _squared(a[0])),
    "pow power": Abbreviation(2, lambda a: Power(a[0], a[1])),
    "log2 lb": Abbreviation(1, lambda a: Quotient(_ln(a[0]), _ln(TWO))),
    "log1p": Abbreviation(1, lambda a: _ln(Sum((ONE, a[0])))),
    "expm1": Abbreviation(1, lambda a: Sum((Call("exp", (a[0],)), Negative(ONE)))),
    "exp2": _power_of(2),
    "sign sgn": Abbreviation(1, lambda a: Quotient(a[0], Call("abs", (a[0],)))),
    "radians deg2rad": Abbreviation(1, lambda a: Product((a[0], DEGREE))),
    "rad2deg": Abbreviation(1, lambda a: Quotient(a[0], DEGREE)),
    "sind": _of_degrees("sin"),
    "cosd": _of_degrees("cos"),
    "tand": _of_degrees("tan"),
}
ABBREVIATIONS = {name: row for names, row in ROWS.items() for name in names.split()}


def function_words() -> dict[str, str]:
    """Everything that may be typed for a function, and what it is called here."""
    return {name: name for name in ABBREVIATIONS} | SPELLINGS


def calculator_words() -> dict[str, str]:
    """The same without steps: `floor` and `round` are words of the language, and functions before a bracket only."""
    return {word: name for word, name in function_words().items() if name not in steps()}


def arity(function: str) -> int:
    """How many numbers a function takes; 0 for what only laws may say, which takes any number of them."""
    row = ABBREVIATIONS.get(function) or FUNCTIONS.get(function)
    return row.arity if row else 0


def of_angle(function: str) -> bool:
    """Whether a function takes an angle."""
    return (ABBREVIATIONS.get(function) or FUNCTIONS[function]).angle


def applied(function: str, arguments: tuple[Expr, ...]) -> Expr:
    """The function of its arguments; `log(x, b)` has a base of its own."""
    if function in FUNCTIONS:
        if function == "ln" and len(arguments) == 2:
            return Quotient(_ln(arguments[0]), _ln(arguments[1]))
        return Call(function, arguments)
    return (
        ABBREVIATIONS[function].formula(arguments) if function in ABBREVIATIONS else Call(function, arguments)
    )
