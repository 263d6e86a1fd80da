"""Laws put back: whether each holds identically, with every unknown put in."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import sympy

from corollary.derive.claims import unfulfilled
from corollary.derive.derivation import Asserted, Derivation
from corollary.derive.functions import is_differential, letters_in, put_back
from corollary.derive.known import Known, vanishes
from corollary.derive.load import Loaded, NotDerivable, load
from corollary.derive.sampled import holds
from corollary.derive.solve import Solver, solvers
from corollary.derive.statements import Confirm, Neglected, Step
from corollary.formula.ast import Negative, Number, Relation, Sum
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


def unseen(bank: Bank, problem: Problem, step_line: int) -> list[str]:
    """The laws of a step in which some sign can be changed and all that is claimed still holds. Raises NotDerivable."""
    loaded = load(bank, problem)
    found: list[str] = []
    for place, entry in enumerate(loaded.derivation.entries):
        if isinstance(entry, Step) and entry.statement.line == step_line:
            for index, law in enumerate(entry.laws):
                if any(
                    not _noticed(
                        problem, loaded, place, replace(entry, laws=_exchanged(entry.laws, index, other))
                    )
                    for other in _with_a_sign_changed(law)
                ):
                    found.append(law.name)
    return found


def _noticed(problem: Problem, loaded: Loaded, place: int, changed: Step) -> bool:
    """Whether a derivation with a step changed cannot be solved, or contradicts what must hold."""
    entries = list(loaded.derivation.entries)
    entries[place] = replace(changed, mistakes=(), routes=(), rejected=())
    solver = Solver(problem, replace(loaded, derivation=Derivation(tuple(entries))))
    try:
        solver.solution()
    except NotDerivable:
        return True
    return any(any(_unmet(entry, solver.known)) for entry in entries if isinstance(entry, Asserted))


def _unmet(claim: Asserted, known: Known) -> Iterator[str]:
    """What is wrong with a claim, in sentences."""
    return _unconfirmed(known, claim) if isinstance(claim, Confirm) else unfulfilled(claim, known)


def _exchanged(laws: tuple[Law, ...], index: int, other: Law) -> tuple[Law, ...]:
    return (*laws[:index], other, *laws[index + 1 :])


def _with_a_sign_changed(law: Law) -> Iterator[Law]:
    """The law with the sign of one term on its right changed, for each of them; of one on its left where the right is nothing."""
    left, right = law.textbook.left, law.textbook.right
    side = left if right == Number(Fraction(0)) else right
    terms = side.terms if isinstance(side, Sum) else (side,)
    for place, term in enumerate(terms):
        turned = term.term if isinstance(term, Negative) else Negative(term)
        changed = Sum((*terms[:place], turned, *terms[place + 1 :])) if len(terms) > 1 else turned
        if term != Number(Fraction(0)) and len(terms) + (side is right) > 1:
            yield replace(
                law, textbook=Relation("=", changed, right) if side is left else Relation("=", left, changed)
            )


def _vanishes(residual: sympy.Expr, law: Law, known: Known) -> bool:
    """By algebra; where functions stood in the law, else at the sample points."""
    if is_differential(sides(law)):
        return holds(put_back(residual, ()), known, letters_in([law], known))
    return vanishes(residual)
