"""An exam as Numbas has it, which draws numbers in the browser, without a server: a question for each problem."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from itertools import groupby

from corollary.messages import catalogue, in_convention
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.lms_item import (
    ChoiceAsked,
    Credit,
    LmsItem,
    NotAsked,
    NumbersAsked,
    PartAsked,
    ProseAsked,
)
from corollary.render.markdown import html, inline
from corollary.render.page import drawing_address
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


HEADER = "// Numbas version: finer_feedback_settings\n"
"""Of files since Numbas 7; later ones read it (numbas/Numbas `bin/examparser/migrations.py`)."""
LOST = (
    "an answer that follows from the student's own earlier one is wrong",
    "the same slip costs in every part, not once",
    "figures are not counted: what is rounded to fewer than three is right or wrong as its value is",
    "a unit that is typed is not read: it stands beside the field",
    "a comma is a decimal comma also where it parts thousands: 1,234 is 1.234",
)
"""What no question carries."""
ON_PAPER = "nothing can be typed: it is answered on paper and marked by a person, and its points are not in the score"


def write_items(name: str, items: Sequence[LmsItem], apart: bool) -> ItemFiles:
    """One file with an exam, and what became of each part, from the first variant of each problem."""
    pools = [list(pool) for _code, pool in groupby(items, key=lambda item: item.exercise.problem.code)]
    questions = [question for pool in pools for question in _questions(pool, apart)]
    text = HEADER + json.dumps(_exam(name, questions), ensure_ascii=False, indent=1) + "\n"
    return ItemFiles({f"{name}-numbas.exam": text.encode()}, tuple(_carried(pools)), LOST)


def _carried(pools: Sequence[Sequence[LmsItem]]) -> Iterator[CarriedPart]:
    for first, *_others in pools:
        for asked in first.parts:
            yield CarriedPart(first.exercise.problem.code, asked.prompt.part.id, *_how(asked))


def _how(asked: PartAsked) -> tuple[str, str]:
    """How a part is asked ("" where it is not), and what is lost of it."""
    match asked:
        case NumbersAsked(components=components) if len(components) > 1:
            return "a field for each component", ""
        case NumbersAsked():
            return "field for a number", ""
        case ChoiceAsked():
            return "choice", ""
        case ProseAsked():
            return "text", ON_PAPER
        case NotAsked(why=why):
            return "", why


def _exam(name: str, questions: Sequence[dict[str, object]]) -> dict[str, object]:
    group = {
        "name": name,
        "pickingStrategy": "all-ordered",
        "questionNames": [question["name"] for question in questions],
        "questions": questions,
    }
    return {
        "name": name,
        "percentPass": 0,
        "duration": 0,
        "showQuestionGroupNames": False,
        "shuffleQuestionGroups": False,
        "navigation": {
            "allowregen": True,
            "reverse": True,
            "browse": True,
            "showfrontpage": False,
            "autoSubmit": False,  # a vector would be marked when its first component is left
        },
        "feedback": {
            "allowrevealanswer": True,
            "showactualmarkwhen": "always",
            "showtotalmarkwhen": "always",
            "showanswerstatewhen": "always",
            "showpartfeedbackmessageswhen": "always",
            "showexpectedanswerswhen": "inreview",
            "showadvicewhen": "inreview",
        },
        "question_groups": [group],
    }


def _questions(pool: Sequence[LmsItem], apart: bool) -> Iterator[dict[str, object]]:
    asked = [at for at, each in enumerate(pool[0].parts) if not isinstance(each, NotAsked)]
    problem = pool[0].exercise.problem
    name = f"{problem.code} {problem.title}"
    if not apart:
        if asked:
            yield _question(name, pool, asked)
        return
    for at in asked:
        yield _question(f"{name}, ({pool[0].parts[at].prompt.part.heading_letter})", pool, [at])


def _question(name: str, pool: Sequence[LmsItem], places: Sequence[int]) -> dict[str, object]:
    """A question with the parts at these places."""
    rows = [_row(item, places) for item in pool]
    definitions = {
        "variants": f"json_decode(safe({_jme_string(json.dumps(rows, ensure_ascii=False))}))",
        "variant": f"random(0..{len(rows) - 1})",
        "drawn": "variants[variant]",
    } | {column: f'drawn["{column}"]' for column in rows[0]}
    return {
        "name": name,
        "tags": [],
        "statement": f"{{statement}}<p>{escape(_numbers_only())}</p>",
        "advice": "{solution}",
        "functions": {"typed_number": READ},
        "preamble": {"js": "", "css": "math[display=block] { margin: 0.8em 0 }"},
        "variables": {
            name: {"name": name, "definition": definition, "templateType": "anything"}
            for name, definition in definitions.items()
        },
        "ungrouped_variables": list(definitions),
        "parts": [entry_of(pool[0].parts[at]) for at in places],
    }


def _row(item: LmsItem, places: Sequence[int]) -> dict[str, object]:
    row: dict[str, object] = {
        "statement": block(item.exercise.statement) + _figure(item),
        "solution": block(item.solution),
    }
    for at in places:
        row |= row_of(item.parts[at])
    return row


def _numbers_only() -> str:
    return _(
        "In each number field, write only the number, in the unit beside the field, with at least "
        "three significant figures: 4.71 or 6.30e-5. A decimal comma is accepted, too."
    )


def _figure(item: LmsItem) -> str:
    """The figure inside of the text; braces in what is said of it would be a formula to Numbas."""
    if not item.exercise.figure:
        return ""
    alt = escape(item.exercise.figure_alt).translate(str.maketrans("{}", "()"))
    return f'<p><img src="{drawing_address(item.exercise)}" alt="{alt}"></p>'


def _jme_string(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


TARGET = Target(ending="exam", items=write_items)
