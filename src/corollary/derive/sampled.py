"""Whether an equation holds, where algebra does not see it: its terms at sample points, each certified to 30 digits."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportArgumentType=false, reportAttributeAccessIssue=false, reportAssignmentType=false, reportReturnType=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportCallIssue=false, reportOperatorIssue=false

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import chain

import sympy

from corollary.derive.known import Known, Point, at, vanishes

RESIDUAL = sympy.Float("1e-20")  # of the terms of an equation, each known to 30 digits
FREE = (sympy.Rational(3, 7), sympy.Rational(8, 5), sympy.Rational(11, 13), sympy.Rational(17, 9))
"""Numbers for letters that have none yet."""
SHARES = (sympy.Rational(1, 3), sympy.Integer(1))
SHORT = 40  # operations: what sympy simplifies quickly


def holds(
    residual: sympy.Expr,
    known: Known,
    letters: Collection[sympy.Symbol] = (),
    places: Sequence[sympy.Expr] = (),
) -> bool:
    """Whether an expression vanishes: by algebra, or at the sample points, its terms certified to 30 digits.

    `letters` are those of functions: they are tried at the `places` where the laws take these, and at a third of them.
    """
    in_givens = known.in_givens(residual)
    if sympy.expand(in_givens) == 0 or (sympy.count_ops(in_givens) < SHORT and vanishes(in_givens)):
        return True
    terms = sympy.Add.make_args(sympy.expand(in_givens, deep=False))
    moments = [known.in_givens(place) for place in places if place != 0][:3] or [FREE[0]]
    for point in known.points:
        for moment in moments:
            for share in SHARES:
                now = {letter: share * numbered(moment, point) for letter in letters}
                numbers = [at(numbered(term.xreplace(now), point), point) for term in terms]
                if not abs(sum(numbers)) <= RESIDUAL * sum(map(abs, numbers)):
                    return False
    return True


def numbered(expression: sympy.Expr, point: Point) -> sympy.Expr:
    """The expression with a number for each letter that has none at a point."""
    missing = sorted(expression.free_symbols - point.values.keys(), key=str)
    return expression.xreplace(dict(zip(missing, chain(FREE, FREE), strict=False)))
