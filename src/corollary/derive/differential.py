"""Ordinary differential equations solved from a table of forms; whoever uses a solution puts it back first.

Forms: y' = f(x); y' = a(x) + b y; y' = a + b y + c y^2 (quadratic drag, logistic growth); y'' + p y' + q y = r with constants
(oscillations, damped or not; motion with linear drag); what is none of them is left to sympy's `dsolve`.
"""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportArgumentType=false, reportAttributeAccessIssue=false, reportAssignmentType=false, reportReturnType=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportCallIssue=false, reportOperatorIssue=false, reportOptionalMemberAccess=false, reportOptionalOperand=false

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy

from corollary.messages import N_

Sign = Callable[[sympy.Expr], int | None]
"""Whether an expression is positive (1), zero (0) or negative (-1), the same for all numbers; None where it is neither."""


class NotSolved(ValueError):
    """No form of the table fits; one sentence says what was tried."""


@dataclass(frozen=True, slots=True)
class General:
    """A general solution: y at any `of`, by its values where `of` is `start`: y itself, and y' where the equation is of second order.

    `form` is what a textbook calls the equation.
    """

    formula: sympy.Expr
    values: tuple[sympy.Symbol, ...]
    form: str


def general(equation: sympy.Expr, y: sympy.Expr, x: sympy.Symbol, start: sympy.Expr, sign: Sign) -> General:
    """The general solution of `equation` = 0 for the function y of x. Raises NotSolved."""
    order = sympy.ode_order(equation, y)
    highest = sympy.Derivative(y, x) if order == 1 else sympy.Derivative(y, (x, order))
    if order not in (1, 2):
        raise NotSolved(f"its {order}rd derivative is in the law; derivatives up to the second can be solved")
    unknown, rate, top = sympy.Dummy("y", real=True), sympy.Dummy("v", real=True), sympy.Dummy("a", real=True)
    bare = equation.xreplace({highest: top}).xreplace({sympy.Derivative(y, x): rate}).xreplace({y: unknown})
    roots = sympy.solve(bare, top)
    if len(roots) != 1:
        raise NotSolved(
            "its highest derivative stands in a power or a root; state the law for one sign of it"
        )
    right = sympy.expand(roots[0])
    values = (sympy.Dummy("y0", real=True), sympy.Dummy("v0", real=True))[:order]
    known = (
        _first_order(right, unknown, x, start, values[0], sign)
        if order == 1
        else _second_order(right, unknown, rate, x, start, values, sign)
    )
    if known is not None:
        return General(known[0], values, known[1])
    return General(
        _by_sympy(equation, y, x, start, values), values, N_("by separation or an integrating factor")
    )


def _first_order(
    right: sympy.Expr,
    y: sympy.Symbol,
    x: sympy.Symbol,
    start: sympy.Expr,
    y0: sympy.Symbol,
    sign: Sign,
) -> tuple[sympy.Expr, str] | None:
    """y' = right."""
    if not right.is_polynomial(y) or (degree := sympy.degree(right, y)) > 2:
        return None
    if not right.has(y):
        return y0 + _from(right, x, start), N_("integrated once")
    a, b, c = (right.coeff(y, power) for power in (0, 1, 2))
    if b.has(x) or c.has(x):
        return None
    elapsed = x - start
    if degree == 1 and not a.has(x):
        rest = -a / b
        return rest + (y0 - rest) * sympy.exp(b * elapsed), N_("linear, of first order")
    if degree == 1:
        driven = sympy.exp(b * elapsed) * _from(sympy.expand(a * sympy.exp(-b * (x - start))), x, start)
        return y0 * sympy.exp(b * elapsed) + driven, N_("linear, of first order")
    if a.has(x):
        return None
    middle = -b / (2 * c)  # y = middle + u, and u' = drive + c u^2
    drive, u0 = sympy.factor(a - b**2 / (4 * c)), y0 - middle
    form = N_("separable, with a square")
    match sign(drive / c):
        case 0:
            return middle + u0 / (1 - c * u0 * elapsed), form
        case -1:
            limit = sympy.sqrt(sympy.factor(-drive / c))
            ratio = sympy.tanh(drive * elapsed / limit)
            return middle + limit * (u0 + limit * ratio) / (limit + u0 * ratio), form
        case 1:
            scale = sympy.sqrt(sympy.factor(drive / c))
            ratio = sympy.tan(drive * elapsed / scale)
            return middle + scale * (u0 + scale * ratio) / (scale - u0 * ratio), form
        case _:
            raise NotSolved(_undecided(drive / c))


