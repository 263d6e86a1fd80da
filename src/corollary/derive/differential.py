"""Differential equations solved from a table of forms: ordinary ones, and two linear ones together."""

# pyright: reportArgumentType=false, reportAssignmentType=false, reportAttributeAccessIssue=false, reportCallIssue=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportMissingTypeArgument=false, reportOperatorIssue=false, reportOptionalMemberAccess=false, reportOptionalOperand=false, reportReturnType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import sympy
from sympy.solvers.solveset import NonlinearError

from corollary.derive.assumptions import simplest
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


@dataclass(frozen=True, slots=True)
class Generally:
    """General solutions of one function or of two, by their values at the start, and those of their derivatives where these are
    needed."""

    formulas: tuple[sympy.Expr, ...]
    values: tuple[sympy.Symbol, ...]
    form: str

    def shortest(self, formula: sympy.Expr, x: sympy.Symbol) -> sympy.Expr:
        """One of the formulas with its values put in, tidied up."""
        return simplest(formula) if len(self.formulas) == 1 else _in_waves(formula, x)


@dataclass(frozen=True, slots=True)
class _System:
    """u^(order) + damping u' = matrix u + rest."""

    order: int
    damping: sympy.Expr
    matrix: sympy.Matrix
    rest: sympy.Matrix


def generally(
    equations: Sequence[sympy.Expr],
    functions: Sequence[sympy.Expr],
    x: sympy.Symbol,
    start: sympy.Expr,
    sign: Sign,
) -> Generally:
    """The general solution of one equation, or two, `equations` = 0 for as many functions of x. Raises NotSolved."""
    if len(functions) == 1:
        alone = general(equations[0].doit(), functions[0], x, start, sign)
        return Generally((alone.formula,), alone.values, alone.form)
    system = _system(equations, functions, x)
    (a, b), (c, d) = system.matrix.tolist()
    names = ["y0", "z0"] if system.order == 1 else ["y0", "z0", "y1", "z1"]
    values = tuple(sympy.Dummy(name, real=True) for name in names)
    apart = sympy.factor((a - d) ** 2 + 4 * b * c)
    match sign(apart):
        case 1:
            return Generally(
                _by_modes(system, apart, x, start, values, sign),
                values,
                N_("one of two coupled equations, solved in decoupled combinations of both"),
            )
        case -1 | 0 if system.order == 1 and sign(b):
            return Generally(
                _by_elimination(system, x, start, values, sign),
                values,
                N_("one of two coupled equations, combined into one of second order"),
            )
        case None:
            raise NotSolved(
                f"whether {apart} is positive decides how the two move, and that differs among the numbers drawn; "
                "bound them by require:, or state each kind as a case"
            )
        case _:
            raise NotSolved("the two have no two combinations that move by themselves")


def _system(equations: Sequence[sympy.Expr], functions: Sequence[sympy.Expr], x: sympy.Symbol) -> _System:
    orders = {sympy.ode_order(each, y) for each in equations for y in functions} - {0}
    order = max(orders)
    if order > 2:
        raise NotSolved("derivatives up to the second can be solved")
    top, rate, place = (tuple(sympy.Dummy(name, real=True) for _ in functions) for name in "avu")
    bare = [
        each.xreplace({sympy.Derivative(y, (x, 2)): top[k] for k, y in enumerate(functions)})
        .xreplace({sympy.Derivative(y, x): (rate if order == 2 else top)[k] for k, y in enumerate(functions)})
        .xreplace({y: place[k] for k, y in enumerate(functions)})
        for each in (each.doit() for each in equations)
    ]
    try:
        ((first, second),) = sympy.linsolve(bare, top)
    except (ValueError, NonlinearError):
        raise NotSolved(
            "each of them needs a highest derivative of its own, which stands in no power"
        ) from None
    right = sympy.Matrix([sympy.expand(first), sympy.expand(second)])
    matrix, turned = right.jacobian(place), right.jacobian(rate)
    rest = (right - matrix * sympy.Matrix(place) - turned * sympy.Matrix(rate)).applyfunc(sympy.expand)
    if right.has(*top) or any(each.has(x, *place, *rate) for part in (matrix, turned, rest) for each in part):
        raise NotSolved("only linear ones with constant coefficients can be solved together")
    damping = sympy.factor(-turned[0, 0])
    if (turned + damping * sympy.eye(2)).applyfunc(sympy.factor) != sympy.zeros(2, 2):
        raise NotSolved(
            "with damping they can be solved together where it is the same for both, and of each its own"
        )
    return _System(order, damping, matrix.applyfunc(sympy.factor), rest.applyfunc(sympy.factor))


