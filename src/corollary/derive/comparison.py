"""Comparisons by == in a solution's code: refused between formulas, for sympy compares how they are written."""

from __future__ import annotations

import ast
import sys
from numbers import Number
from typing import Any

EQUAL, UNEQUAL = "__corollary_equal__", "__corollary_unequal__"


def equal(left: Any, right: Any) -> Any:
    """`left == right`. Raises TypeError between formulas."""
    _refuse(left, right, "==", "Eq")
    return left == right


def unequal(left: Any, right: Any) -> Any:
    """`left != right`. Raises TypeError between formulas."""
    _refuse(left, right, "!=", "Ne")
    return left != right


NAMES = {EQUAL: equal, UNEQUAL: unequal}
"""What the compiled code calls, to be put into its module."""


def compiled(source: bytes | str, path: str) -> Any:
    """The code of a solution, each == and != in it as a call. Raises SyntaxError, which names the file, or ValueError for what is
    no Python."""
    try:
        tree = ast.parse(source, path)
    except SyntaxError as error:
        error.filename = error.filename or path
        raise
    tree = ast.fix_missing_locations(_Comparisons().visit(tree))
    return compile(tree, path, "exec", dont_inherit=True)


class _Comparisons(ast.NodeTransformer):
    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        self.generic_visit(node)
        if not any(isinstance(sign, ast.Eq | ast.NotEq) for sign in node.ops):
            return node
        operands = [node.left, *node.comparators]
        pairs = [
            self._pair(node, sign, *operands[place : place + 2]) for place, sign in enumerate(node.ops)
        ]  # of a chain, the middle is worked out twice
        return pairs[0] if len(pairs) == 1 else ast.copy_location(ast.BoolOp(ast.And(), pairs), node)

    def _pair(self, node: ast.Compare, sign: ast.cmpop, left: ast.expr, right: ast.expr) -> ast.expr:
        if isinstance(sign, ast.Eq | ast.NotEq):
            name = ast.copy_location(
                ast.Name(EQUAL if isinstance(sign, ast.Eq) else UNEQUAL, ast.Load()), node
            )
            return ast.copy_location(ast.Call(name, [left, right], []), node)
        return ast.copy_location(ast.Compare(left, [sign], [right]), node)


def _refuse(left: Any, right: Any, sign: str, word: str) -> None:
    sympy = sys.modules.get("sympy")
    if sympy is None:  # without it there is no formula
        return
    formulas = [each for each in (left, right) if isinstance(each, sympy.Expr)]
    others = [each for each in (left, right) if not isinstance(each, sympy.Expr)]
    if any(each.free_symbols for each in formulas) and all(isinstance(each, Number) for each in others):
        raise TypeError(
            f"{left} {sign} {right} compares how two formulas are written, not what they are; "
            f"write {word}({left}, {right}), with {word} from sympy"
        )
