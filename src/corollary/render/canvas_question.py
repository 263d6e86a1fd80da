"""One question of Canvas in QTI 1.2, in the shape that Canvas itself exports and reads back."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

from corollary.render.pictures import as_files

LONGEST = 16_000
"""Signs of HTML: Canvas puts a sentence of its own in the place of more than 16 384."""
SPACE = re.compile(r"<mspace[^>]*?(?:/>|></mspace>)")  # whose width Canvas takes away
ANSWER = 'respident="response1"'
TYPED = '<response_str ident="response1" rcardinality="Single"><render_fib{}><response_label ident="answer1"/></render_fib></response_str>'


@dataclass(frozen=True, slots=True)
class CanvasOption:
    """One option: HTML, whether it is right, and what is said of it (HTML, or "")."""

    html: str
    right: bool
    feedback: str


@dataclass(frozen=True, slots=True)
class CanvasQuestion:
    """A field with its text. Of a number, `ranges` are (lowest, right, highest); with neither ranges nor options it is an essay.

    `ident` is its own, `body` and `comments` (which everybody reads afterwards) are HTML.
    """

    ident: str
    title: str
    points: float
    body: str
    comments: str
    ranges: Sequence[tuple[float, float, float]] = ()
    options: Sequence[CanvasOption] = ()

    @property
    def fits(self) -> bool:
        return len(_spaced(as_files(self.body)[0])) <= LONGEST

    def xml(self) -> str:
        kind, field, rules, feedback = _parts(self)
        if self.comments:
            everybody = "<conditionvar><other/></conditionvar>"
            rules = (
                f'<respcondition continue="Yes">{everybody}{_displayed("general_fb")}</respcondition>{rules}'
            )
            feedback += _feedback("general_fb", self.comments)
        about = {
            "question_type": kind,
            "points_possible": f"{self.points:.12g}",
            "original_answer_ids": ",".join(map(str, _idents(self))),
        }
        fields = "".join(
            f"<qtimetadatafield><fieldlabel>{label}</fieldlabel><fieldentry>{entry}</fieldentry></qtimetadatafield>"
            for label, entry in about.items()
        )
        return (
            f"<item ident={quoteattr(self.ident)} title={quoteattr(self.title)}><itemmetadata><qtimetadata>{fields}</qtimetadata></itemmetadata>"
            f"<presentation>{_material(f'<div>{self.body}</div>')}{field}</presentation>"
            '<resprocessing><outcomes><decvar maxvalue="100" minvalue="0" varname="SCORE" vartype="Decimal"/></outcomes>'
            f"{rules}</resprocessing>{feedback}</item>\n"
        )


def _parts(question: CanvasQuestion) -> tuple[str, str, str, str]:
    """The type, the field, the rules and what is said of single answers."""
    if question.ranges:
        rules = "".join(_scored(_range(*each)) for each in question.ranges)
        return "numerical_question", TYPED.format(' fibtype="Decimal"'), rules, ""
    if not question.options:
        rules = '<respcondition continue="No"><conditionvar><other/></conditionvar></respcondition>'
        return "essay_question", TYPED.format(""), rules, ""
    named = list(zip(_idents(question), question.options, strict=True))
    labels = "".join(
        f'<response_label ident="{name}">{_material(each.html)}</response_label>' for name, each in named
    )
    field = f'<response_lid ident="response1" rcardinality="Single"><render_choice>{labels}</render_choice></response_lid>'
    reactions = "".join(
        f'<respcondition continue="Yes"><conditionvar><varequal {ANSWER}>{name}</varequal></conditionvar>{_displayed(f"{name}_fb")}</respcondition>'
        for name, each in named
        if each.feedback
    )
    right = "".join(_scored(f"<varequal {ANSWER}>{name}</varequal>") for name, each in named if each.right)
    feedback = "".join(_feedback(f"{name}_fb", each.feedback) for name, each in named if each.feedback)
    return "multiple_choice_question", field, reactions + right, feedback


def _idents(question: CanvasQuestion) -> Sequence[int]:
    """Canvas numbers its answers."""
    return range(101, 101 + len(question.options))


def _range(low: float, right: float, high: float) -> str:
    """`right` with its margin, which Canvas reads off the upper end; the bounds alone where they are not alike."""
    bounds = f"<vargte {ANSWER}>{_float(low)}</vargte><varlte {ANSWER}>{_float(high)}</varlte>"
    if abs((high - right) - (right - low)) > 1e-6 * (high - low):
        return bounds
    return f"<or><varequal {ANSWER}>{_float(right)}</varequal><and>{bounds}</and></or>"


def _float(value: float) -> str:
    """Without an exponent, which is lost on the way."""
    text = f"{value + 0.0:.12f}".rstrip("0")
    return f"{text}0" if text.endswith(".") else text


def _scored(condition: str) -> str:
    score = '<setvar action="Set" varname="SCORE">100</setvar>'
    return f'<respcondition continue="No"><conditionvar>{condition}</conditionvar>{score}</respcondition>'


def _displayed(name: str) -> str:
    return f'<displayfeedback feedbacktype="Response" linkrefid="{name}"/>'


def _feedback(name: str, html: str) -> str:
    return f'<itemfeedback ident="{name}"><flow_mat>{_material(html)}</flow_mat></itemfeedback>'


def _material(html: str) -> str:
    return f'<material><mattext texttype="text/html">{escape(_spaced(html))}</mattext></material>'


def _spaced(html: str) -> str:
    return SPACE.sub("<mtext>\u2009</mtext>", html)