def _by_modes(
    system: _System,
    apart: sympy.Expr,
    x: sympy.Symbol,
    start: sympy.Expr,
    values: tuple[sympy.Symbol, ...],
    sign: Sign,
) -> tuple[sympy.Expr, sympy.Expr]:
    """Each combination solved by itself, and both put together again."""
    (a, b), (c, d) = system.matrix.tolist()
    root = sympy.sqrt(apart)
    rows: list[sympy.Matrix] = []
    modes: list[sympy.Expr] = []
    for mu in (sympy.factor((a + d + root) / 2), sympy.factor((a + d - root) / 2)):
        # l M = mu l: l = (c, mu - a), or (mu - d, b); the one that cannot be zero
        row = sympy.Matrix([[c, mu - a]]) if c != 0 else sympy.Matrix([[mu - d, b]]) if b != 0 else None
        if row is None or all(sympy.factor(each) == 0 for each in row):
            raise NotSolved("they are not coupled; state each by itself")
        if c != 0:
            row = row / c
        row = row.applyfunc(sympy.factor)
        at_start = [(row * sympy.Matrix(values[k : k + 2]))[0] for k in range(0, len(values), 2)]
        coefficients = [mu, -system.damping, (row * system.rest)[0]]
        rows.append(row)
        modes.append(_alone(system.order, coefficients, x, start, at_start, sign))
    back = sympy.Matrix.vstack(*rows).inv().applyfunc(sympy.factor)
    y, z = back * sympy.Matrix(modes)
    return y, z


def _by_elimination(
    system: _System, x: sympy.Symbol, start: sympy.Expr, values: tuple[sympy.Symbol, ...], sign: Sign
) -> tuple[sympy.Expr, sympy.Expr]:
    """y' = a y + b z + r gives z; put into the other, y is a function by itself."""
    (a, b), (c, d) = system.matrix.tolist()
    r, s = system.rest
    y0, z0 = values
    coefficients = [b * c - a * d, a + d, b * s - d * r]
    found = _alone(2, coefficients, x, start, [y0, a * y0 + b * z0 + r], sign)
    return found, (sympy.diff(found, x) - a * found - r) / b


def _alone(
    order: int,
    coefficients: Sequence[sympy.Expr],
    x: sympy.Symbol,
    start: sympy.Expr,
    at_start: Sequence[sympy.Expr],
    sign: Sign,
) -> sympy.Expr:
    """w at any x, where w^(order) = c0 w + c1 w' + c2 and w (with w', for the second order) begins so."""
    w = sympy.Function("w", real=True)(x)
    # Short letters while it is solved; a zero must be seen, as that of two masses that nothing else holds.
    full = {sympy.Dummy(f"c{k}", real=True): sympy.factor(each) for k, each in enumerate(coefficients)}
    c0, c1, c2 = (each if sign(what) != 0 else sympy.S.Zero for each, what in full.items())
    damped = c1 * sympy.Derivative(w, x) if order == 2 else sympy.S.Zero
    equation = sympy.Derivative(w, (x, order)) - damped - c0 * w - c2
    own = general(equation, w, x, start, lambda each: sign(each.xreplace(full)))
    return own.formula.xreplace({**dict(zip(own.values, at_start, strict=True)), **full})


def _in_waves(formula: sympy.Expr, x: sympy.Symbol) -> sympy.Expr:
    """The sum of what changes with x, each factor before it simplified by itself: to simplify the whole takes a minute."""
    factors: dict[sympy.Expr, sympy.Expr] = {}
    for term in sympy.Add.make_args(sympy.expand_mul(formula)):
        fixed, wave = term.as_independent(x, as_Add=False)
        factors[wave] = factors.get(wave, sympy.S.Zero) + fixed
    return sympy.factor_terms(sympy.Add(*(sympy.factor(fixed) * wave for wave, fixed in factors.items())))
