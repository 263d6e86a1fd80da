"""What the student reads of each verdict: a sentence or two that help, and never the value unless it is to be revealed."""

from __future__ import annotations

import re
from typing import assert_never

from corollary.answers.options import option_named
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.formula.numerals import decimal_text
from corollary.grading.free_body import as_people_say, free_body
from corollary.grading.key import Key
from corollary.messages import catalogue, in_convention
from corollary.problem.part import Part
from corollary.units.unit import ONE, show, unit

_ = catalogue(__name__)


def sentence(verdict: Verdict) -> str:
    """The verdict in the student's words, as Markdown."""
    match verdict:
        case Right(note):
            return note or _("Right.")
        case Follows(earlier, True):
            return _(
                "This is your answer in {parts} again, and that answer is not right: it earns nothing a second time.",
                parts=_parts(earlier),
            )
        case Follows(earlier):
            return _(
                "This follows correctly from your answer in {parts}, though that answer is not right.",
                parts=_parts(earlier),
            )
        case Mistaken(mistake, earlier):
            if not earlier:
                return mistake
            return _(
                "{mistake} (Your answer in {parts} was carried along and costs nothing here.)",
                mistake=mistake,
                parts=_parts(earlier),
            )
        case Slip(slip):
            return _("Nearly. {slip}", slip=slip)
        case Wrong(why):
            return _("Not right. {why}", why=why).strip()
        case Unread(why):
            return why
        case Unmarked(why):
            return why
        case _:
            assert_never(verdict)


def revealed(key: Key, part: Part, answered: str = "") -> str:
    """The answer in words, for feedback that may show it, an angle in degrees where it was answered so; empty where a part has none."""
    if part.id in key.choices:
        option = option_named(part, key.choices[part.id])
        return _("The answer is {answer}.", answer=option) if option else ""
    if part.id in key.solution.forces:
        return _(
            "The answer is {answer}.",
            answer=as_people_say(free_body(key.solution.forces[part.id], key.variant), part),
        )
    truth = key.truths.get(part.id)
    if truth is None:
        return ""
    asked = part.unit
    if asked.dimension == ONE and ("°" in answered or re.search(r"\bdeg", answered)):
        asked = unit("deg")
    size = asked.si
    values = [decimal_text(value / size, 4) for value in truth.values]
    sign = show(asked)
    body = values[0] if len(values) == 1 else f"({', '.join(values)})"
    return _("The answer is {answer}.", answer=in_convention(f"{body} {sign}" if sign else body))


def _parts(earlier: tuple[str, ...]) -> str:
    return _(" and ").join(f"({part})" for part in earlier)
