"""A formula in the letters of the problem."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Blank, Formulas, Unclear
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.formula import as_typed, dimension_in, fitting, formula
from corollary.answers.numbers import PLACEHOLDERS
from corollary.answers.quantity import Reading, read_quantity
from corollary.formula.errors import ParseError, sentence
from corollary.formula.value import Exact, Items, Nothing, Real, Refused, Text, Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import show

WANTED = 'a formula is asked for: write it as text in the letters of the exercise, such as "m*v"'


@final
class ExpressionType(AnswerType):
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
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
                number = isinstance(given, (Real, Exact))
                return Unclear(
                    f"this is a number; {WANTED}" if number else WANTED, "a number" if number else "no text"
                )
        trees = []
        for text in texts:
            tree = formula(text, problem)
            if isinstance(tree, ParseError) and tree.status == "asked":
                tree = fitting(text, part.unit, problem) or tree
            if isinstance(tree, Unclear):
                return tree if count == 1 else replace(tree, readings=())
            if isinstance(tree, ParseError):
                number = isinstance(read_quantity(text, part.unit), Reading)
                return Unclear(f"this is a number; {WANTED}" if number else sentence(tree), as_typed(text))
            dimension = dimension_in(tree, problem)
            if isinstance(dimension, ParseError):
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
