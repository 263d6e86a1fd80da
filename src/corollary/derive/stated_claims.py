"""Claims and forces as an author states them, each with the line of the solution in which it stands."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from types import FrameType
from typing import TYPE_CHECKING

from corollary.derive.derivation import Always, Limit, Special
from corollary.derive.free_body import Acting, Along, Forces
from corollary.derive.statements import SOLUTION, Statement
from corollary.formula.authored import as_condition, as_expression
from corollary.laws.law import Law, only_laws

if TYPE_CHECKING:
    import sympy
    from sympy.logic.boolalg import Boolean

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
