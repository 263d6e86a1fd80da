"""Laws and claims with every unknown put back into them."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

import sympy

from corollary.derive.claims import unfulfilled
from corollary.derive.derivation import Asserted
from corollary.derive.functions import is_differential, letters_in, put_back
from corollary.derive.known import Known
from corollary.derive.sampled import NO_NUMBERS, Equality, How, compared, holds, identical
from corollary.derive.solve import Solver
from corollary.derive.statements import Confirm, Neglected, Step
from corollary.laws.law import Law, sides, symbols


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
                    simulated = (one - other).free_symbols & solver.known.measured
                    usual = PutBack(line, "simulated")
                    found = usual if simulated else _one_put_back(one, other, law, solver, line)
                    yield replace(found, names=tuple(symbol.name for symbol in step.unknowns))


def _one_put_back(one: sympy.Expr, other: sympy.Expr, law: Law, solver: Solver, line: int) -> PutBack:
    found = _equality(one, other, law, solver.known)
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
