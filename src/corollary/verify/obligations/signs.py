"""Claims of the statement: an answer has the sign that its question speaks of, and what an author says is always so is so."""

from __future__ import annotations

import re
from collections.abc import Iterator

from corollary.derive.solution import Solution
from corollary.formula.ast import Relation
from corollary.problem.part import Part
from corollary.verify.obligations.obligation import Obligation
from corollary.verify.obligations.values import ZERO

SIZES = (
    "speed", "distance", "height", "depth", "length", "width", "radius", "diameter", "duration", "mass", "magnitude", "period",
    "frequency", "kinetic energy",
)  # fmt: skip
ASKED = re.compile(
    rf"\b(?:at |with )?(?:what|which)(?: (?:is|was|are|were|must be|will be))?(?: (?:the|its|their|your|his|her))?(?: \w+)?"
    rf" (?P<size>{'|'.join(SIZES)})\b(?! (?:difference|change))|\bhow (?P<how>fast|long|far|high|deep|heavy|many)\b",
    re.IGNORECASE,
)
TRUE_AT_ONCE = "sympy takes the condition for true before it has numbers; in quotes it is proven as it stands"


def of_claimed_sign(solution: Solution) -> Iterator[Obligation]:
    """Of the answers whose part asks in English for what cannot be negative."""
    for find in solution.unknowns:
        if not find.part or find.in_givens is None or len(find.in_givens) != 1:
            continue
        words = size_asked(solution.problem.part(find.part))
        if not words:
            continue
        (tree,) = find.in_givens
        claim = f"part {find.part} is not negative, for it asks {words!r}"
        yield Obligation("claimed sign", claim, find.statement.line, ((Relation(">=", tree, ZERO),),))


def size_asked(part: Part) -> str:
    """The words by which a question asks for what cannot be negative; "" where it does not."""
    asked = ASKED.search(part.text)
    if asked is None or part.unit.offset:
        return ""
    return asked["size"] or f"how {asked['how']}"


def always_so(solution: Solution) -> Iterator[Obligation]:
    """What the statement says in words, and `always(…)` in the solution as a condition."""
    for each in solution.always:
        needs = each.conditions
        yield Obligation(
            "claimed", each.words, each.line, needs, open="" if needs else TRUE_AT_ONCE, tried=False
        )
