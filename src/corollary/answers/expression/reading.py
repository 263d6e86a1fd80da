"""Formulas in the symbols of the problem, asked for and read."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Blank, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.blanks import nones
from corollary.answers.bound import bound_in, bounded
from corollary.answers.formula import (
    as_typed,
    dimension_in,
    fitting,
    formula,
    formulas,
    other_dimension,
    symbols_note,
)
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.question import Question
from corollary.formula.ast import Expr, names
from corollary.formula.errors import ParseError, sentence
from corollary.formula.value import Exact, Items, Nothing, Real, Refused, Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)

WORD = re.compile(r"[^\W\d]\w*")
# `see above`, `I don't know`: words with neither an operator nor a digit are no formula with a wrong letter
OPERATOR, IN_WORDS = re.compile(r"[-+*/^=()√0-9]"), re.compile(r"[^\W\d_]{2,}\s+[^\W\d_]{2,}|[^\W\d_]{5,}")


@final
class ExpressionType(AnswerType):
    name, word = "expression", "formula"
    accepts, in_symbols = frozenset({"components"}), True

    def heading(self, question: Question) -> str:
        return _("A formula.")

    def instructions(self, question: Question) -> str:
        return f"{symbols_note(question)} {in_numbers(question)}".rstrip()

    def blank(self, question: Question) -> str:
        if question.components:
            names = ", ".join(question.components)
            remark = _('[{names}], each a formula as text: "2*a/(b + c)"', names=names)
            return f"{question.name} = [{nones(question)}]   # {remark}"
        remark = _('a formula as text, in quotes: "2*a/(b + c)"')
        return f"{question.name} = None   # {remark}"

    def read(self, value: Value, question: Question) -> Answer:
        count = max(1, len(question.components))
        match value:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text) if count == 1 and (bound := bound_in(text)) is not None:
                return bounded(bound, self.read(Text(bound.text), question), question)
            case Text(text) if count == 1:
                texts = [text]
            case Items(items) if len(items) == count and all(isinstance(item, Text) for item in items):
                texts = [item.text for item in items if isinstance(item, Text)]
            case Items(items) if items and all(isinstance(item, Nothing) for item in items):
                return Blank()
            case Refused():
                return turned_away(value)
            case Real() | Exact():
                return Unclear(_("this is a number; {wanted}", wanted=_wanted(question)), _("a number"))
            case _:
                return Unclear(_wanted(question), _("no text"))
        trees: list[Expr] = []
        for text in texts:
            tree = _tree(text, question)
            if isinstance(tree, Unclear):
                return tree if count == 1 else replace(tree, readings=())
            trees.append(tree)
        return formulas(*trees, typed=" ".join(texts))


def _tree(text: str, question: Question) -> Expr | Unclear:
    tree = formula(text, question)
    if isinstance(tree, ParseError) and tree.status == "asked":
        tree = fitting(text, question) or tree
    if isinstance(tree, Unclear):
        return tree
    if isinstance(tree, ParseError):
        # The 2 volts of `2*V` are a letter in another case, where the exercise has a v.
        cased = {each.casefold() for each in question.symbol_names} & set(WORD.findall(text.casefold()))
        number = not cased and isinstance(read_quantity(text, question.unit), Reading)
        words = tree.status == "refused" and OPERATOR.search(text) is None and IN_WORDS.search(text)
        why = (
            _("this is a number; {wanted}", wanted=_wanted(question))
            if number
            else _wanted(question)
            if words
            else sentence(tree)
        )
        return Unclear(why, as_typed(text))
    dimension = dimension_in(tree, question)
    if question.variables and names(tree) <= {"pi", *(name for name, _low, _high in question.variables)}:
        return tree  # numbers of the sheet put in, in the units of the question
    if isinstance(dimension, ParseError):
        return Unclear(sentence(dimension), as_typed(text))
    if dimension != question.unit.dimension:
        return Unclear(other_dimension(tree, dimension, question.unit), as_typed(text))
    return tree


def in_numbers(question: Question) -> str:
    """How a formula of a variable is written with numbers in place of the other letters; empty for other formulas."""
    if not question.variables:
        return ""
    variables = {name for name, _low, _high in question.variables}
    units = [
        f"`{each.name}` [{show(each.unit) or '1'}]" for each in question.symbols if each.name in variables
    ]
    return _(
        "Or put your numbers in for all letters but {variables}, without units; the result is then in {unit}.",
        variables=", ".join(units),
        unit=show(question.unit) or _("plain numbers"),
    )


def _wanted(question: Question) -> str:
    if question.components:
        return _(
            "a list of {count} formulas is asked for, [{names}], each as text",
            count=len(question.components),
            names=", ".join(question.components),
        )
    return _('a formula is asked for: write it as text in the letters of the exercise, such as "m*v"')


TYPE = ExpressionType()
