"""Feedback sentences on each verdict: one or two that help, and never the value unless it is to be revealed."""

from __future__ import annotations

import re

from corollary.answers.expected import Values
from corollary.answers.option_names import option_named
from corollary.formula.numerals import decimal_text
from corollary.formula.plain_text import text
from corollary.grading.forces_on_body import as_people_say, free_body
from corollary.grading.key import Key
from corollary.messages import catalogue, in_convention
from corollary.problem.part import Part
from corollary.units.unit import ONE, show, unit

_ = catalogue(__name__)


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
    if part.of:
        formulas = ", ".join(map(text, key.find(truth).in_givens or ()))
        return _("The answer is {answer}.", answer=formulas) if formulas else ""
    if part.rows:
        return _of_table(truth.values, part)
    asked = part.unit
    if asked.dimension == ONE and ("°" in answered or re.search(r"\bdeg", answered)):
        asked = unit("deg")
    size = asked.si
    values = [decimal_text(value / size, 4) for value in truth.values]
    sign = show(asked)
    body = values[0] if len(values) == 1 else f"({', '.join(values)})"
    return _("The answer is {answer}.", answer=in_convention(f"{body} {sign}" if sign else body))


def _of_table(values: Values, part: Part) -> str:
    """The answer as it would be written, row by row."""
    units, width = part.units, len(part.columns)
    entries = [
        f"{decimal_text(unit.from_si(value), 4)} {show(unit)}".strip()
        for value, unit in zip(values, units, strict=True)
    ]
    rows = (", ".join(entries[place : place + width]) for place in range(0, len(entries), width))
    return _("The answer is {answer}.", answer=in_convention("; ".join(f"({row})" for row in rows)))
