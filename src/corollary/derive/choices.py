"""A choice solved: each option's condition in givens."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.known import Known
from corollary.derive.solution import SolvedChoice
from corollary.derive.statements import Choice
from corollary.formula.ast import Relation
from corollary.formula.from_sympy import relation
from corollary.problem.part import Part


def solved_choice(entry: Choice[Boolean | bool], part: Part, known: Known) -> SolvedChoice:
    """Raises ValueError where the options are not those of the part."""
    letters = {option.letter for option in part.options}
    if letters != entry.options.keys():  # pyright: ignore[reportUnnecessaryComparison]
        raise ValueError(
            f"its options are {', '.join(sorted(letters))}; give each of them, and no other, its condition"
        )
    options: dict[str, Relation | bool] = {}
    for letter, condition in entry.options.items():
        holds = known.with_asides(sympy.sympify(condition))
        if strange := holds.free_symbols - known.givens:
            raise ValueError(
                f"option {letter}: {', '.join(sorted(map(str, strange)))} is neither given nor found before by a formula"
            )
        options[letter] = bool(holds) if holds in (sympy.true, sympy.false) else relation(holds)
    return Choice(entry.statement, options, entry.mistakes)
