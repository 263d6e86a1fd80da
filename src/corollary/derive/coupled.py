"""Two linear differential equations of two functions, solved in the combinations of both that move by themselves.

With u = (y, z): u' = M u + c, or u'' + p u' = M u + c with one damping p for both. A row l with l M = mu l makes
w = l u a function of its own: w' = mu w + l c, one of the forms of `differential` (normal coordinates; Goldstein,
Classical Mechanics, section 6.3). Where no such rows are real, as in a circuit that swings, the first function is found from an
equation of second order.
"""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportArgumentType=false, reportAttributeAccessIssue=false, reportAssignmentType=false, reportReturnType=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportCallIssue=false, reportOperatorIssue=false, reportOptionalMemberAccess=false, reportOptionalOperand=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy
from sympy.solvers.solveset import NonlinearError

from corollary.derive.differential import NotSolved, Sign, general
from corollary.derive.known import simplest
from corollary.messages import N_


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
                N_("one of two coupled ones, solved in the combinations of both that move by themselves"),
            )
        case -1 | 0 if system.order == 1 and sign(b):
            return Generally(
                _by_elimination(system, x, start, values, sign),
                values,
                N_("one of two coupled ones, made one of second order"),
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
