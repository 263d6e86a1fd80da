"""Formulas out of what a student typed: in the letters of the problem, with the dimension asked for."""

from __future__ import annotations

from corollary.answers.answer import Formulas, Unclear
from corollary.answers.preamble import answer_in
from corollary.formula.ast import Expr, names
from corollary.formula.errors import ParseError, refused, sentence
from corollary.formula.numerals import LONGEST, PLAIN
from corollary.formula.parser import Lean
from corollary.formula.syntax import parse
from corollary.formula.tex import without_tex
from corollary.problem.problem import Problem
from corollary.units.dimensions import dimension_of
from corollary.units.unit import Dimension, Unit

LONGEST_SHOWN = 80


def formula(text: str, problem: Problem, lean: Lean = "ask") -> Expr | ParseError:
    """A formula that uses at least one given."""
    letters = [given.symbol for given in problem.givens]
    tree = parse(text, letters, lean=lean)
    if isinstance(tree, ParseError) and len(text) <= LONGEST:
        bare, _ = answer_in(without_tex(text).translate(PLAIN))
        again = parse(bare, letters, lean=lean) if bare.strip() != text.strip() else tree
        tree = tree if isinstance(again, ParseError) and again.status != "asked" else again
    if not isinstance(tree, ParseError) and not names(tree) - {"pi"}:
        return refused("this has no letters of the problem in it")
    return tree


def fitting(text: str, unit: Unit, problem: Problem) -> Expr | Unclear | None:
    """Of the readings of `m v cos θ/M`, the one with the dimension asked for; both, when both have it."""
    trees = [formula(text, problem, lean) for lean in ("near", "far")]
    good = [
        tree
        for tree in trees
        if not isinstance(tree, ParseError) and dimension_in(tree, problem) == unit.dimension
    ]
    if len(good) < 2:
        return good[0] if good else None
    asked = formula(text, problem)
    why = sentence(asked) if isinstance(asked, ParseError) else "this formula can be read in two ways"
    return Unclear(why, as_typed(text), tuple(Formulas((tree,), text.strip()) for tree in good))


def dimension_in(tree: Expr, problem: Problem) -> Dimension | ParseError:
    """What a formula of the problem's letters measures."""
    return dimension_of(tree, {given.symbol: given.unit.dimension for given in problem.givens})


def as_typed(text: str) -> str:
    """What was typed, cut short where it is long."""
    plain = text.strip()
    return plain if len(plain) <= LONGEST_SHOWN else plain[: LONGEST_SHOWN - 1] + "…"
