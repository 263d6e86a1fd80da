"""The page about somebody else's answer key, to send to whoever keeps it: what was found, and how anybody can see it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from corollary.audit.outcome import FAULTS, FINDINGS, AuditedAnswer
from corollary.formula.ast import Name, Relation
from corollary.formula.latex import latex
from corollary.formula.syntax import author_formula
from corollary.render.mathml import mathml
from corollary.render.page import page

ORDER = ("wrong", "not unique", "impossible", "ambiguous", "last figure", "cannot say", "agrees")
MEANINGS: Mapping[str, str] = {
    "agrees": "is what the laws give, to its own figures",
    "last figure": "differs by one in its last figure",
    "wrong": "is not what the laws give",
    "not unique": "is one of several answers that the statement admits",
    "impossible": "answers a statement that no real numbers satisfy",
    "ambiguous": "is right under a convention that the statement does not say",
    "cannot say": "was not compared",
}


@dataclass(frozen=True, slots=True)
class FormulaSet:
    """An equation set as mathematics, and its name where that is not the equation itself."""

    name: str
    markup: Markup


def audit_page(outcomes: Sequence[AuditedAnswer]) -> str:
    """One file with everything in it; what disagrees comes first."""
    counts = Counter(each.finding for each in outcomes)
    groups = {name: [each for each in outcomes if each.finding == name] for name in ORDER if counts[name]}
    sources = dict.fromkeys(each.record.source for each in outcomes if each.record.source)
    return page(
        "audit.html",
        title="Audit of an answer key",
        style="report.css",
        counts={name: counts[name] for name in FINDINGS if counts[name]},
        total=len(outcomes),
        groups=groups,
        meanings=MEANINGS,
        faults=FAULTS,
        sources=list(sources),
        isolations=list(dict.fromkeys(each.record.isolation for each in outcomes if each.record.isolation)),
        laws=laws_set,
        equation=equation_set,
    )


def laws_set(outcome: AuditedAnswer) -> list[FormulaSet]:
    """The laws of the record."""
    return [
        FormulaSet("" if law.name == law.formula else law.name, _set(law.formula))
        for law in outcome.record.laws
    ]


def equation_set(outcome: AuditedAnswer) -> Markup:
    """What was derived, in letters; nothing where no formula was found."""
    if not outcome.formula:
        return Markup()
    try:
        tree = Relation("=", Name(outcome.asked), author_formula(outcome.formula))
    except ValueError:
        return Markup("<code>{}</code>").format(outcome.formula)
    return Markup(mathml(latex(tree)))


def _set(formula: str) -> Markup:
    try:
        return Markup(mathml(latex(author_formula(formula))))
    except ValueError:
        return Markup("<code>{}</code>").format(formula)
