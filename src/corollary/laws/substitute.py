"""Values put in the place of letters; the one place where sympy's own typing of it is made to say what it does."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

import sympy


def put(expression: Any, values: Mapping[sympy.Symbol, sympy.Expr]) -> Any:
    """The expression (or relation) with the letters replaced, and nothing else done to it but what sympy does by itself."""
    return expression.subs(dict(values)) if values else expression


def as_expression(value: object) -> sympy.Expr:
    """A number or expression of an author's as sympy has it."""
    return cast(sympy.Expr, sympy.sympify(value))
