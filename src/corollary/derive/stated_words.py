"""Words of an author that state letters, claims and forces, each with its line in the solution."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from types import FrameType
from typing import TYPE_CHECKING

import sympy

from corollary.derive.derivation import Always, Limit, Special
from corollary.derive.statements import SOLUTION, Acting, Along, Forces, Statement
from corollary.formula.authored import as_condition, as_expression
from corollary.formula.functions import SPELLINGS
from corollary.laws.law import Law, known_by_name, only_laws

if TYPE_CHECKING:
    import sympy
    from sympy.logic.boolalg import Boolean


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


WORDS = {
    "corollary.author",
    "corollary.misconceptions",
}  # the modules that hold the words: their own frames are nobody's line


def line_of_word() -> int:
    """The line of the author's own word in the solution."""
    return frame_of_word().f_lineno


def frame_of_word() -> FrameType:
    """The innermost frame of a solution's file, even where a word is spoken by a function of another file; else the caller's."""
    caller: FrameType | None = sys._getframe()  # pyright: ignore[reportPrivateUsage]
    while caller is not None and caller.f_globals.get("__name__") in {*WORDS, __name__}:
        caller = caller.f_back
    frame = caller
    while frame is not None and not str(frame.f_globals.get("__name__", "")).startswith(SOLUTION):
        frame = frame.f_back
    found = frame or caller
    assert found is not None  # a word is always spoken by somebody
    return found


def limit(of: object, letter: sympy.Symbol, to: object, equals: object, because: str = "") -> Limit:
    """Claims what something comes to when a given goes to a value, or to `oo`: `limit(F, dt, oo, 0)`. `verify` proves it."""
    words = Statement("", because, line_of_word())
    return Limit(words, as_expression(of), letter, as_expression(to), as_expression(equals))


def at(because: str = "", /, **values: object) -> Special:
    """Claims what is found in a special case: `at(mA=mB, v_B=v)` for a given `mA` and an unknown `v_B`. `verify` proves it."""
    here = {name: as_expression(value) for name, value in values.items()}
    return Special(Statement("", because, line_of_word()), here)


def always(words: str, condition: Boolean | bool | str) -> Always:
    """Claims of every variant what the statement says in words: `always("the ball bounces back", u < 0)`. `verify` proves it.

    A condition in quotes, `"(a - b)/(a - b) > 0"`, is taken as it stands; from one in Python sympy has cancelled what it can.
    """
    stated = condition if isinstance(condition, str) else as_condition(condition)
    return Always(Statement("", words, line_of_word()), stated)


def forces(
    part: str,
    because: str,
    *acting: Acting[sympy.Expr],
    laws: Sequence[Along[Law]],
    mistakes: Mapping[str, str] | None = None,
) -> Forces[sympy.Expr, Law]:
    """All forces on a body, held against the laws that mention it; `mistakes` say why other options do not act on it."""
    return Forces(Statement(part, because, line_of_word()), acting, tuple(laws), mistakes or {})


def force(option: str, magnitude: object, way: object) -> Acting[sympy.Expr]:
    """A force by the letter of its option; it points `way`: "down", "up the slope", or an angle from the right.

    A negative magnitude turns it round, and with none it does not act.
    """
    return Acting(option, as_expression(magnitude), way if isinstance(way, str) else as_expression(way))


def along(way: object, law: Law) -> Along[Law]:
    """A law about the components of the forces along a direction."""
    (stated,) = only_laws((law,))
    return Along(way if isinstance(way, str) else as_expression(way), stated)
