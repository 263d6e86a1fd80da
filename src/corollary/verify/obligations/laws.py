"""Claims that laws hold identically for what was found: settled by whoever puts the laws back."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.solution import Solution
from corollary.formula.operators import has_operators
from corollary.verify.obligations.obligation import Settled


def laws_hold(solution: Solution, file: str, complaints: list[str]) -> Iterator[Settled]:
    """One claim for each step, where `complaints` say which laws of `file` do not vanish when all that was found is put in."""
    for each in [each.solution for each in solution.regimes] or [solution]:
        for find in each.unknowns:
            if not find.laws:
                continue
            claim, line = f"the laws of {', '.join(find.names)} hold for what is found", find.statement.line
            if any(sentence.startswith(f"{file}:{line}:") for sentence in complaints):
                yield Settled("laws hold", claim, line, "counter-example", "algebra")
            elif find.in_givens is None:
                yield Settled("laws hold", claim, line, "sampled", "it rests on a simulation")
            elif any(has_operators(relation) for law in find.laws for relation in law.here):
                yield Settled("laws hold", claim, line, "sampled", "a differential equation, tried at points")
            else:
                yield Settled("laws hold", claim, line, "proven", "algebra")
