"""The words in which an author claims what something comes to: in a limit, in a special case, and for all numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from corollary.derive.derivation import Always, Limit, Special
from corollary.derive.spoken import line_of_word
from corollary.derive.statements import Statement
from corollary.formula.authored import as_condition, as_expression

if TYPE_CHECKING:
    import sympy
    from sympy.logic.boolalg import Boolean


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
