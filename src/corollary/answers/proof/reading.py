"""How a chain of equations is asked for and read, one a line."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Chain, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.formula import symbols_note
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.question import Question
from corollary.formula.ast import Expr, Relation
from corollary.formula.errors import ParseError, sentence
from corollary.formula.syntax import parse
from corollary.formula.tex import without_tex
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST, LONGEST_LINE = 30, 400
LEADING = re.compile(
    r"\s*(?:(?:=>|⇒|⟹|→|<=>|⇔|\\Rightarrow|\\implies|\\iff|-|\*|\(?[0-9]{1,2}[.)])\s+"
    r"|(?:so|thus|hence|therefore|then|and|or|with|where|because|since|also|now)\b[:,]?\s+|[A-Za-z][^=:]*:\s*)*",
    re.IGNORECASE,
)
BEHIND = re.compile(r"\s*(?:[.,;]|\(\*{0,2}[0-9]{1,2}\)|\([ivIV]+\))*\s*$")


def _equations(line: str, names: Sequence[str], before: Expr | None) -> list[Relation] | str:
    """The equations of one line; `a = b = c` says two things of a, `= b` goes on from the line before, words alone are none.

    A text says, after the line's number, what could not be read.
    """
    if "=" not in LEADING.sub("", line, count=1):
        return (
            []
            if re.search(r"[^\W\d]{3}", line) and not re.search(r"[*^/+<>]", line)
            else _(" must be one equation, with one = sign")
        )
    typed = without_tex(line.replace("&=", "=").replace("&", ""))
    sides = BEHIND.sub("", LEADING.sub("", typed, count=1)).split("=")
    trees: list[Expr] = []
    for place, side in enumerate(sides):
        if not side.strip() and place == 0 and before is not None:
            trees.append(before)
            continue
        tree = parse(side, names)
        if isinstance(tree, ParseError):
            return f": {sentence(tree)}"
        trees.append(tree)
    return [Relation("=", trees[0], right) for right in trees[1:]]


@final
class ProofType(AnswerType):
    name, word, stated_by = "proof", "proof", "proof"
    accepts, lists_components = frozenset({"components"}), False

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
        lines = [line for line in texts if line.strip() not in PLACEHOLDERS]
        if not lines:
            return Blank()
        if len(lines) > LONGEST:
            return Unclear(
                _("more than {count} lines; keep to the steps that matter", count=LONGEST),
                _("{count} lines", count=len(lines)),
            )
        names = [*question.symbol_names, *question.components]
        chain: list[Relation] = []
        for number, line in enumerate(lines, 1):
            if len(line) > LONGEST_LINE:
                return Unclear(
                    _("line {number} is longer than {count} characters", number=number, count=LONGEST_LINE),
                    line.strip()[:80],
                )
            found = _equations(line, names, chain[-1].left if chain else None)
            if isinstance(found, str):
                return Unclear(_("line {number}{why}", number=number, why=found), line.strip()[:80])
            chain += found
        if not chain:
            return Unclear(_("no line is an equation; write each step with an = sign"), lines[0].strip()[:80])
        return Chain(tuple(chain), "; ".join(line.strip() for line in lines))


TYPE = ProofType()
