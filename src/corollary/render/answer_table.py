"""Texts for an item's fields with the marks that grading gives: held against what an LMS gives."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.points import grade
from corollary.problem.part import Part
from corollary.render.lms_item import ChoiceAsked, Credit, LmsItem, NumbersAsked, PartAsked
from corollary.units.unit import ONE, show

INSIDE, OUTSIDE = 0.98, 1.02  # of what is tolerated
FAR = 1.37
EDGE = 1e-3  # of what is tolerated: nobody is surprised by either mark there


@dataclass(frozen=True, slots=True)
class TriedAnswer:
    """`fields` are the texts typed into the part's fields (a letter for a choice), `unit` is what was typed behind each number
    for us, `share` what part of the points we give. `sort` says what was tried: right, rounded, misconception, ..."""

    part: Part
    sort: str
    fields: tuple[str, ...]
    share: float


def answer_table(item: LmsItem) -> list[TriedAnswer]:
    """The rows of every part that has fields, the other parts left blank."""
    return [
        TriedAnswer(asked.prompt.part, sort, fields, _share(item, asked, fields))
        for asked in item.parts
        for sort, fields in _typed(asked)
    ]


def _typed(asked: PartAsked) -> Iterator[tuple[str, tuple[str, ...]]]:
    match asked:
        case ChoiceAsked():
            for each in asked.options:
                yield ("right" if each.share == 1 else "wrong option"), (each.option.letter,)
            yield "blank", ("",)
        case NumbersAsked():
            yield from _numbers(asked)
        case _:
            return


def _numbers(asked: NumbersAsked) -> Iterator[tuple[str, tuple[str, ...]]]:
    right = asked.marks[0]

    def typed(values: Sequence[float], figures: int = 7) -> tuple[str, ...]:
        return tuple(f"{value + 0.0:#.{figures}g}".rstrip(".") for value in values)

    first, *others = right.values
    towards = math.copysign(right.reach, first or 1.0)
    yield "right", typed(right.values)
    if any(right.values) and all(_rounds_within(right, x) for x in right.values):
        yield "rounded", typed(right.values, 3)
    yield "just inside", typed((first + INSIDE * towards, *others))
    yield "just outside", typed((first + OUTSIDE * towards, *others))
    for place, each in enumerate(asked.marks[1:], 1):
        if any(_on_the_edge(earlier, each.values) for earlier in asked.marks[:place]):
            continue
        yield each.verdict, typed(each.values)
    yield "far off", typed([FAR * x + (7 if not x else 0) for x in right.values])
    if len(right.values) > 1:
        yield "one component", typed((first, *(FAR * x + right.reach * 7 for x in others)))
    if any(not float(x).is_integer() for x in right.values):
        yield "comma", tuple(text.replace(".", ",") for text in typed(right.values, 4))
    yield "blank", ("",) * len(right.values)


def _on_the_edge(mark: Credit, values: Sequence[float]) -> bool:
    """Whether doubles decide on which side they lie."""
    return abs(math.dist(mark.values, values) - mark.reach) <= EDGE * mark.reach


def _rounds_within(mark: Credit, value: float) -> bool:
    return abs(float(f"{value:.3g}") - value) <= INSIDE * mark.reach / math.sqrt(len(mark.values))


def _share(item: LmsItem, asked: PartAsked, fields: Sequence[str]) -> float:
    """As if it had been handed in as text, each number with its unit behind it."""
    part = asked.prompt.part
    if not any(fields):
        answer = None
    elif isinstance(asked, NumbersAsked):
        behind = f" {show(part.unit)}" if part.unit.dimension != ONE or not part.unit.bare else ""
        texts = [f"{text}{behind}" for text in fields]
        answer = texts if asked.components != ("",) else texts[0]
    else:
        answer = fields[0]
    grades = grade(item.key, judge(item.key, {part.id: from_json(answer)}), item.scheme)
    return grades[part.id].points / part.points
