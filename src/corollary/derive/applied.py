"""Laws, routes, proofs and suppositions in our own terms: in the letters of the problem, nothing simplified, values in SI."""

from __future__ import annotations

from collections.abc import Collection

from corollary.answers.quantity import read_quantity
from corollary.derive.assumptions import Known
from corollary.derive.sampled import compared
from corollary.derive.solution import AppliedLaw, SolvedProof, SupposedValue
from corollary.derive.statements import Mistake, Proof, Route, Supposed
from corollary.formula.ast import Name, Relation, names, substitute
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import tree
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula
from corollary.formula.to_sympy import expression
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


def applied_proof(entry: Proof[Law], stated: str = "") -> SolvedProof:
    """`stated` are the equations that the question states, parted by semicolons. Raises ValueError where one is none."""
    mistakes = tuple(
        Mistake(mistake.text, tuple(map(applied, mistake.rule)), mistake.line, mistake.name)
        for mistake in entry.mistakes
    )
    laws = tuple(map(applied, entry.laws))
    given = (
        *map(applied, entry.given),
        *(_in_question(each.strip()) for each in stated.split(";") if each.strip()),
    )
    rates = tuple((letter, tree(by_name(rate))) for letter, rate in entry.rates)
    return Proof(entry.statement, laws, applied(entry.target), entry.lines, mistakes, given, rates)


def _in_question(stated: str) -> AppliedLaw:
    equation = author_formula(stated)
    if not isinstance(equation, Relation) or equation.sign != "=":
        raise ValueError(f'given="{stated}" in the question is no equation; write one, such as w^2 = k/m')
    return AppliedLaw("stated in the question", "", "", equation, frozenset(), (equation,))


def untrue_given(proof: SolvedProof, known: Known) -> str:
    """What is wrong with an equation that is given, or "". It sets a letter that has no value, or a given for this part alone (equal
    masses, m_B = m_A), or it holds for what is given and found."""
    letters = {each.name: each for each in (*known.letters, *known.aside)}
    givens = {symbol.name for symbol, formula in known.formulas.items() if symbol == formula}
    set_before = set[str]()
    for equation in (equation for law in proof.given for equation in law.here):
        strange = sorted(names(equation) - letters.keys() - set_before - {"pi"})
        if strange and equation.left == Name(strange[0]) and len(strange) == 1:
            set_before.add(strange[0])
        elif strange:
            return (
                f"{text(equation)} is given, and {strange[0]} is neither given nor found; find it in a step, "
                f"or set it by an equation with {strange[0]} alone on its left"
            )
        elif isinstance(equation.left, Name) and equation.left.name in givens:
            set_before.add(equation.left.name)
        elif not set_before & names(equation):
            same = compared(expression(equation.left, letters), expression(equation.right, letters), known)
            if not same.holds:
                return f"{text(equation)} is given, and does not hold for the answers; {same.at_numbers()}"
    return ""


def strange_letter(entry: Proof[Law], known: Collection[str], also: Collection[str] = ()) -> str:
    """What is wrong with a letter of a proof that has no value (its lines are tried at numbers), or ""."""
    defined = {str(left) for law in entry.given for left, _right in sides(law)} | {*also}
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
