"""Laws, routes, proofs and suppositions in our own terms: in the letters of the problem, nothing simplified, values in SI."""

from __future__ import annotations

from collections.abc import Collection

from corollary.answers.quantity import read_quantity
from corollary.derive.solution import AppliedLaw, SolvedProof, SupposedValue
from corollary.derive.statements import Mistake, Proof, Route, Supposed
from corollary.formula.ast import Name, Relation, substitute
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import tree
from corollary.formula.plain_text import text
from corollary.laws.law import Law, by_name, equations, sides, symbols
from corollary.units.unit import Dimension, unit


def applied(law: Law) -> AppliedLaw:
    """The law with its letters replaced and nothing simplified."""
    here: list[Relation] = []
    for equation, letters in equations(law):
        meaning = {letter: tree(by_name(value)) for letter, value in letters.items()}
        left, right = (substitute(side, meaning) for side in (equation.left, equation.right))
        here.append(Relation("=", left, right))
    return AppliedLaw(law.name, law.source, law.holds, law.textbook, law.vectors, tuple(here))


def supposed_value(stated: Supposed) -> SupposedValue:
    """The value in SI. Raises ValueError where the text is no quantity."""
    read = read_quantity(stated.text, unit("1"))
    if isinstance(read, ParseError):
        raise ValueError(f"{stated.name} is supposed to be {stated.text!r}: {read.why}")
    ratio, pi = read.si
    if pi:
        raise ValueError(f"{stated.name} is supposed to be {stated.text!r}; give angles in rad")
    return SupposedValue(stated, ratio, read.unit.dimension if read.unit else Dimension())


def applied_proof(entry: Proof[Law]) -> SolvedProof:
    """Raises ValueError where what is given sets no letter."""
    mistakes = tuple(
        Mistake(mistake.text, tuple(map(applied, mistake.rule)), mistake.line) for mistake in entry.mistakes
    )
    laws = tuple(map(applied, entry.laws))
    given = tuple(map(applied, entry.given))
    for equation in (equation for law in given for equation in law.here):
        if not isinstance(equation.left, Name):
            raise ValueError(f"{text(equation)} is given, but has no letter alone on its left")
    rates = tuple((letter, tree(by_name(rate))) for letter, rate in entry.rates)
    return Proof(entry.statement, laws, applied(entry.target), entry.lines, mistakes, given, rates)


def strange_letter(entry: Proof[Law], known: Collection[str]) -> str:
    """What is wrong with a letter of a proof that has no value (its lines are tried at numbers), or ""."""
    defined = {str(left) for law in entry.given for left, _right in sides(law)}
    for law in (*entry.laws, entry.target, *(law for each in entry.mistakes for law in each.rule)):
        if strange := sorted({symbol.name for symbol in symbols(law)} - defined - set(known)):
            return (
                f"{strange[0]} in {law.name or text(law.textbook)} is neither given nor found; "
                "find it in a step, or say what it is in given=[law(…)]"
            )
    for letter, rate in entry.rates:
        if strange := sorted({letter, *(each.name for each in rate.free_symbols)} - defined - set(known)):
            return f"{strange[0]} in rates= is neither given nor found"
    return ""


def applied_route(route: Route[Law]) -> Route[AppliedLaw]:
    return Route(route.because, tuple(map(applied, route.laws)), route.line)
