"""An exam as Numbas has it, which draws numbers in the browser, without a server: a question for each problem.

The question holds a table of variants and draws one of its rows; "Try another question like this one" draws again. All texts,
figures and marks come from that row.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from html import escape
from itertools import groupby

from corollary.messages import catalogue
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.item import ChoiceAsked, LmsItem, NotAsked, NumbersAsked, PartAsked, ProseAsked
from corollary.render.numbas_parts import READ, block, entry_of, row_of
from corollary.render.page import drawing_address

_ = catalogue(__name__)

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
        "Into each field for a number write the number alone, in the unit that stands beside it, with three significant figures "
        "or more: 4.71 or 6.30e-5. A decimal comma is understood, too."
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
