"""Laws put back: whether each holds identically, with every unknown put in."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterator

import sympy

from corollary.derive.claims import unfulfilled
from corollary.derive.derivation import Asserted
from corollary.derive.functions import is_differential, letters_in, put_back
from corollary.derive.known import Known, vanishes
from corollary.derive.load import load
from corollary.derive.sampled import holds
from corollary.derive.solve import Solver, solvers
from corollary.derive.statements import Confirm, Neglected, Step
from corollary.laws.law import Law, sides, symbols
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem


def unproven(bank: Bank, problem: Problem) -> tuple[int, list[str]]:
    """The laws checked: how many equations hold identically with every unknown put in, and which do not. Raises NotDerivable."""
    proven, left = 0, list[str]()
    for solver in solvers(problem, load(bank, problem)):
        solver.solution()
        found, missing = _put_back(solver)
        proven, left = proven + found, left + [each for each in missing if each not in left]
    return proven, left


def _put_back(solver: Solver) -> tuple[int, list[str]]:
    proven, left = 0, list[str]()
    for entry in solver.loaded.derivation.entries:
        step = entry.bound if isinstance(entry, Neglected) else entry
        if isinstance(step, Asserted):
            sentences = list(_unmet(step, solver.known))
            proven += (len(step.laws) if isinstance(step, Confirm) else 1) - len(sentences)
            left += [str(solver.failing(each, step.statement.line)) for each in sentences]
        if isinstance(step, Step):
            for law in (*step.laws, *(law for route in step.routes for law in route.laws)):
                for one, other in sides(law):
                    residual = solver.known.with_asides(one - other)
                    if _vanishes(residual, law, solver.known):
                        proven += 1
                    elif not residual.free_symbols & solver.known.measured:
                        sentence = f"{law.name} does not hold for the answers: {one} = {other}"
                        left.append(str(solver.failing(sentence, step.statement.line)))
    return proven, left


def _unconfirmed(known: Known, entry: Confirm) -> Iterator[str]:
    """What is wrong with each law that must hold for the answers and does not."""
    for law in entry.laws:
        try:
            residuals = [known.with_asides(one - other) for one, other in sides(law)]
            letters = letters_in([law], known)
            strange = {
                each for each in symbols(law) if each not in known.letters | letters | known.aside.keys()
            }
            if strange:
                yield f"{law.name}: {', '.join(sorted(map(str, strange)))} is neither given nor found before"
            elif not all(_vanishes(residual, law, known) for residual in residuals):
                yield f"{law.name} does not hold for the answers: a sign or a term is wrong, here or in a law of a step"
        except ValueError as error:
            yield f"{law.name}: {error}"


def _unmet(claim: Asserted, known: Known) -> Iterator[str]:
    """What is wrong with a claim, in sentences."""
    return _unconfirmed(known, claim) if isinstance(claim, Confirm) else unfulfilled(claim, known)


def _vanishes(residual: sympy.Expr, law: Law, known: Known) -> bool:
    """By algebra; where functions stood in the law, else at the sample points."""
    if is_differential(sides(law)):
        return holds(put_back(residual, ()), known, letters_in([law], known))
    return vanishes(residual)
