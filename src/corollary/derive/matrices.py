"""Matrices in worked solutions: letters, formulas and numbers, each in one bracket."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.derive.numbers_in_formulas import quantity, width
from corollary.formula.ast import Expr, Number, names
from corollary.formula.latex import latex, letter
from corollary.problem.part import Part
from corollary.units.unit import PURE, Unit
from corollary.units.unit import latex as unit_latex

WIDEST_ENTRY = 20  # letters: what fits several times on a line


def is_matrix(part: Part) -> bool:
    """True for a table whose rows and columns have numbers in place of names, and one unit."""
    return (
        bool(part.rows)
        and not part.column_units
        and all(each.isdecimal() for each in (*part.rows, *part.columns))
    )


def matrix_steps(
    found: Sequence[str], formulas: Sequence[Expr], numbers: Sequence[float], part: Part, unit: Unit
) -> list[str]:
    """The sides of one chain of equalities: the letters, the formulas where they are short, the numbers with their unit."""
    columns = len(part.columns)
    steps = [_matrix([letter(name) for name in found], columns)]
    written = [latex(each) for each in formulas]
    if any(names(each) for each in formulas) and all(width(each) <= WIDEST_ENTRY for each in written):
        steps.append(_matrix(written, columns))
    exact = all(isinstance(each, Number) for each in formulas) and unit == PURE
    entries = written if exact else [quantity(unit.from_si(value), PURE) for value in numbers]
    symbol = unit_latex(unit)
    steps.append(_matrix(entries, columns) + (rf"\,{symbol}" if symbol else ""))
    return steps


def _matrix(entries: Sequence[str], columns: int) -> str:
    rows = (" & ".join(entries[start : start + columns]) for start in range(0, len(entries), columns))
    return r"\begin{pmatrix}" + r" \\ ".join(rows) + r"\end{pmatrix}"
