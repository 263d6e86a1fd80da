"""Several quantities in any order, asked for and read: a list, or a text such as `2 s and 5 s`; their number counts."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Blank, Formulas, Numbers, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.open_words import with_open_words
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.formula.value import Items, Nothing, Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)

LONGEST = 400
PARTED = re.compile(r"[,;\n|(\[{]")
MOST = 12  # numbers of one list
BY_BLANKS = re.compile(r"\s*[-+]?[0-9]+\.[0-9]+(?:\s+[-+]?[0-9]+\.[0-9]+)+(?:\s*[A-Za-z°%][^0-9]*)?")
AND = re.compile(r"\s+(?:and|or|und|oder|og|eller)\s+", re.IGNORECASE)


@final
class ListType(AnswerType):
    name, word = "list", "list"
    accepts = frozenset({"components"})  # none where how many there are depends on the numbers
    lists_components = False

    def heading(self, question: Question) -> str:
        unit = show(question.unit)
        return _("A list, in {unit}.", unit=unit) if unit else _("A list of plain numbers.")

    def instructions(self, question: Question) -> str:
        return _("Answer with a list of all of them, in any order.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = []   # " + _("all of them, in any order: numbers, or texts with a unit")

    def read(self, value: Value, question: Question) -> Answer:
        return with_open_words(_list(value, question), value, question)


def _list(value: Value, question: Question) -> Answer:
    """The list that a value is."""
    if isinstance(value, Items) and all(isinstance(item, Nothing) for item in value.items):
        return Blank()
    if isinstance(value, Text) and len(value.text) <= LONGEST and BY_BLANKS.fullmatch(value.text):
        value = Text(re.sub(r"(?<=[0-9])\s+(?=[-+0-9])", "; ", value.text.strip()))  # `0.359 2.09`
    if isinstance(value, Text) and len(value.text) <= LONGEST and AND.search(value.text):
        value = Text(re.sub(r"\s*,\s+", "; ", AND.sub("; ", value.text)))
    found = _of(value, _wanted(value, len(question.components)), question)
    if isinstance(found, Unclear) and not found.readings:
        for count in _counts(value):
            other = _of(value, count, question)
            if isinstance(other, Numbers | Formulas):
                return other
    return found


def _of(value: Value, count: int, question: Question) -> Answer:
    """The value as a list of so many."""
    if count > 1:
        return vector(value, _unnamed(question, count))
    found = scalar(value, question)
    if isinstance(found, Numbers | Formulas):
        return replace(found, as_read=f"({found.as_read})")
    return found


def _unnamed(question: Question, count: int) -> Question:
    """The same question for so many numbers without names of their own."""
    return replace(question, components=tuple(str(place + 1) for place in range(count)))


def _wanted(value: Value, count: int) -> int:
    """As many as are asked for, unless the value says how many there are: nothing but blanks (`2 5 s`) parts no numbers."""
    match value:
        case Text(text) if not PARTED.search(text):
            return count if count == 2 and "±" in text else 1
        case Items(items) if items and not any(isinstance(item, Items) for item in items):
            return len(items)
        case _:
            return count


def _counts(value: Value) -> range:
    """How many numbers there may be."""
    match value:
        case Items(items):
            return range(len(items), len(items) + 1) if len(items) <= MOST else range(0)
        case Text(text):
            marks = len(re.findall(r"[,;\n|]", text))
            return range(1, min(MOST, marks + 1) + 1)
        case _:
            return range(1, 2)


TYPE = ListType()
