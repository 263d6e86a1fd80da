"""A chain of equations, one a line."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

from corollary.kind.answer import Answer, Blank, Chain, Unclear
from corollary.kind.kind import Kind, Sample
from corollary.kind.number import PLACEHOLDERS
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.quantity.plain import Items, Nothing, Plain, Refused, Text
from corollary.quantity.syntax import parse
from corollary.quantity.tree import Relation
from corollary.quantity.trouble import Trouble, sentence

LONGEST = 30


@final
class Proof(Kind):
    def read(self, given: Plain, part: Part, problem: Problem) -> Answer:
        match given:
            case Nothing():
                return Blank()
            case Text(text):
                lines = [line for line in text.splitlines() if line.strip() not in PLACEHOLDERS]
            case Items(items, _) if all(isinstance(item, (Text, Nothing)) for item in items):
                lines = [item.text for item in items if isinstance(item, Text) and item.text.strip() not in PLACEHOLDERS]
            case Refused(why, shown):
                return Unclear(why, shown)
            case _:
                return Unclear("write a list of equations, each as text", "no list of texts")
        if not lines:
            return Blank()
        if len(lines) > LONGEST:
            return Unclear(f"more than {LONGEST} lines; keep to the steps that matter", f"{len(lines)} lines")
        names = [given.symbol for given in problem.givens] + list(part.components)
        chain = []
        for number, line in enumerate(lines, 1):
            sides = line.split("=")
            if len(sides) != 2:
                return Unclear(f"line {number} must be one equation, with one = sign", line.strip()[:80])
            trees = []
            for side in sides:
                tree = parse(side, names)
                if isinstance(tree, Trouble):
                    return Unclear(f"line {number}: {sentence(tree)}", line.strip()[:80])
                trees.append(tree)
            chain.append(Relation("=", trees[0], trees[1]))
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
