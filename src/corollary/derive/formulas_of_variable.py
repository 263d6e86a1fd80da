"""Formulas of a variable in a worked solution: U(t) in letters, and with the numbers of the sheet, without a value."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress

from corollary.derive.numbers_in_formulas import broken
from corollary.derive.solution import ClosedForms, Unknown
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr, names
from corollary.formula.errors import NotAvailable
from corollary.formula.latex import latex, letter
from corollary.messages import catalogue
from corollary.problem.problem import Problem

_ = catalogue(__name__)


def formulas_of_variable(
    find: Unknown, problem: Problem, known: Mapping[str, str], si: Mapping[str, float]
) -> list[str]:
    """What depends on a variable, a formula for each component. `known` are numbers as they stand in formulas, `si` values of all letters,
    those of this step among them, at some place of the domain."""
    assert isinstance(find.local, ClosedForms)
    trees = find.in_givens or find.local.trees
    variables = [each.symbol for each in problem.variables]
    lines: list[str] = []
    for place, name in enumerate(find.names):
        tree = printed_form(find.printed_in_givens, trees, place, si[name], si)
        of = ", ".join(letter(each) for each in variables if each in names(tree))
        left = f"{letter(name)}({of})" if of else letter(name)
        in_letters, in_numbers = latex(tree), latex(tree, known)
        printed = [f"{letter(each.name)}({letter(each.letter)})" for each in find.functions]
        if left not in printed or in_letters not in map(
            latex, (each.printed for each in find.functions if each.printed)
        ):
            lines += [*(f"$${line}$$" for line in broken([left, in_letters])), ""]
        if in_numbers != in_letters:
            lines += [_("With the numbers:"), "", *(f"$${line}$$" for line in broken([left, in_numbers])), ""]
    return lines


def printed_form(
    forms: Sequence[Expr] | None, trees: Sequence[Expr], place: int, value: float, si: Mapping[str, float]
) -> Expr:
    """The form to print, where it has the value for these numbers; else the formula itself. A form may rest on a sign."""
    if forms:
        with suppress(NotAvailable, KeyError, ValueError, ArithmeticError, TypeError):
            if math.isclose(
                ready(forms[place], DOUBLES)(si), value, rel_tol=1e-6, abs_tol=1e-9 * abs(value) or 1e-12
            ):
                return forms[place]
    return trees[place]
