"""Numbers, formulas and conditions of an author's Python code, exactly as they were typed."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Real
from typing import Any, cast

import sympy
from mpmath.libmp import prec_to_dps, to_rational, to_str
from sympy.logic.boolalg import Boolean, BooleanAtom, BooleanFunction

ARITHMETIC = (
    2  # units in the last place by which a product of typed decimals may be off: 0.1*3 is 0.30000000000000004
)
SPARE = 3  # decimal places: of the numbers that nobody typed, one in a thousand is so near a decimal that is shorter by these
LARGEST_DENOMINATOR = 10_000  # of a fraction that is recognised in the advice


class NotTyped(ValueError):
    """A number or formula of Python's that is no formula here, such as a decimal of which nobody sees which number was meant."""


def as_expression(value: object) -> sympy.Expr:
    """A number or a formula of an author's in sympy; 273.15 is 27315/100, as it is in a formula's text.

    Raises TypeError for what is neither, NotTyped for a number that is infinite, complex, or rounded by Python's own arithmetic, and
    for a Piecewise.
    """
    found: Any = value
    match value:
        case sympy.Expr():
            pass
        case str():
            raise TypeError(
                f"{value!r} is a text where a number or a formula belongs; write it without quotation marks"
            )
        case bool() | Boolean():
            raise TypeError(f"{value} is a truth or a condition where a number or a formula belongs")
        case Integral() | Fraction():
            found = _rational(Fraction(int(value.numerator), int(value.denominator)))
        case Decimal() if value.is_finite():
            found = _rational(Fraction(value))
        case float() | Decimal():
            found = sympy.Float(float(value))
        case Real():  # of numpy, in its own precision
            found = sympy.sympify(value)
        case complex():
            raise NotTyped(f"{value} is complex, and every quantity here is real")
        case _:
            pass
    if not isinstance(found, sympy.Expr):
        raise TypeError(f"{value!r} is neither a number nor a formula")
    _refuse_unreal(found)
    return cast(sympy.Expr, exact(found))


def as_condition(value: object) -> Boolean | bool:
    """A condition of an author's, its decimals as they were typed: a relation, several joined, or True or False.

    Raises TypeError for what is none, and what `as_expression` raises.
    """
    if isinstance(value, bool | BooleanAtom):
        return value
    if not isinstance(value, sympy.core.relational.Relational | BooleanFunction):
        raise TypeError(
            f"{value!r} is not a condition; write a relation, such as F > mu*N, or several as And(…, …)"
        )
    _refuse_unreal(value)
    return cast(Boolean, exact(value))


def _refuse_unreal(found: sympy.Basic) -> None:
    """Raises NotTyped for what holds a number that no quantity can be; an infinity may stand alone, as the end of a limit."""
    if found.has(sympy.nan, sympy.zoo) or (
        found.has(sympy.oo, -sympy.oo) and found not in (sympy.oo, -sympy.oo)
    ):
        raise NotTyped(f"{found} holds what is not a number (a division by zero, an infinity or a NaN)")
    if found.has(sympy.I):
        raise NotTyped(f"{found} is complex, and every quantity here is real")
    if found.has(sympy.Piecewise):
        raise NotTyped(
            "a Piecewise has no place in a formula; state each of its pieces as a case with a step of its own: "
            'cases(case("it rests", F <= mu*N, step(…)), case("it slides", F > mu*N, step(…)))'
        )


def exact(expression: Any) -> Any:
    """A sympy expression or relation with each decimal as the rational that was typed: 1.2 is 6/5. Raises NotTyped."""
    decimals = expression.atoms(sympy.Float)
    return expression.xreplace({each: typed(each) for each in decimals}) if decimals else expression


def typed(decimal: sympy.Float) -> sympy.Rational:
    """The shortest decimal that Python reads as this number. Raises NotTyped where it has more figures than a double is sure of."""
    found: Any = decimal
    bits, parts = found._prec, found._mpf_
    value = Fraction(*to_rational(parts))
    if value.denominator == 1 and abs(value) < 2**bits:
        return _rational(value)
    last_place, figures = abs(value) / 2 ** (bits - 1), prec_to_dps(bits)
    for count in range(1, figures + 1):
        text = str(to_str(parts, count))
        written = Fraction(text)
        near = count <= figures - SPARE and abs(written - value) <= ARITHMETIC * last_place
        if near or sympy.Float(text, precision=bits) == decimal:
            return _rational(written)
    raise NotTyped(_advice(float(decimal)))


def _rational(value: Fraction) -> sympy.Rational:
    return cast(sympy.Rational, sympy.Rational(value.numerator, value.denominator))


def _advice(value: float) -> str:
    """What to write for a number such as 1/3 that Python has worked out already."""
    number = f"{value!r} is a number that Python has worked out and rounded"
    for form, by, squared in (("{}", 1.0, False), ("{}*pi", float(sympy.pi), False), ("sqrt({})", 1.0, True)):
        wanted = value * abs(value) if squared else value / by
        found = Fraction(wanted).limit_denominator(LARGEST_DENOMINATOR)
        if found and abs(float(found) - wanted) <= 1e-15 * abs(wanted) and (not squared or value > 0):
            written = (
                str(found) if found.denominator == 1 else f"Rational({found.numerator}, {found.denominator})"
            )
            return f"{number}; write {form.format(written)}, with the names of sympy"
    return f"{number}; write the exact formula with the names of sympy, such as Rational(1, 3) or sqrt(2)"