def _second_order(
    right: sympy.Expr,
    y: sympy.Symbol,
    rate: sympy.Symbol,
    x: sympy.Symbol,
    start: sympy.Expr,
    values: tuple[sympy.Symbol, ...],
    sign: Sign,
) -> tuple[sympy.Expr, str] | None:
    """y'' = right, linear in y and y' with constant coefficients."""
    y0, v0 = values
    elapsed = x - start
    p, q = -right.coeff(rate, 1), -right.coeff(y, 1)
    r = sympy.expand(right + p * rate + q * y)
    if any(each.has(y, rate) for each in (p, q, r)) or p.has(x) or q.has(x):
        return None
    if p == 0 and q == 0:
        return y0 + v0 * elapsed + _from(_from(r, x, start), x, start), N_("integrated twice")
    if r.has(x):
        return None
    if q == 0:
        last = r / p
        fading = (1 - sympy.exp(-p * elapsed)) / p
        return y0 + last * elapsed + (v0 - last) * fading, N_("linear in the velocity")
    rest, half = r / q, p / 2
    u0, push = y0 - rest, v0 + half * (y0 - rest)
    envelope = sympy.exp(-half * elapsed)
    form = N_("a damped oscillator") if p != 0 else N_("a harmonic oscillator")
    match sign(q - half**2):
        case 1:
            w = sympy.sqrt(sympy.factor(q - half**2))
            swing = u0 * sympy.cos(w * elapsed) + push / w * sympy.sin(w * elapsed)
        case -1:
            s = sympy.sqrt(sympy.factor(half**2 - q))
            swing = u0 * sympy.cosh(s * elapsed) + push / s * sympy.sinh(s * elapsed)
        case 0:
            swing = u0 + push * elapsed
        case _:
            raise NotSolved(_undecided(q - half**2))
    return rest + envelope * swing, form


def _from(integrand: sympy.Expr, x: sympy.Symbol, start: sympy.Expr) -> sympy.Expr:
    """The integral from `start` to x."""
    inside = sympy.Dummy(x.name, real=True)
    found = generic(sympy.integrate(integrand.subs(x, inside), (inside, start, x)))
    if found.has(sympy.Integral):
        raise NotSolved(f"the integral of {integrand} over {x} has no closed form")
    return found


def generic(expression: sympy.Expr) -> sympy.Expr:
    """Of an integral that sympy tells by cases, the case in which nothing that may be anything is zero."""

    def branch(piecewise: sympy.Piecewise) -> sympy.Expr:
        return next(
            (one for one, case in piecewise.args if isinstance(case, sympy.Ne)), piecewise.args[-1][0]
        )

    return expression.replace(lambda each: isinstance(each, sympy.Piecewise), branch)


def _by_sympy(
    equation: sympy.Expr, y: sympy.Expr, x: sympy.Symbol, start: sympy.Expr, values: tuple[sympy.Symbol, ...]
) -> sympy.Expr:
    """What `dsolve` finds, if it finds one explicit solution."""
    conditions = {y.subs(x, start): values[0]}
    if len(values) == 2:
        conditions[sympy.Derivative(y, x).subs(x, start)] = values[1]
    try:
        found = sympy.dsolve(equation, y, ics=conditions)
    except (NotImplementedError, ValueError, TypeError, AttributeError) as error:
        raise NotSolved("it is none of the forms that can be solved") from error
    if isinstance(found, list) or found.lhs != y or found.rhs.has(y.func, sympy.Integral):
        raise NotSolved("it has no single explicit solution in formulas")
    return found.rhs


def _undecided(what: sympy.Expr) -> str:
    return (
        f"whether {sympy.factor(what)} is positive decides what kind of motion it is, and that differs among the numbers drawn; "
        "bound them by require:, or state each kind as a case"
    )
