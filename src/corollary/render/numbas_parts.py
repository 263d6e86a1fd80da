"""The parts of a question of Numbas: what stands in its file once, and what the table of variants has for each.

A part reads the table of the drawn variant through variables of the question: `a_words` is the text of part a, `a_credits` what
earns a share of its points. Numbers are marked by one algorithm in JME, Numbas's own language, over that list, so that shares and
messages are ours and components are judged together.
"""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from corollary.messages import catalogue, in_convention
from corollary.render.item import ChoiceAsked, Credit, NumbersAsked, PartAsked, ProseAsked
from corollary.render.markdown import html, inline
from corollary.units.unit import show

_ = catalogue(__name__)

READ = {
    "parameters": [["text", "string"]],
    "type": "number",
    "language": "jme",
    "definition": 'parsenumber(replace_regex("−", "-", replace_regex(",", ".", text, "g")), ["plain", "si-en", "scientific"])',
}
"""The question's function `typed_number`: a decimal comma is one before an exponent, too, which Numbas's own notations do not take."""
FIELD_READS = """studentNumber (As the whole part reads it):
    typed_number(studentAnswer)"""
# Quotients and signs are compared, not what is typed: to Numbas's `<=` all is alike that is less than 1e-15 apart.
MARKS = """numbers (What was typed; a field that holds no number gives nan):
    map(typed_number(x), x, studentAnswer)

submitted (Each field, which says for itself when it holds no number):
    map(submit_part(gap["path"], answer), [gap, answer], zip(gaps, studentAnswer))

met (What the numbers are near enough to, all components together, each with the sign it must have; the first counts):
    filter(
        sqrt(sum(map(((x - y) / credit["reach"])^2, [x, y], zip(numbers, credit["values"])))) <= 1
        and all(map(sign(x) * sign(y) >= 0 or not signed, [x, y, signed], zip(numbers, credit["values"], credit["signed"]))),
        credit,
        CREDITS
    )

mark:
    apply(submitted);
    assert(not some(map(isnan(x), x, numbers)), fail(translate("part.numberentry.answer invalid")));
    if(len(met) = 0,
        incorrect()
    ,
        switch(
            met[0]["feedback"] = "", correct(),
            met[0]["share"] = 0, incorrect(met[0]["feedback"]),
            set_credit(met[0]["share"], met[0]["feedback"])
        )
    )

interpreted_answer:
    numbers"""


def entry_of(asked: PartAsked) -> Mapping[str, object]:
    """The entry of a part in the file, the same for every variant. Raises TypeError for a part that is not asked."""
    part = asked.prompt.part
    name = part.id
    heading = f"({part.heading_letter}) {part.title}"
    about = {"useCustomName": True, "customName": heading, "prompt": f"{{{name}_words}}"}
    match asked:
        case NumbersAsked(components=components):
            unit = f" {escape(show(asked.unit))}" if show(asked.unit) else ""
            fields = "<br>".join(
                f"{escape(component)}{': ' if component else ''}[[{place}]]{unit}"
                for place, component in enumerate(components)
            )
            each = asked.prompt.out_of / len(components)
            return about | {
                "type": "gapfill",
                "prompt": f"{about['prompt']}<p>{fields}</p>",
                "gaps": [_field(name, place, component, each) for place, component in enumerate(components)],
                "customMarkingAlgorithm": MARKS.replace("CREDITS", f"{name}_credits"),
                "extendBaseMarkingAlgorithm": False,
            }
        case ChoiceAsked(options=options):
            return about | {
                "type": "1_n_2",
                "marks": asked.prompt.out_of,
                "shuffleChoices": False,
                "displayType": "radiogroup",
                "choices": f"{name}_options",
                "matrix": f"{name}_marks",
                "distractors": [f"{{{name}_feedback[{place}]}}" for place in range(len(options))],
            }
        case ProseAsked():
            advice = _("Write your answer on paper: your teacher marks it.")
            return about | {
                "type": "information",
                "prompt": f"{about['prompt']}<p><em>{escape(advice)}</em></p>",
            }
        case _:
            raise TypeError(f"{type(asked).__name__} is not asked")


def row_of(asked: PartAsked) -> dict[str, object]:
    """What one variant has for a part, by variable."""
    part = asked.prompt.part
    row: dict[str, object] = {"words": block(asked.prompt.text)}
    match asked:
        case NumbersAsked(marks=marks):
            row |= {
                "credits": [_credit(mark) for mark in marks],
                "ranges": [list(ends) for ends in marks[0].ranges()],
                "shown": [in_convention(f"{value + 0.0:.4g}") for value in marks[0].values],
            }
        case ChoiceAsked(options=options):
            row |= {
                "options": [line(each.option.text) for each in options],
                "marks": [each.share * asked.prompt.out_of for each in options],
                "feedback": [block(each.feedback) if each.feedback else "" for each in options],
            }
        case _:
            pass
    return {f"{part.id}_{column}": value for column, value in row.items()}


def block(text: str) -> str:
    """Markdown as HTML in which Numbas looks for no variables of its own: braces in a formula would be some."""
    return _without_variables(html(text))


def line(text: str) -> str:
    """The same of one line, without a paragraph around it."""
    return _without_variables(inline(text))


def _without_variables(found: str) -> str:
    return found.replace("<math", '<math nosubvars="nosubvars"')


def _credit(mark: Credit) -> dict[str, object]:
    return {
        "values": list(mark.values),
        "reach": mark.reach,
        "signed": list(mark.signed),
        "share": mark.share,
        "feedback": block(mark.feedback) if mark.feedback else "",
    }


def _field(name: str, place: int, component: str, points: float) -> dict[str, object]:
    """A field for a number; what it would say of itself alone is not shown."""
    return {
        "type": "numberentry",
        "marks": points,
        "useCustomName": bool(component),
        "customName": component,
        "minValue": f"{name}_ranges[{place}][0]",
        "maxValue": f"{name}_ranges[{place}][1]",
        "displayAnswer": f"{name}_shown[{place}]",
        "notationStyles": ["plain", "plain-eu", "si-en", "scientific"],
        "allowFractions": False,
        "showFeedbackIcon": False,
        "customMarkingAlgorithm": FIELD_READS,
        "extendBaseMarkingAlgorithm": True,
    }
