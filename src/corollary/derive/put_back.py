"""Laws put back: whether each holds identically, with every unknown put in."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import sympy

from corollary.derive.functions import is_differential, letters_in, put_back
from corollary.derive.known import Known, vanishes
from corollary.derive.load import load
from corollary.derive.sampled import holds
from corollary.derive.solve import Solver, solvers
from corollary.derive.statements import Neglected, Step
from corollary.laws.law import Law, sides
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


def _vanishes(residual: sympy.Expr, law: Law, known: Known) -> bool:
    """By algebra; where functions stood in the law, else at the sample points."""
    if is_differential(sides(law)):
        return holds(put_back(residual, ()), known, letters_in([law], known))
    return vanishes(residual)
