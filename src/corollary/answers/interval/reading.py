"""Intervals, asked for and read: `-0.2 m to 0.2 m`, `[-0.2, 0.2] m`, `5.0 ± 0.2 m`, a list of two."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Numbers, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.open_words import with_open_words
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.formula.value import Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)

LONGEST = 200
FROM_TO = re.compile(
    r"\s*(?!(?:not|no|never|neither|outside|except|but|nicht|außerhalb|ikke|utenfor)\b)(?:(?:[^\W\d]\w*\s+(?:(?:is|lies|ist|liegt|er|ligger)\s+)?)?(?:from|between|von|zwischen|fra|mellom)\s+)?(?P<low>\S.*?)\s+(?:to|and|bis|und|til|og|\.\.\.?|…)\s+(?P<high>\S.*?)\s*",
    re.IGNORECASE,
)
NUMBER_AND_UNIT = (
    r"[-+−]?\s*[0-9][0-9.,eE]*(?<![.,])(?:\s*(?!(?:and|und|og)\b)[°%A-Za-zµ][^\s<>;\[\](),–—-]*)?"
)
DASH = re.compile(
    rf"\s*(?P<low>{NUMBER_AND_UNIT})\s*(?:\.\.+|…|–|—|-|−|\bto\b)\s*(?P<high>{NUMBER_AND_UNIT})\s*"
)
OPEN = re.compile(
    rf"\s*[\[\](]\s*(?P<low>{NUMBER_AND_UNIT})\s*[;,|]\s*(?P<high>{NUMBER_AND_UNIT})\s*[\[\])]\s*(?P<unit>[°%A-Za-zµ].*)?"
)
TWO_BOUNDS = re.compile(
    rf"\s*(?:[^\W\d]\w*\s*)?[>≥]=?\s*(?P<low>{NUMBER_AND_UNIT})\s*(?:,|;|and|und|og|&|\s)\s*(?:[^\W\d]\w*\s*)?[<≤]=?\s*(?P<high>{NUMBER_AND_UNIT})\s*",
    re.IGNORECASE,
)
CHAIN = re.compile(r"(?P<low>[^<≤>≥=]+)(?:[<>]=?|[≤≥])\s*[^\W\d]\w*\s*(?:[<>]=?|[≤≥])(?P<high>[^<≤>≥=]+)")
ONE_END = re.compile(r"\s*(?:[^\W\d]\w*\s*(?:[<>]=?|[≤≥]))?\s*(?P<end>[^<≤>≥=]+)")
# As far to either side of zero: `±5.2 cm`, `|x| ≤ 5.2 cm`.
TO_EITHER_SIDE = re.compile(
    rf"\s*(?:(?:±|\+/-|\+-)|\|\s*[^\W\d]\w*\s*\|\s*(?:<=?|≤|⩽)|abs\(\s*[^\W\d]\w*\s*\)\s*(?:<=?|≤))\s*(?P<end>(?![-+−]){NUMBER_AND_UNIT}|\d[^<>≤≥=;]*?)\s*"
)
AROUND = re.compile(
    r"\s*\(?\s*(?P<middle>[^±()]+?)\s*(?:±|\+/-|\+-)\s*(?P<half>[0-9.,]+)\s*\)?\s*(?P<unit>[^±]*)"
)


@final
class IntervalType(AnswerType):
    name, word = "interval", "interval"
    accepts = needs = frozenset({"components"})
    lists_components = False

    def heading(self, question: Question) -> str:
        unit = show(question.unit)
        return _("An interval, in {unit}.", unit=unit) if unit else _("An interval of plain numbers.")

    def instructions(self, question: Question) -> str:
        return _("Answer with an interval: from where to where.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _('an interval as text: "-1.5 to 2.5"')

    def read(self, value: Value, question: Question) -> Answer:
        return with_open_words(_interval(value, question), value, question)


def _interval(value: Value, question: Question) -> Answer:
    """The interval that a value is."""
    if isinstance(value, Text) and len(value.text) <= LONGEST and (ends := CHAIN.fullmatch(value.text)):
        return _between(ends, question)
    if isinstance(value, Text) and len(value.text) <= LONGEST:
        if (around := AROUND.fullmatch(value.text)) is not None:
            return _around(around["middle"], around["half"], around["unit"], question)
        if (sides := TO_EITHER_SIDE.fullmatch(value.text)) is not None:
            value = Text(f"-{sides['end']}; {sides['end']}")
        elif (found := OPEN.fullmatch(value.text)) is not None:
            value = Text(f"({found['low']}; {found['high']}) {found['unit'] or ''}".strip())
        elif (
            found := TWO_BOUNDS.fullmatch(value.text)
            or DASH.fullmatch(value.text)
            or FROM_TO.fullmatch(value.text)
        ) is not None:
            value = Text(f"{found['low']}; {found['high']}")
    answer = vector(value, question)
    if isinstance(answer, Numbers):
        low, high = answer.as_read.removeprefix("(").removesuffix(")").split(", ", 1)
        return replace(answer, as_read=_("from {low} to {high}", low=low, high=high))
    if isinstance(answer, Unclear) and isinstance(value, Text) and _is_one_end(value.text, question):
        return replace(answer, why=_('an interval has two ends; write both, such as "-1.5 to 2.5"'))
    return answer


def _between(ends: re.Match[str], question: Question) -> Answer:
    """`-0.2 m < x < 0.2 m`, or with both signs the other way."""
    signs = {"<" if sign in "<≤" else ">" for sign in re.findall(r"[<≤>≥]", ends[0])}
    low, high = (ends["low"], ends["high"]) if signs == {"<"} else (ends["high"], ends["low"])
    found = _interval(Text(f"{low}; {high}"), question)
    if len(signs) == 2 or (isinstance(found, Numbers) and found.values[0] > found.values[1]):
        why = _('no number lies in {text}; write both ends, such as "-1.5 to 2.5"', text=ends[0].strip())
        return Unclear(why, ends[0].strip())
    return found


def _is_one_end(text: str, question: Question) -> bool:
    """`2 m`, or `x < 2 m`."""
    one = ONE_END.fullmatch(text)
    return one is not None and isinstance(scalar(Text(one["end"]), question), Numbers)


def _around(middle: str, half: str, unit: str, question: Question) -> Answer:
    """`5.0 ± 0.2 m`: both ends have the figures of the middle."""
    middle = f"{middle} {unit}".strip()
    found, off = scalar(Text(middle), question), scalar(Text(f"{half} {unit}".strip()), question)
    if not isinstance(found, Numbers):
        return found
    if not isinstance(off, Numbers):
        return off
    (x,), (d,) = found.values, off.values
    d -= float(question.unit.offset)  # how far a temperature may be off has no zero
    as_read = f"{found.as_read} ± {off.as_read}"
    return replace(
        found,
        values=(x - d, x + d),
        figures=2 * found.figures,
        sizes=2 * found.sizes,
        zeros=2 * found.zeros,
        as_read=as_read,
    )


TYPE = IntervalType()
