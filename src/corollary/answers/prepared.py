"""Answers judged from plain data: what is right, and what each known mistake gives, worked out beforehand.

This runs where nothing but Python itself is, in a browser: it reads with the reading modules and judges with the judging ones.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any

from corollary.answers.answer import Answer, Blank, Formulas, Letter, Numbers, Unclear
from corollary.answers.choice.judging import judge as judge_choice
from corollary.answers.expected import Expected, FollowThrough, Quantity, RightOption
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.preview import Preview
from corollary.answers.question import Question
from corollary.answers.verdict import Unmarked, Unread, Verdict
from corollary.formula.value import Items, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

Data = Mapping[str, Any]


def preview(asked: Data, answer: str | Sequence[str]) -> Preview:
    """How an answer to a part is read."""
    question = Question.from_data(asked["question"])
    found: Preview = _type(question).preview(_value(answer), question)
    return found


def judge(asked: Data, answer: str | Sequence[str]) -> Verdict:
    """The verdict on an answer to a part that is asked with numbers or options; no other part's answer is carried on."""
    question = Question.from_data(asked["question"])
    read: Answer = _type(question).read(_value(answer), question)
    match read:
        case Blank():
            return Unread(_("No answer was given."), blank=True)
        case Unclear(why):
            return Unread(_("This could not be read: {why}", why=why))
        case Numbers() if "values" in asked:
            return judge_numbers(read, _quantity(asked), question)
        case Letter() if "letter" in asked:
            option = RightOption(asked["letter"], asked["overlooked"])
            return judge_choice(read, Expected(question, option=option))
        case Formulas():
            return Unmarked(_("A formula cannot be judged here: type its number."))
        case _:
            return Unmarked(_("This cannot be judged here: compare it with the worked solution."))


def _type(question: Question) -> Any:
    """By its folder: in a browser there is no list of answer types."""
    return import_module(f"corollary.answers.{question.types[0]}.reading").TYPE


def _value(answer: str | Sequence[str]) -> Value:
    if isinstance(answer, str):
        return Text(answer)
    return Items(tuple(map(Text, answer)), (len(answer),))


def _quantity(asked: Data) -> Quantity:
    ways = [_way(each) for each in asked["ways"]]
    return Quantity(
        tuple(asked["values"]),
        asked["scale"],
        asked["tolerance"],
        tuple(asked["uncertain"]),
        dict,
        None,
        dict,
        tuple,
        lambda: ways,
        lambda: ways,
    )


def _way(data: Data) -> FollowThrough:
    def pairs(name: str) -> Any:
        return None if data[name] is None else lambda: [(tuple(values), text) for values, text in data[name]]

    return FollowThrough(tuple(data["values"]), (), pairs("misconceptions"), pairs("slips"))
