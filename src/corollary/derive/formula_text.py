"""Formulas, conditions, laws and calls of the library in the text of a solution, read without running it."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from importlib import import_module
from types import MappingProxyType
from typing import Any, cast

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.function_values import value_of
from corollary.formula.ast import Relation
from corollary.formula.authored import as_condition, as_expression
from corollary.formula.operators import read_operators
from corollary.formula.syntax import author_formula
from corollary.formula.to_sympy import expression
from corollary.laws import laws_in, library
from corollary.laws.law import Law, Meaning, is_function
from corollary.laws.law import law as stated_law
from corollary.messages import did_you_mean

SIGNS: Mapping[type[ast.cmpop], Callable[[Any, Any], Any]] = MappingProxyType(
    {ast.Lt: sympy.Lt, ast.LtE: sympy.Le, ast.Gt: sympy.Gt, ast.GtE: sympy.Ge, ast.Eq: sympy.Eq, ast.NotEq: sympy.Ne}
)  # fmt: skip
LONE_EQUALS = re.compile(r"(?<![<>=!])=(?!=)")
CALL = re.compile(r"[A-Za-z_]\w*\(.*\)$", re.DOTALL)


class LetterTable:
    """What the letters of a solution mean, and the formulas in them."""

    def __init__(self, meanings: Mapping[str, Meaning]) -> None:
        self.meanings = dict(meanings)

    def expression(self, text: str) -> sympy.Expr:
        """A formula, or `oo`. Raises ValueError, TypeError."""
        tree = author_formula(text, operators=True)
        if isinstance(tree, Relation):
            raise ValueError(f"{text!r} is a relation where a formula belongs")
        functions = {name for name, meaning in self.meanings.items() if is_function(meaning)}
        tree = read_operators(tree, self.meanings.keys(), functions)
        letters = {name: each for name, each in self.meanings.items() if not isinstance(each, tuple)}
        try:
            return as_expression(expression(tree, {"oo": sympy.oo, **letters}))
        except KeyError as error:
            raise ValueError(self.unknown(str(error.args[0]), text)) from None

    def unknown(self, letter: str, text: str) -> str:
        """A sentence about a letter that means nothing."""
        if isinstance(self.meanings.get(letter), tuple):
            return f"{letter} in {text!r} is a vector; name one of its components"
        known = ", ".join(sorted(self.meanings)) or "there are none yet"
        return f"what does {letter} mean in {text!r}? It is neither a given nor an unknown ({known})"

    def symbol(self, text: str) -> sympy.Symbol:
        """A letter. Raises ValueError."""
        found = self.meanings.get(text.strip())
        if not isinstance(found, sympy.Symbol):
            raise ValueError(self.unknown(text.strip(), text))
        return found

    def found(self, text: str) -> sympy.Symbol:
        """A letter that a step finds: of a function, its value at any time. Raises ValueError."""
        return value_of(self.meanings.get(text.strip())) or self.symbol(text)

    def meaning(self, text: str) -> Meaning:
        """A formula, several in brackets with commas between them, or the name of a vector."""
        return cast("Meaning", self.argument(text))

    def argument(self, text: str) -> Any:
        """What a law of the library is called with: a formula, or several in brackets."""
        if isinstance(vector := self.meanings.get(text.strip()), tuple):
            return vector
        node = _parsed(text)
        if isinstance(node, ast.Tuple | ast.List):
            return self._value(node, _typed(text))
        return self.expression(text)

    def equations(self, text: str) -> dict[str, Meaning]:
        """`a = b, c = (d, e)` as what stands right by the letter on the left."""
        found: dict[str, Meaning] = {}
        for piece in parted(text):
            left, equals, right = piece.partition("=")
            if not equals or not left.strip().isidentifier() or not right.strip():
                raise ValueError(f"{piece.strip()!r} is not a letter, an equals sign and a formula")
            found[left.strip()] = self.meaning(right)
        return found

    def condition(self, text: str) -> Boolean | bool:
        """Relations, chains of them, joined by and, or, not. Raises ValueError."""
        typed = LONE_EQUALS.sub("==", _typed(text))
        node = _parsed(typed)
        if node is None:
            raise ValueError(
                f"{text!r} is not a condition; write relations, such as 0 < F <= mu*N, with and, or, not"
            )
        return as_condition(self._condition(node, typed))

    def _condition(self, node: ast.expr, text: str) -> Any:
        match node:
            case ast.Name("true" | "false" as truth):
                return truth == "true"
            case ast.BoolOp(operation, parts):
                join = sympy.And if isinstance(operation, ast.And) else sympy.Or
                return join(*(self._condition(part, text) for part in parts))
            case ast.UnaryOp(ast.Not(), part):
                return sympy.Not(self._condition(part, text))
            case ast.Compare(first, signs, others) if all(type(sign) in SIGNS for sign in signs):
                sides = [self.expression(_source(text, side)) for side in (first, *others)]
                relations = [SIGNS[type(sign)](*sides[place : place + 2]) for place, sign in enumerate(signs)]
                return relations[0] if len(relations) == 1 else sympy.And(*relations)
            case _:
                raise ValueError(f"{_source(text, node)!r} compares nothing; write a relation, such as v > 0")

    def call(self, text: str) -> Any:
        """What a function of `corollary.laws` or `corollary.misconceptions` gives for the formulas, and texts in quotes, in its
        brackets. Raises what it raises, and ValueError for any other call."""
        typed = _typed(text)
        node = _parsed(typed)
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
            raise ValueError(f"{text!r} is not a call such as momentum(p, m, v)")
        name = node.func.id
        functions = callables()
        if name not in functions:
            raise ValueError(
                f"there is no law and no misconception {name}{did_you_mean(name, functions)}; "
                "state a law by its name and formula, such as Momentum, `p = m*v`"
            )
        if any(keyword.arg is None for keyword in node.keywords):
            raise ValueError(f"{text!r}: write each argument by itself")
        arguments = [self._value(each, typed) for each in node.args]
        named = {str(keyword.arg): self._value(keyword.value, typed) for keyword in node.keywords}
        return functions[name](*arguments, **named)

    def _value(self, node: ast.expr, text: str) -> Any:
        match node:
            case ast.Tuple(parts) | ast.List(parts):
                return tuple(self._value(part, text) for part in parts)
            case ast.Constant(str(words)):
                return words
            case _:
                return self.argument(_source(text, node))

    def law(self, name: str, formula: str, letters: str = "", *, source: str = "", holds: str = "") -> Law:
        """A law by its formula, or by a call of the library. Raises ValueError."""
        if is_call(formula):
            if name or letters or source or holds:
                raise ValueError(f"{formula!r} is a law of the library, which has its name and letters")
            found = self.call(formula)
            if not isinstance(found, Law):
                raise ValueError(f"{formula!r} is not a law")
            return found
        meanings: dict[str, Any] = dict(self.equations(letters)) if letters else {}
        return stated_law(name, formula, source=source, holds=holds, **meanings)


def is_call(text: str) -> bool:
    """Whether a text calls one function, as `momentum(p, m, v)` does, and is no equation."""
    return bool(CALL.match(text.strip())) and isinstance(_parsed(_typed(text)), ast.Call)


def parted(text: str) -> Iterator[str]:
    """What commas outside of brackets part."""
    depth, start = 0, 0
    for place, sign in enumerate(text):
        depth += (sign in "([{") - (sign in ")]}")
        if sign == "," and not depth:
            yield text[start:place]
            start = place + 1
    yield text[start:]


@cache
def callables() -> Mapping[str, Callable[..., Any]]:
    """The functions that a text may call: the laws of the library and of installed packages, and the common misconceptions."""
    home = import_module("corollary.misconceptions")  # only where a text is read
    return {**laws_in(home), **library()}


def _typed(text: str) -> str:
    """A formula in signs that Python's reader of brackets and commas knows."""
    for sign, written in (("≤", "<="), ("≥", ">="), ("≠", "!="), ("·", "*"), ("^", "**")):
        text = text.replace(sign, written)
    return text.strip()


def _parsed(text: str) -> ast.expr | None:
    """The structure of a text, never run; None where it has none."""
    try:
        return ast.parse(_typed(text), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        return None


def _source(text: str, node: ast.expr) -> str:
    return ast.get_source_segment(text, node) or ""
