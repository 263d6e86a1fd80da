"""A chain of equations, one a line."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Chain, Unclear
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.numbers import PLACEHOLDERS
from corollary.formula.ast import Expr, Relation
from corollary.formula.errors import ParseError, sentence
from corollary.formula.syntax import parse
from corollary.formula.tex import without_tex
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem

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
            else " must be one equation, with one = sign"
        )
    plain = without_tex(line.replace("&=", "=").replace("&", ""))
    sides = BEHIND.sub("", LEADING.sub("", plain, count=1)).split("=")
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
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        match given:
            case Nothing():
                return Blank()
            case Text(text):
                lines = [line for line in text.splitlines() if line.strip() not in PLACEHOLDERS]
            case Items(items, _) if all(isinstance(item, (Text, Nothing)) for item in items):
                lines = [
                    item.text
                    for item in items
                    if isinstance(item, Text) and item.text.strip() not in PLACEHOLDERS
                ]
            case Refused(why, shown):
                return Unclear(why, shown)
            case _:
                return Unclear("write a list of equations, each as text", "no list of texts")
        if not lines:
            return Blank()
        if len(lines) > LONGEST:
            return Unclear(f"more than {LONGEST} lines; keep to the steps that matter", f"{len(lines)} lines")
        names = [given.symbol for given in problem.givens] + list(part.components)
        chain: list[Relation] = []
        for number, line in enumerate(lines, 1):
            if len(line) > LONGEST_LINE:
                return Unclear(f"line {number} is longer than {LONGEST_LINE} characters", line.strip()[:80])
            found = _equations(line, names, chain[-1].left if chain else None)
            if isinstance(found, str):
                return Unclear(f"line {number}{found}", line.strip()[:80])
            chain += found
        if not chain:
            return Unclear("no line is an equation; write each step with an = sign", lines[0].strip()[:80])
        return Chain(tuple(chain), "; ".join(line.strip() for line in lines))

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        """`truth` holds a right chain, one equation a line."""
        assert isinstance(truth, str)
        lines = truth.splitlines()
        return (
            Sample(lines, "right"),
            Sample(["1 = 1", lines[-1]], "wrong"),
            Sample([*lines[:-1], "0 = 1"], "wrong"),
            Sample(["so it is"], "unread"),
            Sample(4, "unread"),
            Sample(None, "unread"),
        )
