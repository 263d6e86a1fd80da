"""Derivations, asked for and read: a chain of equations, one a line."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer, Blank, Chain, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.formula import symbols_note
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.proof.steps import steps_of
from corollary.answers.question import Question
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST, LONGEST_LINE = 60, 400


@final
class ProofType(AnswerType):
    name, word, stated_by = "proof", "proof", "proof"
    accepts, lists_components = frozenset({"components"}), False
    in_lines = True

    def instructions(self, question: Question) -> str:
        more = _(
            "; and, as said above, {names}", names=", ".join(f"`{name}`" for name in question.components)
        )
        return symbols_note(question, more)

    def blank(self, question: Question) -> str:
        remark = _('one equation a line, each as text: "a + b = c"')
        return f'{question.name} = [\n    "",   # {remark}\n]'

    def read(self, value: Value, question: Question) -> Answer:
        match value:
            case Nothing():
                return Blank()
            case Text(text):
                texts = text.splitlines()
            case Items(items) if all(isinstance(item, (Text, Nothing)) for item in items):
                texts = [item.text for item in items if isinstance(item, Text)]
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("write a list of equations, each as text"), _("no list of texts"))
        lines = [(number, line) for number, line in enumerate(texts, 1) if line.strip() not in PLACEHOLDERS]
        if not lines:
            return Blank()
        if len(lines) > LONGEST:
            return Unclear(
                _("more than {count} lines; keep to the steps that matter", count=LONGEST),
                _("{count} lines", count=len(lines)),
            )
        for number, line in lines:
            if len(line) > LONGEST_LINE:
                return Unclear(
                    _("line {number} is longer than {count} characters", number=number, count=LONGEST_LINE),
                    line.strip()[:80],
                )
        steps = steps_of(lines, [*question.symbol_names, *question.components])
        if isinstance(steps, Unclear):
            return steps
        if not steps:
            return Unclear(
                _("no line is an equation; write each step with an = sign"), lines[0][1].strip()[:80]
            )
        return Chain(steps, "; ".join(line.strip() for _number, line in lines))


TYPE = ProofType()
