"""Laws and claims put back: limits, special cases, and each law with everything found in it."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import sympy

from corollary.derive.assumptions import Known
from corollary.derive.derivation import Asserted, Limit, Special
from corollary.derive.function_values import is_differential, letters_in, put_back
from corollary.derive.sampled import NO_NUMBERS, Equality, How, compared, holds, identical
from corollary.derive.solve import Solver
from corollary.derive.statements import Confirm, Neglected, Step
from corollary.formula.ast import Relation, names
from corollary.formula.errors import ParseError, sentence
from corollary.formula.from_sympy import NoTree, tree
from corollary.laws.law import Law, sides, symbols
from corollary.units.dimensional_analysis import dimension_of

UNSETTLED = (sympy.nan, sympy.zoo)


def unfulfilled(claim: Limit | Special, known: Known) -> Iterator[str]:
    """A sentence for each thing that is not as claimed."""
    measured = known.measured & {symbol for each in _expressions(claim) for symbol in each.free_symbols}
    if measured:
        names = ", ".join(sorted(symbol.name for symbol in measured))
        yield f"{names} comes from a simulation: only of closed forms can be said what they are somewhere else"
    elif isinstance(claim, Limit):
        yield from _limit(claim, known)
    else:
        yield from _special(claim, known)


def _expressions(claim: Limit | Special) -> Iterator[Any]:
    if isinstance(claim, Limit):
        yield from (claim.of, claim.equals)
    else:
        yield from claim.values.values()
        yield from (sympy.Symbol(name, real=True) for name in claim.values)


def _limit(claim: Limit, known: Known) -> Iterator[str]:
    about = f"the limit of {claim.of} for {claim.letter} to {claim.to}"
    expression, letter = known.with_asides(claim.of), known.with_asides(claim.letter)
    if strange := _strange((claim.of, claim.letter, claim.to, claim.equals), known):
        yield f"{about}: {strange} is neither given nor found"
        return
    if not isinstance(letter, sympy.Symbol):
        yield f"{about}: {claim.letter} is found, and depends on givens; let one of these go to its limit"
        return
    pairs = ((claim.of, claim.equals), (claim.letter, claim.to))
    if not _misfits([(claim.of, claim.of)], known) and (misfits := _misfits(pairs, known)):
        yield from (f"{about}: {each}" for each in misfits)
        return
    if letter not in expression.free_symbols:
        yield f"{about}: it does not depend on {claim.letter}, it is {expression} everywhere"
        return
    found = _towards(expression, letter, known.with_asides(claim.to))
    wanted = known.with_asides(claim.equals)
    if found is None:
        yield f"{about} cannot be worked out; leave it out, or claim a special case with at(…)"
    elif found != wanted:
        yield from _different(about, found, wanted, claim.equals, known)


def _special(claim: Special, known: Known) -> Iterator[str]:
    givens = {symbol.name: symbol for symbol in known.formulas if known.formulas[symbol] == symbol}
    found = {symbol.name: symbol for symbol in (*known.formulas, *known.aside) if symbol.name not in givens}
    at = {givens[name]: known.with_asides(value) for name, value in claim.values.items() if name in givens}
    case = ", ".join(f"{symbol} = {value}" for symbol, value in at.items()) or "any numbers"
    unknown = sorted(claim.values.keys() - givens.keys() - found.keys())
    strange = unknown[0] if unknown else _strange(claim.values.values(), known)
    if strange:
        yield f"at {case}: {strange} is neither given nor found"
        return
    if misfits := _misfits(((sympy.Symbol(name), value) for name, value in claim.values.items()), known):
        yield from (f"at {case}: {each}" for each in misfits)
        return
    claimed = {found[name]: value for name, value in claim.values.items() if name in found}
    if not claimed:
        yield f"at {case}: it claims nothing; say what something found is there, as in at(mA=mB, v=0)"
    for symbol, value in claimed.items():
        there = known.with_asides(symbol).subs(at, simultaneous=True)
        if there.has(*UNSETTLED) and len(at) == 1:  # 0/0, which has a limit
            ((letter, to),) = at.items()
            there = _towards(known.with_asides(symbol), letter, to)
        wanted = known.with_asides(value).subs(at, simultaneous=True)
        if there is None or there.has(*UNSETTLED):
            yield f"at {case}: {symbol} has no value"
        elif there != wanted:
            yield from _different(f"at {case}: {symbol}", there, wanted, value, known)


def _different(about: str, found: Any, wanted: Any, claimed: object, known: Known) -> Iterator[str]:
    """A sentence where what is found is not what is claimed, or where that was not decided."""
    same = (
        Equality("differ") if False in (found.is_finite, wanted.is_finite) else compared(found, wanted, known)
    )
    if same.how == "differ":
        numbers = f" ({same.at_numbers('it', 'the claim')})" if same.at else ""
        yield f"{about} is {found}, not {claimed}{numbers}"
    elif not same.holds:
        yield f"{about} is {found}; whether that is {claimed} was not decided, neither by algebra nor at numbers"


def _misfits(pairs: Iterable[tuple[Any, Any]], known: Known) -> list[str]:
    """A sentence for each pair of formulas that do not measure the same: what an author sets equal is compared as conditions are."""
    found: list[str] = []
    for one, other in pairs:
        try:
            compare = Relation("=", tree(one), tree(other))
            asides = {
                each.name: dimension_of(tree(known.aside[each]), known.dimensions) for each in known.aside
            }
        except NoTree:
            continue
        dimensions = known.dimensions | {k: v for k, v in asides.items() if not isinstance(v, ParseError)}
        if names(compare) <= dimensions.keys() | {"pi"}:
            dimension = dimension_of(compare, dimensions)
            found += [sentence(dimension)] if isinstance(dimension, ParseError) else []
    return found


def _strange(expressions: Any, known: Known) -> str:
    """A letter that means nothing in this problem; "" where there is none."""
    symbols = {symbol for each in expressions for symbol in sympy.sympify(each).free_symbols}
    return next((name for name in sorted(symbol.name for symbol in symbols) if name not in known.names), "")


def _towards(expression: Any, letter: sympy.Symbol, to: Any) -> Any:
    """The limit, from both sides where the letter may lie on both; None where sympy has none."""
    side = "+" if letter.is_nonnegative and to == 0 else "-" if letter.is_nonpositive and to == 0 else "+-"
    try:
        found: Any = sympy.limit(expression, letter, to, side if sympy.sympify(to).is_finite else "+")
    except (NotImplementedError, ValueError, TypeError):  # too hard for it, or not the same from both sides
        return None
    return None if found.has(sympy.Limit) or found.has(sympy.AccumBounds) else found


@dataclass(frozen=True, slots=True)
class PutBack:
    """An equation of a law, or a claim, with all that was found put in: how it holds, or the sentence that says why not.

    `line` is that of the step or claim, `names` what a step finds, `case` the one it stands in. What is found by a simulation has
    no formula to be put in ("simulated"); "refused" is a claim. An equation that differs does so `at` numbers, which the sentence
    tells with both values.
    """

    line: int
    how: How | Literal["simulated", "refused"]
    complaint: str = ""
    at: Mapping[str, str] = field(default_factory=lambda: NO_NUMBERS)
    names: tuple[str, ...] = ()
    case: str = ""


def put_laws_back(solvers: Iterable[Solver]) -> list[PutBack]:
    """Every law and every claim of a derivation, those of each case, by the solvers that have found what is put in."""
    return [replace(each, case=solver.case) for solver in solvers for each in _put_back(solver)]


def _put_back(solver: Solver) -> Iterator[PutBack]:
    for entry in solver.loaded.derivation.entries:
        step = entry.bound if isinstance(entry, Neglected) else entry
        line = step.statement.line
        if isinstance(step, Asserted):
            sentences = [str(solver.failing(each, line)) for each in _unmet(step, solver.known)]
            yield from (PutBack(line, "refused", each) for each in sentences)
            claimed = len(step.laws) if isinstance(step, Confirm) else 1
            yield from [PutBack(line, "algebra")] * (claimed - len(sentences))
        if isinstance(step, Step):
            for law in (*step.laws, *(law for route in step.routes for law in route.laws)):
                for one, other in sides(law):
                    known = solver.known if step.each is None else with_entry(solver, step)
                    simulated = (one - other).free_symbols & known.measured
                    usual = PutBack(line, "simulated")
                    found = usual if simulated else _one_put_back(one, other, law, solver, line, known)
                    yield replace(found, names=tuple(symbol.name for symbol in step.unknowns))


def with_entry(solver: Solver, step: Step) -> Known:
    """What is known of a list: the entry of each number at the points, in the letter of the range."""
    return solver.known_in_list[step.statement.line]


def _one_put_back(
    one: sympy.Expr, other: sympy.Expr, law: Law, solver: Solver, line: int, known: Known
) -> PutBack:
    found = _equality(one, other, law, known)
    if found.holds:
        return PutBack(line, found.how)
    fault = f"{law.name} does not hold for the answers: {one} = {other}; {found.at_numbers()}"
    if found.how == "undecided":
        fault = f"{law.name}: whether {one} = {other} holds for the answers was not decided, neither by algebra nor at numbers"
    return PutBack(line, found.how, str(solver.failing(fault, line)), found.at)


def _unconfirmed(known: Known, entry: Confirm) -> Iterator[str]:
    """What is wrong with each law that must hold for the answers and does not."""
    for law in entry.laws:
        try:
            letters = letters_in([law], known)
            strange = {
                each for each in symbols(law) if each not in known.letters | letters | known.aside.keys()
            }
            if strange:
                yield f"{law.name}: {', '.join(sorted(map(str, strange)))} is neither given nor found before"
                continue
            found = [_equality(one, other, law, known) for one, other in sides(law)]
            if broken := next((each for each in found if each.how == "differ"), None):
                yield f"{law.name} does not hold for the answers: a sign or a term is wrong, here or in a law of a step ({broken.at_numbers()})"
            elif not all(each.holds for each in found):
                yield f"{law.name}: whether it holds for the answers was not decided, neither by algebra nor at numbers"
        except ValueError as error:
            yield f"{law.name}: {error}"


def _unmet(claim: Asserted, known: Known) -> Iterator[str]:
    """What is wrong with a claim, in sentences."""
    return _unconfirmed(known, claim) if isinstance(claim, Confirm) else unfulfilled(claim, known)


def _equality(one: sympy.Expr, other: sympy.Expr, law: Law, known: Known) -> Equality:
    """By algebra or at the sample points; where functions stand in the law, for numbers of what they depend on, too."""
    if not is_differential(sides(law)):
        return compared(one, other, known)
    letters = letters_in([law], known)
    left, right = (put_back(known.with_asides(side), ()) for side in (one, other))
    found = identical(left, right, known, letters)
    if found.how == "undecided" and holds(left - right, known, letters):
        return Equality("points", len(known.points))  # an integral without a formula
    return found
