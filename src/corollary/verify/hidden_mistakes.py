"""Mistakes that change no part for any numbers, and so can neither be recognised nor kept from being dealt."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.solution import Rule, Solution
from corollary.derive.statements import Mistake
from corollary.formula.ast import Relation
from corollary.formula.ball import Undefined
from corollary.grading.assign import hidden_mistakes, numbers_tried
from corollary.grading.replay import WhatIf, replay
from corollary.problem.bank import Bank
from corollary.verify.checked import Tally
from corollary.verify.obligations.algebra import Algebra
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.claims import mistaken

SAME = 1e-9  # relative: doubles of one value by two ways


def check_hidden_mistakes(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Complain of mistakes that are the truth or have no value; note those that leave every answer as it is."""
    file = bank.solution(solution.problem).name
    every = [each.solution for each in solution.regimes] or [solution]
    met: set[tuple[int, str]] = set()
    for one in every:
        for place, mistake, parts in hidden_mistakes(one):
            if (mistake.line, mistake.text) in met:
                continue
            met.add((mistake.line, mistake.text))
            is_fault, why = _reason(one, place, mistake, parts)
            (tally.complain if is_fault else tally.note)(
                f"{file}:{mistake.line}: the mistake {mistake.text!r} {why}"
            )


def _reason(solution: Solution, place: int, mistake: Mistake[Rule], parts: list[str]) -> tuple[bool, str]:
    """Whether it is a fault, and why the mistake is never met."""
    names = ", ".join(solution.unknowns[place].names)
    if not parts:
        return False, f"is never met: no part is made of {names}; ask for it, or leave the mistake out"
    outcomes = list(_outcomes(solution, place, mistake))
    tried = f"all {len(outcomes)} numbers tried" if len(outcomes) > 1 else "the printed numbers"
    if "differs" not in outcomes and "same" not in outcomes:
        return True, f"has no value for {tried}: correct its law, or leave it out"
    if "differs" not in outcomes:
        how = "for all numbers, by algebra" if _identical(solution, place, mistake, place) else f"for {tried}"
        return True, f"gives the same {names} as the step itself {how}: correct its law, or leave it out"
    every = len(parts) > 1
    asked = f"part{'s' * every} {', '.join(parts)}"
    proven = all(
        _identical(solution, place, mistake, at)
        for at, find in enumerate(solution.unknowns)
        if find.part in parts
    )
    how = "for all numbers, by algebra" if proven else f"for {tried}"
    return False, (
        f"changes {names}, and leaves {asked} as {'they are' if every else 'it is'} {how}: "
        "nobody is told of it, and no numbers are drawn again for it"
    )


def _outcomes(solution: Solution, place: int, mistake: Mistake[Rule]) -> Iterator[str]:
    """For each of the numbers tried: `same`, `differs`, or `undefined` where the mistake has no value."""
    for givens in numbers_tried(solution):
        try:
            truth = replay(solution, givens, until=place)[place]
        except Undefined:
            continue
        try:
            other = replay(solution, givens, WhatIf(rules={place: mistake.rule}), place)[place]
        except Undefined:
            yield "undefined"
            continue
        alike = all(
            abs(mine - theirs) <= SAME * max(abs(mine), abs(theirs))
            for mine, theirs in zip(other, truth, strict=True)
        )
        yield "same" if alike else "differs"


def _identical(solution: Solution, place: int, mistake: Mistake[Rule], at: int) -> bool:
    """True if algebra shows that the find at `at` is the same with the mistake as without."""
    wrong, truth = mistaken(solution, place, mistake.rule, at), solution.unknowns[at].in_givens
    if wrong is None or truth is None:
        return False
    need = [Relation("=", mine, theirs) for mine, theirs in zip(wrong, truth, strict=True)]
    try:
        algebra = Algebra(Box(solution.problem, solution.conditions), need)
    except ValueError:
        return False
    return all(map(algebra.holds, need))
