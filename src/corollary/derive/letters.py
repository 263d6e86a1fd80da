"""The letters a derivation is written in: unknowns, vectors of them, and functions of a variable; laws know them by name."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import sympy

from corollary.formula.functions import SPELLINGS
from corollary.laws.law import known_by_name


def unknowns(names: str = "", /, **meanings: str) -> tuple[sympy.Symbol, ...]:
    """Real unknowns, by their letters: `dp, J = unknowns("dp J")`, or `a, T = unknowns("a", T="tension of the rope")`, in that
    order, where the worked solution is to say what a letter stands for. Raises ValueError for the name of a function.
    """
    letters = list(dict.fromkeys((*names.split(), *meanings)))
    for name in letters:
        if name in SPELLINGS:
            raise ValueError(
                f"{name} is a function in formulas; call the unknown {name}_1, or use another letter"
            )
    found = tuple(sympy.Symbol(name, real=True) for name in letters)
    for symbol in found:
        known_by_name(symbol.name, symbol, meanings.get(symbol.name, ""))
    return found


def unknown(name: str, meaning: str = "") -> sympy.Symbol:
    """One real unknown, and what it stands for."""
    return unknowns(name, **({name: meaning} if meaning else {}))[0]


def variable(name: str = "t", meaning: str = "") -> sympy.Symbol:
    """What functions depend on, where it is no given: `t = variable("t")` is any time. (A given may be one as it is.)"""
    symbol = sympy.Symbol(name, real=True)
    known_by_name(name, symbol, meaning)
    return symbol


def function(name: str, of: sympy.Symbol, meaning: str = "") -> sympy.Expr:
    """An unknown function, `v = function("v", t)`: laws may say `dv/dt`, `v(0)` and `int(v, t, 0, T)` of it."""
    found = sympy.Function(name, real=True)(of)
    known_by_name(name, found, meaning)
    return found


def vector(name: str, components: str = "x y", meaning: str = "") -> tuple[sympy.Symbol, ...]:
    """The components of an unknown vector: `vector("J")` is (J_x, J_y). `meaning` says what all of them stand for."""
    letters = [f"{name}_{component}" for component in components.split()]
    found = unknowns(" ".join(letters), **(dict.fromkeys(letters, meaning) if meaning else {}))
    if set(components.split()) <= {"x", "y", "z"}:  # `vector("v", "A B")` are two bodies, no vector
        known_by_name(name, found)
    return found
