"""A formula in the letters of the problem."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

from corollary.kind.answer import Answer, Blank, Formulas, Unclear
from corollary.kind.kind import Kind, Sample
from corollary.kind.number import PLACEHOLDERS, as_typed, formula
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.quantity.dimension import dimension_of
from corollary.quantity.plain import Items, Nothing, Plain, Refused, Text
from corollary.quantity.trouble import Trouble, sentence
from corollary.quantity.unit import show


@final
class Expression(Kind):
    def read(self, given: Plain, part: Part, problem: Problem) -> Answer:
        count = max(1, len(part.components))
        match given:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text) if count == 1:
                texts = [text]
            case Items(items, _) if len(items) == count and all(isinstance(item, Text) for item in items):
                texts = [item.text for item in items if isinstance(item, Text)]
            case Refused(why, shown):
                return Unclear(why, shown)
            case _:
                return Unclear("a formula is asked for: write it as text, such as \"m*v\"", "no text")
        trees = []
        for text in texts:
            tree = formula(text, problem)
            if isinstance(tree, Trouble):
                return Unclear(sentence(tree), as_typed(text))
            dimension = dimension_of(tree, {given.symbol: given.unit.dimension for given in problem.givens})
            if isinstance(dimension, Trouble):
                return Unclear(sentence(dimension), as_typed(text))
            if dimension != part.unit.dimension:
                return Unclear(f"this formula is not in {show(part.unit)}", as_typed(text))
            trees.append(tree)
        return Formulas(tuple(trees), ", ".join(text.strip() for text in texts))

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        """`truth` is the formula as text."""
        assert isinstance(truth, str)
        return (
            Sample(truth, "right"),
            Sample(f"({truth})*7/7", "right"),
            Sample(f"1.37*({truth})", "wrong"),
            Sample(f"{truth} +", "unread"),
            Sample(f"q_unknown*({truth})", "unread"),
            Sample(3.0, "unread"),
            Sample(None, "unread"),
        )
