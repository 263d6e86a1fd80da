"""Improper integrals: whether they converge, and their values by quadrature."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy

from corollary.formula.from_sympy import as_typed

ENDS = 80.0
"""The integral runs over t = low + e^u with u from -80 to 80, so that no scale has to be known before."""
PANELS, NODES = 214, 64
WITHOUT_VALUE = (sympy.oo, -sympy.oo, sympy.zoo, sympy.nan)


def improper(side: sympy.Expr) -> list[sympy.Integral]:
    """The integrals in an expression of which a limit is infinite."""
    return [each for each in side.atoms(sympy.Integral) if any(map(_infinite, _over(each)[1:]))]


def refuse_divergent(side: sympy.Expr) -> None:
    """Raises ValueError for an improper integral that has no finite value, or has one for some numbers only."""
    for node in improper(side):
        found: Any = node.doit()
        if found.has(*WITHOUT_VALUE) or found.has(sympy.AccumBounds):
            raise ValueError(
                f"{_written(node)} diverges: it has no finite value; correct what is integrated, or integrate up to a finite limit"
            )
        for piecewise in found.atoms(sympy.Piecewise):
            conditions = [condition for value, condition in piecewise.args if not value.has(sympy.Integral)]
            if len(conditions) < len(piecewise.args) and conditions:
                raise ValueError(
                    f"{_written(node)} has a finite value only where {conditions[0]}; say in require: of the problem "
                    "which letters are positive"
                )


def _written(node: sympy.Integral) -> str:
    letter, low, high = _over(node)
    return as_typed(f"int({node.function}, {letter}, {low}, {high})")


def by_quadrature(node: sympy.Integral) -> float:
    """The value of an improper integral that has one, with numbers for all letters; places without a double count nothing."""
    letter, low, high = _over(node)
    integrand = sympy.lambdify(letter, node.function, modules=["scipy", "numpy"])
    if low == -sympy.oo and high == sympy.oo:
        return _towards(integrand, 0.0, 1.0) + _towards(integrand, 0.0, -1.0)
    if high == sympy.oo:
        return _towards(integrand, float(low), 1.0)
    if low == -sympy.oo:
        return _towards(integrand, float(high), -1.0)
    return -by_quadrature(
        sympy.Integral(node.function, (letter, high, low))
    )  # the limits are the other way round


def _towards(integrand: Callable[[Any], Any], start: float, way: float) -> float:
    """From the start to infinity on one side (Gauss and Legendre on panels of u)."""
    import numpy as np  # only here: other problems are solved without it

    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    edges = np.linspace(-ENDS, ENDS, PANELS + 1)
    half = (edges[1] - edges[0]) / 2
    u = (edges[:-1] + half)[:, None] + half * nodes
    step = np.exp(u)
    with np.errstate(all="ignore"):
        height = np.broadcast_to(np.asarray(integrand(start + way * step), dtype=float), u.shape)
        area = height * step
    return float(np.sum(np.where(np.isfinite(area), area, 0.0) @ weights) * half)


def _over(node: sympy.Integral) -> tuple[Any, Any, Any]:
    """The letter, and from where to where."""
    limits: Any = node.limits[0]
    return limits[0], limits[1], limits[2]


def _infinite(limit: sympy.Expr) -> bool:
    return limit in (sympy.oo, -sympy.oo)
